// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/recording_controller.h"

#include <optional>
#include <system_error>

#include "app/window/sentence.h"
#include "app/window/view_camera.h"

namespace app {
namespace {

constexpr int kLeastCameraMs = 100;

/// What a recording says of a tool: the name of one of ours, or nothing.
std::string recordedName(const ToolSource& tool) { return tool.file ? std::string{} : tool.name; }

}  // namespace

RecordingController::RecordingController(ui::MainWindow& window, SharedState& shared,
                                         const Recordings& recordings, VolumeIdentity& identity)
    : window_(window),
      shared_(shared),
      recordings_(recordings),
      panel_(new ui::RecordingPanel),
      recording_(shared.session, recordings, identity) {
  window.addPanel(panel_, tr("Recording"), tr("Recor&ding"), "recordingSection", ui::Tab::Record);
  window.addAction(panel_->markAction());  // of the window: the panel may be out of sight
  connect(panel_, &ui::RecordingPanel::recordWanted, this, &RecordingController::record);
  connect(panel_, &ui::RecordingPanel::markWanted, this,
          [this](const QString& note) { recording_.note("mark", note); });
  connect(panel_, &ui::RecordingPanel::openWanted, this,
          [this](const QString& id) { emit openWanted(recordings_.pathOf(id)); });
  connect(panel_, &ui::RecordingPanel::recoverWanted, this, &RecordingController::recover);
  connect(panel_, &ui::RecordingPanel::deleteWanted, this, &RecordingController::deleteRecording);
  connect(panel_, &ui::RecordingPanel::exportWanted, this, &RecordingController::exportWanted);
  connect(panel_, &ui::RecordingPanel::labelChanged, this,
          [this](const QString& id, const QString& label) {
            if (!recordings_.setLabel(id, label))
              window_.showMessage(
                  tr("The label was not kept: Palpate's own folder cannot be written; check its "
                     "permissions and the room on its disk."));
          });
  connect(panel_, &ui::RecordingPanel::seen, this, &RecordingController::readCurves);
  connect(&curves_, &ForceCurves::read, panel_, &ui::RecordingPanel::showCurve);
  connect(&window, &ui::MainWindow::recordingWanted, this,
          [this](const QString& path) { emit openWanted(path.toStdString()); });
  connect(&window, &ui::MainWindow::exportWanted, this, [this] {
    if (panel_->exportChosen()) return;
    window_.reveal(panel_);
    window_.showMessage(
        tr("Choose a recording in the list on the tab Record; then it can be exported."));
  });
  connect(&recording_, &SessionRecording::statusChanged, panel_,
          qOverload<const ui::RecordingStatus&>(&ui::RecordingPanel::show));
  connect(&recording_, &SessionRecording::statusChanged, &window,
          [&window](const ui::RecordingStatus& status) {
            using State = ui::RecordingStatus::State;
            window.showRecording(status.state == State::Recording ? std::optional{status.elapsed}
                                                                  : std::nullopt);
          });
  connect(&recording_, &SessionRecording::finished, this, [this](bool well, const QString& what) {
    showRecordings();
    // the newest stands first
    if (!finished_.isEmpty()) panel_->choose(finished_.front());
    if (!well) window_.showMessage(what);
  });
  showRecordings();
}

void RecordingController::describeScene() {
  recording_.describe(shared_.shown->scene, recordedName(shared_.shown->tool));
}

void RecordingController::setReady(bool ready) { panel_->setReady(ready); }

void RecordingController::refresh() {
  recording_.refresh();
  noteCamera();
}

void RecordingController::showRecordings() {
  QList<ui::PastRecording> recordings = recordings_.list(recording_.present());
  for (ui::PastRecording& recording : recordings) recording.curve = curves_.of(recording.id);
  panel_->show(recordings);
  finished_.clear();
  for (const ui::PastRecording& recording : recordings)
    if (recording.finished) finished_ << recording.id;
  if (panel_->isVisible()) readCurves();
}

void RecordingController::readCurves() { curves_.want(recordings_.folder(), finished_); }

void RecordingController::offerRecovery() {
  for (const ui::PastRecording& recording : recordings_.list(recording_.present()))
    if (!recording.finished)
      return window_.showMessage(
          tr("The recording \"%1\" was never finished. View > Recording lists it: Recover brings "
             "back what is in it.")
              .arg(recording.name));
}

void RecordingController::record(bool record) {
  if (!record) return recording_.stop();
  if (!shared_.shown) return;
  emit starting();
  const auto begun = recording_.start(shared_.shown->scene, recordedName(shared_.shown->tool));
  if (!begun) {
    panel_->show(ui::RecordingStatus{});
    return window_.showMessage(sentenceOf(begun.error()));
  }
  emit started();
  camera_noted_.clear();
  showRecordings();
}

/// Where the user looks from belongs to the session: a film can show what was seen.
void RecordingController::noteCamera() {
  if (!recording_.isRecording()) return;
  if (!camera_noted_.empty() && since_camera_.elapsed() < kLeastCameraMs) return;
  const std::string camera = wordsOf(cameraOf(window_.view()));
  if (camera == camera_noted_) return;
  recording_.note("camera", QString::fromStdString(camera));
  camera_noted_ = camera;
  since_camera_.start();
}

void RecordingController::deleteRecording(const QString& id) {
  const std::filesystem::path path = recordings_.pathOf(id);
  emit deleting(path);
  if (path.extension() == ".part" && haptics::isInUse(path))
    return window_.showMessage(tr("Another window is writing this recording; stop it there."));
  std::error_code error;
  std::filesystem::remove(path, error);
  // what an unfinished one has beside it
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    std::error_code ignored;
    std::filesystem::remove(path.string() + ending, ignored);
  }
  if (!error) recordings_.setLabel(id, {});
  if (error)
    window_.showMessage(
        tr("The recording could not be deleted; check the permissions of its folder."));
  showRecordings();
}

void RecordingController::recover(const QString& id) {
  if (recoverer_.isRunning()) return;
  recoverer_.start(
      [path = recordings_.pathOf(id)](const background::Watch&) { return haptics::recover(path); },
      [this](const haptics::Expected<std::filesystem::path>& recovered) {
        if (recovered)
          window_.clearMessage();
        else
          window_.showMessage(sentenceOf(recovered.error()));
        showRecordings();
      });
}

}  // namespace app
