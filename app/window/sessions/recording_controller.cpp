// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/recording_controller.h"

#include <optional>
#include <system_error>
#include <utility>

#include "app/recording/unfinished.h"
#include "app/view_file/view_file.h"
#include "app/window/scan/sentence.h"
#include "app/window/scan/view_camera.h"

namespace app {
namespace {

constexpr int kLeastCameraMs = 100;

/// What a recording says of a tool: the name of one of ours, or nothing.
std::string recordedName(const ToolSource& tool) { return tool.file ? std::string{} : tool.name; }

}  // namespace

RecordingController::RecordingController(ui::MainWindow& window, SharedState& shared,
                                         std::filesystem::path folder)
    : views_(window.views()),
      messages_(window.messages()),
      panels_(window.panels()),
      shared_(shared),
      recordings_(std::move(folder)),
      panel_(new ui::RecordingPanel),
      recording_(shared.session, recordings_, shared.identity) {
  window.panels().add(panel_, tr("Recording"), tr("Recordin&g"), "recordingSection",
                      ui::Tab::Record);
  window.addAction(panel_->markAction());  // of the window: the panel may be out of sight
  connect(panel_, &ui::RecordingPanel::recordWanted, this, &RecordingController::record);
  connect(panel_, &ui::RecordingPanel::markWanted, this,
          [this](const QString& note) { recording_.note("mark", note); });
  connect(panel_, &ui::RecordingPanel::openWanted, this,
          [this](const QString& id) { emit openWanted(recordings_.pathOf(id)); });
  connect(panel_, &ui::RecordingPanel::recoverWanted, this, &RecordingController::recover);
  connect(panel_, &ui::RecordingPanel::deleteWanted, this, &RecordingController::deleteRecording);
  connect(panel_, &ui::RecordingPanel::exportWanted, this, &RecordingController::exportWanted);
  connect(panel_, &ui::RecordingPanel::reportWanted, this, &RecordingController::reportWanted);
  connect(panel_, &ui::RecordingPanel::labelChanged, this,
          [this](const QString& id, const QString& label) {
            if (!recordings_.setLabel(id, label))
              messages_.showMessage(
                  tr("The label was not kept: Palpate's own folder cannot be written; check its "
                     "permissions and the room on its disk."));
          });
  connect(panel_, &ui::RecordingPanel::seen, this, &RecordingController::readCurves);
  connect(&curves_, &ForceCurves::read, panel_, &ui::RecordingPanel::showCurve);
  connect(&window.menus(), &ui::Menus::recordingWanted, this,
          [this](const QString& path) { emit openWanted(path.toStdString()); });
  connect(&window.menus(), &ui::Menus::exportWanted, this, [this] {
    if (panel_->exportChosen()) return;
    panels_.reveal(panel_);
    messages_.showMessage(
        tr("Choose a recording in the list on the tab Record; then it can be exported."));
  });
  connect(&recording_, &SessionRecording::statusChanged, panel_,
          qOverload<const ui::RecordingStatus&>(&ui::RecordingPanel::show));
  connect(&recording_, &SessionRecording::statusChanged, &window,
          [&window](const ui::RecordingStatus& status) {
            using State = ui::RecordingStatus::State;
            window.bar().showRecording(
                status.state == State::Recording ? std::optional{status.elapsed} : std::nullopt);
          });
  connect(&recording_, &SessionRecording::finished, this, [this](bool well, const QString& what) {
    // the newest stands first
    showRecordings([this] {
      if (!finished_.isEmpty()) panel_->choose(finished_.front());
    });
    if (!well) messages_.showMessage(what);
  });
  connect(&shared.identity, &VolumeIdentity::sought, this, [this] {
    if (!shared_.shown) return;
    const auto hash = shared_.identity.of(shared_.shown->volume());
    if (hash != on_view_) showRecordings();
  });
  showRecordings();
}

void RecordingController::setScans(std::function<QHash<QString, QString>()> scans) {
  scans_ = std::move(scans);
  showRecordings();
}

QHash<QString, QString> RecordingController::scans() {
  QHash<QString, QString> names = scans_ ? scans_() : QHash<QString, QString>{};
  on_view_.reset();
  if (shared_.shown) on_view_ = shared_.identity.of(shared_.shown->volume());
  if (on_view_) names[QString::fromStdString(hexOf(*on_view_))] = shared_.shown->title;
  return names;
}

void RecordingController::describeScene() {
  recording_.describe(shared_.shown->scene, recordedName(shared_.shown->tool));
}

void RecordingController::setReady(bool ready) { panel_->setReady(ready); }

void RecordingController::refresh() {
  recording_.refresh();
  noteCamera();
}

void RecordingController::showRecordings(std::function<void()> then) {
  if (then) after_list_.push_back(std::move(then));
  lister_.start(
      [recordings = recordings_, present = recording_.present(), scans = scans()](
          const background::Watch& watch) -> haptics::Expected<QList<ui::PastRecording>> {
        return recordings.list(present, watch.cancel, scans);
      },
      [this](haptics::Expected<QList<ui::PastRecording>> recordings) {
        finished_.clear();
        unfinished_.clear();
        if (!recordings) recordings.emplace();  // no thread, no memory: an empty list
        for (ui::PastRecording& recording : *recordings) {
          recording.curve = curves_.of(recording.id);
          if (recording.finished)
            finished_ << recording.id;
          else if (unfinished_.isEmpty())
            unfinished_ = recording.name;
        }
        panel_->show(*recordings);
        if (panel_->isVisible()) readCurves();
        for (const auto& waiting : std::exchange(after_list_, {})) waiting();
      });
}

void RecordingController::setFolder(std::filesystem::path folder) {
  recordings_.setFolder(std::move(folder));
  showRecordings();
}

void RecordingController::readCurves() { curves_.want(recordings_.folder(), finished_); }

void RecordingController::offerRecovery() {
  showRecordings([this] {
    if (!unfinished_.isEmpty())
      messages_.showMessage(
          tr("The recording \"%1\" was never finished. View > Recording lists it: "
             "Recover restores its contents.")
              .arg(unfinished_));
  });
}

void RecordingController::record(bool record) {
  if (!record) return recording_.stop();
  if (!shared_.shown) return;
  emit starting();
  uncut_([this] { begin(); });
}

void RecordingController::begin() {
  if (!shared_.shown || shared_.replaying || recording_.isRecording()) return;
  const auto begun =
      recording_.start(shared_.shown->scene, recordedName(shared_.shown->tool), panel_->states());
  if (!begun) {
    panel_->show(ui::RecordingStatus{});
    return messages_.showMessage(sentenceOf(begun.error()));
  }
  emit started();
  camera_noted_.clear();
  showRecordings();
}

/// Where the user looks from belongs to the session: a film can show what was seen.
void RecordingController::noteCamera() {
  if (!recording_.isRecording()) return;
  if (!camera_noted_.empty() && since_camera_.elapsed() < kLeastCameraMs) return;
  const std::string camera = wordsOf(cameraOf(views_.volume()));
  if (camera == camera_noted_) return;
  recording_.note("camera", QString::fromStdString(camera));
  camera_noted_ = camera;
  since_camera_.start();
}

void RecordingController::deleteRecording(const QString& id) {
  if (deleter_.isRunning()) return;
  const std::filesystem::path path = recordings_.pathOf(id);
  emit deleting(path);
  deleter_.start(
      [path](const background::Watch&) -> haptics::Expected<Deletion> {
        const bool part = path.extension() == ".part";
        if (part && isInUse(path)) return Deletion::InUse;
        std::error_code error, ignored;
        std::filesystem::remove(path, error);
        // the log of an unfinished one; what else lies there is not Palpate's
        if (part && !error) std::filesystem::remove(path.string() + "-wal", ignored);
        return error ? Deletion::Failed : Deletion::Done;
      },
      [this, id](const haptics::Expected<Deletion>& deletion) {
        const Deletion done = deletion.value_or(Deletion::Failed);
        if (done == Deletion::InUse)
          messages_.showMessage(tr("Another window is writing this recording; stop it there."));
        if (done == Deletion::Failed)
          messages_.showMessage(
              tr("The recording could not be deleted; check the permissions of its folder."));
        if (done == Deletion::Done) recordings_.setLabel(id, {});
        showRecordings();
      });
}

void RecordingController::recover(const QString& id) {
  if (recoverer_.isRunning()) return;
  recoverer_.start(
      [path = recordings_.pathOf(id)](const background::Watch&) { return app::recover(path); },
      [this](const haptics::Expected<std::filesystem::path>& recovered) {
        if (recovered)
          messages_.clear();
        else
          messages_.showMessage(sentenceOf(recovered.error()));
        showRecordings();
      });
}

}  // namespace app
