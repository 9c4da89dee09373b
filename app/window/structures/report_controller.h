// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/background/task.h"
#include "app/report/report.h"
#include "app/window/scan/shared_state.h"
#include "app/window/sessions/recordings.h"
#include "app/window/structures/structures_controller.h"
#include "ui/window/loading.h"
#include "ui/window/messages.h"

namespace ui {
class ReportMoments;
}

namespace app {

/// Reports what a recorded session had to do with the structures on view: a page for the browser,
/// and a list of its moments. The page has no name of a file, nor one of a structure that is not
/// the user's own; the list, which is on the screen alone, has all.
class ReportController : public QObject {
  Q_OBJECT
 public:
  ReportController(ui::Messages& messages, ui::Loading& loading, SharedState& shared,
                   const Recordings& recordings, const StructuresController& structures);

  /// Asks for a file, and writes the report of the recording with this name.
  void reportRecording(const QString& id);
  /// The same without a question.
  void reportTo(const QString& id, const std::filesystem::path& out);

 signals:
  /// A page was written, for the browser.
  void pageWanted(const QString& path);
  /// The user wants to see a moment of this recording [s].
  void momentWanted(const std::filesystem::path& recording, double time);
  /// A report was written, or was not: why.
  void finished(bool well, const QString& why);

 private:
  struct Made {
    std::vector<report::Structure> structures;
    report::Session session;
  };
  void showMoments(const std::filesystem::path& recording, const Made& made);

  ui::Messages& messages_;
  ui::Loading& loading_;
  SharedState& shared_;
  const Recordings& recordings_;
  const StructuresController& structures_;
  background::Task<Made> task_;
  QPointer<ui::ReportMoments> moments_;
};

}  // namespace app
