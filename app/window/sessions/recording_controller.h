// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QHash>
#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/background/task.h"
#include "app/window/scan/shared_state.h"
#include "app/window/sessions/force_curve.h"
#include "app/window/sessions/recordings.h"
#include "app/window/sessions/session_recording.h"
#include "ui/panels/recording_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/top_bar.h"
#include "ui/window/views.h"

namespace app {

/// Runs the panel "Recording": begins and ends recordings, lists, recovers and deletes them.
class RecordingController : public QObject {
  Q_OBJECT
 public:
  /// `folder`: of the recordings.
  RecordingController(ui::MainWindow& window, SharedState& shared, std::filesystem::path folder);

  SessionRecording& recording() { return recording_; }
  const Recordings& recordings() const { return recordings_; }
  /// Sets what calls its argument, with which a recording begins, when nothing is cut in the scene.
  void setUncut(std::function<void(std::function<void()>)> uncut) { uncut_ = std::move(uncut); }
  /// Gives the names of scans by their hashes; the list then has them.
  void setScans(std::function<QHash<QString, QString>()> scans);
  /// Recordings are in another folder from now on.
  void setFolder(std::filesystem::path folder);
  /// Describes a new scene to the recording, before the session adopts it.
  void describeScene();
  void note(const char* kind, const QString& text, std::optional<double> value = {}) {
    recording_.note(kind, text, value);
  }
  /// Sets whether a recording may begin.
  void setReady(bool ready);
  /// Lists what is in the folder now, in the background, and then calls `then`.
  void showRecordings(std::function<void()> then = {});
  /// Called at display rate.
  void refresh();
  /// Offers to recover a recording that an ended process left unfinished.
  void offerRecovery();

 signals:
  /// A recording is about to begin; a recording on view is closed.
  void starting();
  void started();
  void openWanted(const std::filesystem::path& path);
  void exportWanted(const QString& id);
  void reportWanted(const QString& id);
  /// The file is about to be deleted; readers must close it.
  void deleting(const std::filesystem::path& path);

 private:
  QHash<QString, QString> scans();
  void record(bool record);
  void begin();
  void readCurves();
  void noteCamera();
  void deleteRecording(const QString& id);
  void recover(const QString& id);

  ui::Views& views_;
  ui::Messages& messages_;
  ui::SidePanel& panels_;
  SharedState& shared_;
  Recordings recordings_;
  ui::RecordingPanel* panel_;  ///< the window's
  SessionRecording recording_;
  background::Task<std::filesystem::path> recoverer_;
  enum class Deletion { Done, InUse, Failed };
  background::Task<Deletion> deleter_;
  background::Task<QList<ui::PastRecording>> lister_;
  std::vector<std::function<void()>> after_list_;  ///< what waits for the list
  std::function<QHash<QString, QString>()> scans_;
  std::function<void(std::function<void()>)> uncut_;
  std::optional<VolumeHash> on_view_;  ///< of the scan on view when the list was made
  ForceCurves curves_;
  QList<QString> finished_;     ///< ids of the recordings in the list that have a curve
  QString unfinished_;          ///< name of the newest in the list that was not finished
  std::string camera_noted_;    ///< text of the last recorded camera
  QElapsedTimer since_camera_;  ///< time since the last recorded camera
};

}  // namespace app
