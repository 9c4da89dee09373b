// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/program/log_controller.h"

#include <utility>

#include "app/log/log.h"
#include "ui/dialogs/text_window.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

using log::Level;

constexpr std::size_t kLinesShown = 5'000;

log::Name nameOf(const QString& text) { return log::nameOfProgram(text.toStdString()); }

}  // namespace

LogController::LogController(ui::Views& views, ui::Messages& messages, ui::Menus& menus,
                             SharedState& shared, std::filesystem::path folder)
    : messages_(messages), shared_(shared), folder_(std::move(folder)) {
  connect(&menus, &ui::Menus::logWanted, this, &LogController::show);
  connect(&views.volume(), &ui::Viewport::graphicsKnown, this, [](const ui::Graphics& graphics) {
    log::write(Level::Info, "graphics",
               {{"opengl_major", graphics.major},
                {"opengl_minor", graphics.minor},
                {"renderer", log::nameOfMachine(graphics.renderer.toStdString())}});
  });
}

void LogController::noteScene(bool new_volume) {
  if (!new_volume || !shared_.shown) return;
  const haptics::Volume& volume = *shared_.shown->volume();
  const auto& dims = volume.grid.dims;
  const haptics::Vec3 spacing_mm = volume.grid.spacing * 1e3;
  const qint64 took = since_loading_.isValid() ? since_loading_.elapsed() : 0;
  log::write(Level::Info, "scan-opened",
             {{"from", shared_.shown->place.empty() ? log::nameOfProgram("phantom")
                                                    : log::nameOfProgram("file")},
              {"columns", dims[0]},
              {"rows", dims[1]},
              {"slices", dims[2]},
              {"x_mm", spacing_mm.x()},
              {"y_mm", spacing_mm.y()},
              {"z_mm", spacing_mm.z()},
              {"type", log::nameOfProgram(haptics::nameOf(volume.type))},
              {"resampled", volume.resampled},
              {"slices_left_out", volume.slices_left_out},
              {"took_ms", took}});
}

void LogController::noteRefusal(const haptics::Error& error) {
  if (error.kind == haptics::Error::Kind::Cancelled) return log::write(Level::Info, "cancelled");
  log::write(Level::Warning, "not-opened",
             {{"id", log::nameOf(error)}, {"reason", log::nameOfProgram(error.reason)}});
}

void LogController::noteHand(const QString& id) {
  // what follows tells one device from others of its kind
  log::write(Level::Info, "hand", {{"kind", nameOf(id.section(':', 0, 0))}});
}

void LogController::noteForce(const QString& transition) {
  const QString to = transition.section(QStringLiteral(" -> "), 1).section(',', 0, 0),
                reason = transition.section(QStringLiteral(", "), 1);
  log::write(to == QLatin1String("fault") ? Level::Warning : Level::Info, "force",
             {{"to", nameOf(to)}, {"reason", nameOf(reason)}});
}

void LogController::noteRecorded(bool well) {
  log::write(well ? Level::Info : Level::Error, "recording-ended",
             {{"whole", well}, {"steps", recording_.samples}, {"lost", recording_.gaps}});
}

void LogController::noteServo() {
  const haptics::Snapshot& last = shared_.snapshot;
  if (last.tick == 0) return;
  log::write(Level::Info, "servo",
             {{"ticks", static_cast<qint64>(last.tick)},
              {"late", static_cast<qint64>(last.late_ticks)},
              {"missed", static_cast<qint64>(last.missed_ticks)},
              {"tick_p99_us", last.tick_p99 * 1e6},
              {"real_time", last.policy == haptics::SchedulingPolicy::RealTime}});
}

void LogController::show() {
  QString text;
  for (const std::string& line : log::lines(folder_, kLinesShown))
    text += QString::fromStdString(line) + '\n';
  if (text.isEmpty())
    return messages_.showMessage(
        tr("There is no log: it was switched off, or Palpate's own folder for it cannot be "
           "written; start palpate with --log-level info."));
  auto* shown =
      new ui::TextWindow("log", tr("Log"),
                         tr("A log of Palpate's actions. It contains no names of patients, files "
                            "or servers, and stays on this machine unless you copy it."),
                         text, messages_.window());
  shown->show();
}

}  // namespace app
