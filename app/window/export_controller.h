// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>

#include "app/window/export_task.h"
#include "app/window/recordings.h"
#include "app/window/shared_state.h"
#include "app/window/volume_identity.h"
#include "ui/main_window.h"

namespace app {

/// Asks for format and range of an export, and exports a recording.
class ExportController : public QObject {
  Q_OBJECT
 public:
  ExportController(ui::MainWindow& window, SharedState& shared, const Recordings& recordings,
                   const VolumeIdentity& identity);

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
  };
  void askAndExport(const Exported& recording);

  ui::MainWindow& window_;
  SharedState& shared_;
  const Recordings& recordings_;
  const VolumeIdentity& identity_;
  ExportTask task_;
  background::Task<Exported> opener_;
  QString folder_;  ///< of the present or last export
};

}  // namespace app
