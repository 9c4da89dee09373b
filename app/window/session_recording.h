// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>

#include "app/background/task.h"
#include "app/window/recordings.h"
#include "app/window/volume_identity.h"
#include "haptics/recording/recorder.h"
#include "haptics/session.h"
#include "ui/panels/recording_panel.h"

namespace app {

/// Records the session that is under way: between start() and stop() every tick, and what is told
/// here. GUI thread; only start() waits for the disk, for a moment, and end().
class SessionRecording : public QObject {
  Q_OBJECT
 public:
  SessionRecording(haptics::Session& session, const Recordings& recordings,
                   VolumeIdentity& identity, QObject* parent = nullptr);
  ~SessionRecording() override;

  /// Begins a file and has it filled; the scene is the one being touched.
  haptics::Expected<void> start(std::shared_ptr<const haptics::Scene> scene,
                                const std::string& tool);
  /// No more ticks; the file is finished behind the window.
  void stop();
  /// The same, waiting until it is whole: the session must have been closed.
  void end();

  bool isRecording() const { return recorder_ != nullptr && !stopping_; }
  /// The file that is being written, under the name it has meanwhile; empty: none.
  std::filesystem::path present() const;

  /// Another scene, before the session adopts it. `tool`: its name, empty for a file's.
  void describe(std::shared_ptr<const haptics::Scene> scene, const std::string& tool);
  void note(const char* kind, const QString& text);
  /// Called at display rate: looks after what is under way.
  void refresh();

 signals:
  void statusChanged(const ui::RecordingStatus& status);
  /// A file was finished, or could not be; `what` is a sentence.
  void finished(bool well, const QString& what);

 private:
  void showStatus(ui::RecordingStatus::State state);
  void finish();
  void identify(const std::shared_ptr<const haptics::Volume>& volume);

  haptics::Session& session_;
  const Recordings& recordings_;
  VolumeIdentity& identity_;
  std::shared_ptr<haptics::Recorder> recorder_;
  std::filesystem::path target_;
  std::vector<std::shared_ptr<const haptics::Scene>> scenes_;  ///< whose hash is not known yet
  bool stopping_ = false;  ///< the servo thread may yet be in the ring
  QElapsedTimer clock_, shown_;
  double elapsed_ = 0.0;                              ///< s, when it was stopped
  background::Task<std::filesystem::path> finisher_;  ///< brings a file to its end
};

}  // namespace app
