// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/background/task.h"
#include "app/recording/recorder.h"
#include "app/window/scan/volume_identity.h"
#include "app/window/sessions/recordings.h"
#include "haptics/session.h"
#include "ui/panels/recording_panel.h"

namespace app {

/// Records the session: every tick between start() and stop(), and the events passed to note(). GUI
/// thread. Only start(), for a moment, and end() wait for the disk.
class SessionRecording : public QObject {
  Q_OBJECT
 public:
  SessionRecording(haptics::Session& session, const Recordings& recordings,
                   VolumeIdentity& identity, QObject* parent = nullptr);
  ~SessionRecording() override;

  /// Begins a recording. `scene` is the session's scene. `states`: what the recording states
  /// besides; which scan it is, of the scan that is on view now.
  haptics::Expected<void> start(std::shared_ptr<const haptics::Scene> scene,
                                const std::string& tool, ui::RecordingStates states = {});
  /// Ends the recording of ticks. Another thread finishes the file.
  void stop();
  /// Ends the recording and waits until the file is complete, with its hash. The session must have
  /// been closed.
  void end();

  bool isRecording() const { return recorder_ != nullptr && !stopping_; }
  /// Path of the file that is being written (NAME.part); empty: none.
  std::filesystem::path present() const;

  /// Describes a new scene, before the session adopts it. `tool`: its name, empty for a tool from a
  /// file.
  void describe(std::shared_ptr<const haptics::Scene> scene, const std::string& tool);
  void note(const char* kind, const QString& text, std::optional<double> value = {});
  /// Called at display rate: updates the status, and finishes a stopped recording.
  void refresh();

 signals:
  void statusChanged(const ui::RecordingStatus& status);
  /// A file was finished, or finishing failed. `what`: a sentence.
  void finished(bool well, const QString& what);

 private:
  void showStatus(ui::RecordingStatus::State state);
  void finish();
  void identify(const std::shared_ptr<const haptics::Volume>& volume);

  haptics::Session& session_;
  const Recordings& recordings_;
  VolumeIdentity& identity_;
  std::shared_ptr<Recorder> recorder_;
  std::filesystem::path target_;
  /// Scenes whose volume hash is not known yet.
  std::vector<std::shared_ptr<const haptics::Scene>> scenes_;
  bool stopping_ = false;  ///< stop() was called; the servo thread may still use the ring
  QElapsedTimer clock_, shown_;
  double elapsed_ = 0.0;                              ///< s, length when it was stopped
  background::Task<std::string> hasher_;              ///< makes the open hash
  background::Task<std::filesystem::path> finisher_;  ///< finishes a file
};

}  // namespace app
