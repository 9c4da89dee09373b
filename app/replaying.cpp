// SPDX-License-Identifier: BSD-3-Clause
// What the application does about recordings: the panel, the bar, and the replay between them.
#include <QFileInfo>

#include "app/application.h"
#include "resources/named_tools.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/panels/recording_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/volume_view.h"

namespace app {

namespace {

/// What a recording says of a tool: the name of one of ours, or nothing.
std::string recordedName(const ToolSource& tool) { return tool.file ? std::string{} : tool.name; }

}  // namespace

void Application::connectRecording() {
  ui::RecordingPanel& panel = window_.recordingPanel();
  connect(&panel, &ui::RecordingPanel::recordWanted, this, &Application::record);
  connect(&panel, &ui::RecordingPanel::markWanted, this,
          [this](const QString& note) { recording_.note("mark", note); });
  connect(&panel, &ui::RecordingPanel::openWanted, this,
          [this](const QString& id) { openRecording(recordings_.pathOf(id)); });
  connect(&panel, &ui::RecordingPanel::recoverWanted, this, &Application::recoverRecording);
  connect(&panel, &ui::RecordingPanel::deleteWanted, this, &Application::deleteRecording);
  connect(&window_, &ui::MainWindow::recordingWanted, this,
          [this](const QString& path) { openRecording(path.toStdString()); });
  connect(&recording_, &SessionRecording::statusChanged, &panel,
          qOverload<const ui::RecordingStatus&>(&ui::RecordingPanel::show));
  connect(&recording_, &SessionRecording::finished, this, [this](bool well, const QString& what) {
    showRecordings();
    if (!well) window_.showMessage(what);
  });
  ui::ReplayBar& bar = window_.replayBar();
  connect(&bar, &ui::ReplayBar::playWanted, this, [this](bool play) {
    if (replay_) replay_->play(play);
  });
  connect(&bar, &ui::ReplayBar::timeWanted, this, [this](double time) {
    if (replay_) replay_->seek(time);
  });
  connect(&bar, &ui::ReplayBar::stepWanted, this, [this](int ticks) {
    if (replay_) replay_->stepBy(ticks);
  });
  connect(&bar, &ui::ReplayBar::speedChosen, this, [this](double factor) {
    if (replay_) replay_->setSpeed(factor);
  });
  connect(&bar, &ui::ReplayBar::closeWanted, this, &Application::closeReplay);
  connect(&identity_, &VolumeIdentity::sought, this, [this] { compareVolumes(); });
  showRecordings();
}

void Application::showRecordings() {
  const QList<ui::PastRecording> recordings = recordings_.list(recording_.present());
  window_.recordingPanel().show(recordings);
}

void Application::offerRecovery() {
  for (const ui::PastRecording& recording : recordings_.list(recording_.present()))
    if (!recording.finished)
      return window_.showMessage(
          tr("The recording \"%1\" was never finished. View > Recording lists it: Recover brings "
             "back what is in it.")
              .arg(recording.name));
}

void Application::record(bool record) {
  if (!record) return recording_.stop();
  if (!shown_) return;
  if (replay_) closeReplay();
  const auto begun = recording_.start(shown_->scene, recordedName(shown_->tool));
  if (!begun) {
    window_.recordingPanel().show(ui::RecordingStatus{});
    return window_.showMessage(QString::fromStdString(begun.error().what));
  }
  recording_.note("hand", QString::fromStdString(hand_));
  camera_noted_.clear();
  showRecordings();
}

/// Where the user looks from belongs to the session: a film can show what was seen.
void Application::noteCamera() {
  constexpr int kLeastMs = 100;
  if (!recording_.isRecording()) return;
  if (!camera_noted_.empty() && since_camera_.elapsed() < kLeastMs) return;
  const std::string camera = wordsOf(cameraNow());
  if (camera == camera_noted_) return;
  recording_.note("camera", QString::fromStdString(camera));
  camera_noted_ = camera;
  since_camera_.start();
}

void Application::deleteRecording(const QString& id) {
  const std::filesystem::path path = recordings_.pathOf(id);
  if (replay_ && replay_->path() == path) closeReplay();
  if (path.extension() == ".part" && haptics::isInUse(path))
    return window_.showMessage(tr("Another window is writing this recording; stop it there."));
  std::error_code error;
  std::filesystem::remove(path, error);
  // what an unfinished one has beside it
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    std::error_code ignored;
    std::filesystem::remove(path.string() + ending, ignored);
  }
  if (error)
    window_.showMessage(
        tr("The recording could not be deleted; check the permissions of its folder."));
  showRecordings();
}

void Application::recoverRecording(const QString& id) {
  if (recoverer_.isRunning()) return;
  recoverer_.start(
      [path = recordings_.pathOf(id)](const background::Watch&) { return haptics::recover(path); },
      [this](const haptics::Expected<std::filesystem::path>& recovered) {
        if (recovered)
          window_.clearMessage();
        else
          window_.showMessage(QString::fromStdString(recovered.error().what));
        showRecordings();
      });
}

void Application::openRecording(const std::filesystem::path& path) {
  auto opened = Replay::open(path);
  if (!opened) return window_.showMessage(QString::fromStdString(opened.error().what));
  recording_.stop();
  endMeasuring(tr("The measurement was cancelled: a recording is being replayed."));
  // the hand lets go: what is seen is what was
  session_.close();
  forgetDevice(tr("A recording was opened: the device was disconnected."));
  replay_ = std::move(*opened);
  replayed_scene_.reset();
  connect(replay_.get(), &Replay::moved, this, &Application::showReplayed);
  connect(replay_.get(), &Replay::playing, &window_.replayBar(), &ui::ReplayBar::setPlaying);
  connect(replay_.get(), &Replay::failed, &window_, &ui::MainWindow::showMessage);
  connect(replay_.get(), &Replay::trackRead, this, [this] {
    window_.replayBar().timeline().show(replay_->track());
    window_.replayBar().setTime(replayed_to_);
  });
  window_.clearMessage();
  window_.recordingPanel().setReady(false);
  window_.view().setMouseHand(false);
  window_.replayBar().show(replay_->track());
  window_.replayBar().show();
  replay_->setSpeed(window_.replayBar().speed());
  window_.clearForces();
  if (shown_) identity_.seek(shown_->picture.volume);
  replay_->seek(replay_->track().begin);
}

void Application::closeReplay() {
  if (!replay_) return;
  replay_.reset();
  window_.replayBar().hide();
  window_.clearForces();
  window_.recordingPanel().setReady(shown_.has_value());
  if (!shown_) return;
  // as it was before
  window_.show(shown_->scene->tool.mesh);
  window_.isosurfacePanel().show(shown_->picture, settings_.isovalue);
  window_.view().setIsovalue(settings_.isovalue);
  openHand(hand_);
}

/// Whether the volume on view is the one that was touched, as far as can be told.
void Application::compareVolumes() {
  if (!replay_ || !shown_) return;
  const haptics::RecordedScene* then = replay_->recording().scene(replay_->step().step.scene);
  same_volume_ = then != nullptr && haptics::liesLike(then->volume, *shown_->picture.volume);
  if (same_volume_)
    same_volume_ = haptics::compared(then->hash, identity_.of(shown_->picture.volume)) !=
                   haptics::SameVolume::Another;
  QString warning;
  if (then != nullptr && !same_volume_)
    warning = tr("The volume on view is not the one that was touched; open that one to see it.");
  window_.replayBar().showWarning(warning);
}

void Application::showReplayed(double time) {
  if (!replay_ || !shown_) return;
  const haptics::Step& step = replay_->step().step;
  if (replayed_scene_ != step.scene) {
    replayed_scene_ = step.scene;
    if (const haptics::RecordedScene* scene = replay_->recording().scene(step.scene))
      window_.show(scene->tool.mesh);
    compareVolumes();
    replayed_isovalue_.reset();
  }
  if (same_volume_ && replayed_isovalue_ != step.settings.isovalue) {
    replayed_isovalue_ = step.settings.isovalue;
    window_.isosurfacePanel().show(shown_->picture, step.settings.isovalue);
    window_.view().setIsovalue(step.settings.isovalue);
  }
  haptics::Snapshot snapshot;
  snapshot.tick = step.sequence;
  snapshot.time = static_cast<double>(step.time_ns) * 1e-9;
  snapshot.X_WD = step.X_WD;
  snapshot.X_WP = step.X_WP;
  snapshot.felt_W = snapshot.coupling_W = step.sent_W;
  snapshot.isovalue = step.settings.isovalue;
  snapshot.scene = shown_->scene->id;
  snapshot.contacts = static_cast<int>(step.contacts.size());
  snapshot.force_state = step.force_state;
  snapshot.late_ticks = step.late_ticks;
  snapshot.missed_ticks = step.missed_ticks;
  window_.display(snapshot);
  // the plot goes on where it was, or begins anew after a jump
  const bool goes_on = time >= replayed_to_ && time < replayed_to_ + ui::ForcePlot::kSeconds;
  if (!goes_on) window_.clearForces();
  window_.appendForces(
      replay_->forces(goes_on ? replayed_to_ : time - ui::ForcePlot::kSeconds, time));
  replayed_to_ = time;
  window_.replayBar().setTime(time);
}

}  // namespace app
