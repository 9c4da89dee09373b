// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>

#include "app/window/scan/shared_state.h"
#include "app/window/sessions/export_task.h"
#include "app/window/sessions/recordings.h"
#include "ui/overlays/measures.h"
#include "ui/window/loading.h"
#include "ui/window/messages.h"
#include "ui/window/views.h"

namespace app {

/// Asks for format and range of an export, and exports a recording.
class ExportController : public QObject {
  Q_OBJECT
 public:
  ExportController(ui::Views& views, ui::Messages& messages, ui::Loading& loading,
                   SharedState& shared, const Recordings& recordings, const ui::Measures& measures);

  /// Asks for the options, and exports the recording with this name.
  void exportRecording(const QString& id);
  /// Exports without a question.
  void exportTo(ExportRequest request);
  ExportTask& task() { return task_; }

 private:
  /// What is asked of a recording before its export.
  struct Exported {
    std::filesystem::path path;
    double begin = 0.0, end = 0.0;  ///< s
    double least_isovalue = 0.0;
    std::vector<RecordedScene> scenes = {};
  };
  void askAndExport(const Exported& recording);
  /// The colours, the second surface and the marks of the 3-D view.

  ui::Views& views_;
  ui::Messages& messages_;
  ui::Loading& loading_;
  SharedState& shared_;
  const Recordings& recordings_;
  const ui::Measures& measures_;
  ExportTask task_;
  background::Task<Exported> opener_;
  QString folder_;  ///< of the present or last export
};

}  // namespace app
