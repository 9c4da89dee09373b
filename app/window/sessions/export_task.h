// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/background/task.h"
#include "app/film/camera.h"
#include "app/film/overlays.h"
#include "app/recording/scene_words.h"
#include "haptics/core/volume.h"
#include "ui/dialogs/export_question.h"

namespace app {

/// The recording to export, its options and its target.
struct ExportRequest {
  std::filesystem::path recording, out;
  ui::ExportWish wish;
  /// Scan on view, before any edit: for a film, and for the voxels that cuts removed. Null: the
  /// film shows only the tool, and the voxels are left out.
  std::shared_ptr<const haptics::Volume> volume = {};
  std::optional<VolumeHash> hash = {};    ///< hash of the volume, if it is known
  std::optional<FilmCamera> camera = {};  ///< camera of a film with a fixed view
  FilmLook look = {};                     ///< what a film has of the view
};

/// Exports on its own thread, one export at a time. Only the destructor waits for it.
class ExportTask : public QObject {
  Q_OBJECT
 public:
  explicit ExportTask(QObject* parent = nullptr);

  /// Returns false and does nothing while another export runs.
  bool start(ExportRequest request);
  void cancel() { task_.cancel(); }
  bool isRunning() const { return task_.isRunning(); }

 signals:
  void progressed(double fraction);
  /// The export ended. `what`: a sentence for the user, empty if the user cancelled.
  void finished(bool well, const QString& what);

 private:
  background::Task<QString> task_;  ///< a sentence about what was written
};

}  // namespace app
