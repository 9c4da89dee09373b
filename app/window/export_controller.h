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

/// Asks what a recording is to become, and exports it.
class ExportController : public QObject {
  Q_OBJECT
 public:
  ExportController(ui::MainWindow& window, SharedState& shared, const Recordings& recordings,
                   const VolumeIdentity& identity);

  /// Asks what the recording with this name is to become.
  void exportRecording(const QString& id);
  /// As the user does who has answered every question.
  void exportTo(ExportRequest request);
  ExportTask& task() { return task_; }

 private:
  ui::MainWindow& window_;
  SharedState& shared_;
  const Recordings& recordings_;
  const VolumeIdentity& identity_;
  ExportTask task_;
};

}  // namespace app
