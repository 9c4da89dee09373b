// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

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
  explicit ExportTask(QObject* parent = nullptr) : QObject(parent) {}
  ~ExportTask() override;

  /// False, and nothing done, while another is under way.
  bool start(ExportRequest request);
  void cancel() { cancel_ = true; }

 signals:
  void progressed(double fraction);
  /// It ended; a sentence for the user, empty where he cancelled it.
  void finished(bool well, const QString& what);

 private:
  void work(const ExportRequest& request);

  std::atomic<bool> cancel_{false};
  bool running_ = false;
  std::thread thread_;
};

}  // namespace app
