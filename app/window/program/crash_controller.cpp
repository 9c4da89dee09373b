// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/program/crash_controller.h"

#include <system_error>
#include <utility>

#include "app/crash/report.h"
#include "app/log/log.h"
#include "ui/dialogs/text_window.h"

namespace app {

CrashController::CrashController(ui::Messages& messages, std::filesystem::path folder)
    : messages_(messages), folder_(std::move(folder)) {}

void CrashController::look() {
  if (folder_.empty()) return;
  task_.start(
      [folder = folder_](const background::Watch& watch) -> haptics::Expected<std::string> {
        background::goLast();
        return crash::takeReport(folder, watch.cancel).value_or(std::string{});
      },
      [this](const haptics::Expected<std::string>& report) {
        if (!report || report->empty()) return;
        log::write(log::Level::Warning, "crash-report");
        messages_.showOffer(tr("Palpate ended unexpectedly last time."), tr("Show report"),
                            [this, text = QString::fromStdString(*report)] { show(text); });
      });
}

void CrashController::show(const QString& report) {
  auto* shown =
      new ui::TextWindow("crashReport", tr("Crash report"),
                         tr("A report of Palpate's last actions. It contains no names of patients, "
                            "files or servers, and stays on this machine unless you copy it."),
                         report, messages_.window());
  shown->offerDelete();
  connect(shown, &ui::TextWindow::deleteWanted, this, [this] {
    std::error_code failed;
    std::filesystem::remove(crash::reportFile(folder_), failed);
  });
  shown->show();
}

}  // namespace app
