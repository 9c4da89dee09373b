// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/background/task.h"
#include "app/film/camera.h"
#include "haptics/core/volume.h"
#include "haptics/recording/scene_words.h"
#include "ui/export_question.h"

namespace app {

/// What is to be exported, and where to.
struct ExportRequest {
  std::filesystem::path recording, out;
  ui::ExportWish wish;
  std::shared_ptr<const haptics::Volume> volume = {};  ///< of a film; null: the tool alone
  std::optional<haptics::VolumeHash> hash = {};        ///< of the volume, if it is known
  std::optional<FilmCamera> camera = {};               ///< of a film whose camera is fixed
};

/// Exports on a thread of its own, one at a time. No call waits for it, except the destructor.
class ExportTask : public QObject {
  Q_OBJECT
 public:
  explicit ExportTask(QObject* parent = nullptr);

  /// False, and nothing done, while another is under way.
  bool start(ExportRequest request);
  void cancel() { task_.cancel(); }

 signals:
  void progressed(double fraction);
  /// It ended; a sentence for the user, empty where he cancelled it.
  void finished(bool well, const QString& what);

 private:
  background::Task<QString> task_;  ///< the name of what was written
};

}  // namespace app
