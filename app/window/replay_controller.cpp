// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/replay_controller.h"

#include "app/window/edited_volume.h"
#include "app/window/sentence.h"
#include "app/window/touched_surface.h"
#include "app/window/volume_words.h"
#include "haptics/edit/edited.h"
#include "haptics/recording/replay.h"
#include "ui/panels/force_plot.h"
#include "ui/panels/replay_bar.h"
#include "ui/volume_view.h"

namespace app {
namespace {

/// What the window shows of a step while the scene on view is this one.
haptics::Snapshot snapshotOf(const haptics::Step& step, std::uint32_t scene) {
  haptics::Snapshot snapshot;
  snapshot.tick = step.sequence;
  snapshot.time = static_cast<double>(step.time_ns) * 1e-9;
  snapshot.X_WD = step.X_WD;
  snapshot.X_WP = step.X_WP;
  snapshot.felt_W = snapshot.coupling_W = step.sent_W;
  snapshot.isovalue = step.settings.isovalue;
  snapshot.scene = scene;
  snapshot.contacts = static_cast<int>(step.contacts.size());
  for (std::size_t i = 0; i < step.contacts.size(); ++i) {
    const haptics::Vec3 p_W = step.X_WP.translation() + step.contacts[i].r_W;
    snapshot.places[i] = {{float(p_W.x()), float(p_W.y()), float(p_W.z())},
                          float(step.contacts[i].push)};
  }
  snapshot.force_state = step.force_state;
  snapshot.late_ticks = step.late_ticks;
  snapshot.missed_ticks = step.missed_ticks;
  return snapshot;
}

std::uint64_t digestOf(const ui::Picture& picture) {
  return picture.volume && picture.volume->edited ? picture.volume->edited->digest : 0;
}

/// What tells the volume that was touched from the one on view, which is another.
QString differenceOf(const haptics::Volume& touched, const haptics::Volume& here) {
  const QString then = geometryWords(touched.grid, touched.type);
  const QString now = geometryWords(here.grid, here.type);
  if (then != now) return ReplayController::tr("that one has %1, this one %2").arg(then, now);
  return haptics::liesLike(touched, here)
             ? ReplayController::tr("both have %1 at the same place, but the voxels differ")
                   .arg(then)
             : ReplayController::tr("both have %1, but they lie at other places").arg(then);
}

}  // namespace

ReplayController::ReplayController(ui::MainWindow& window, SharedState& shared,
                                   VolumeIdentity& identity)
    : window_(window), shared_(shared), identity_(identity) {
  connectBar();
  connect(&window, &ui::MainWindow::cancelWanted, this, [this] { opener_.cancel(); });
  connect(&identity, &VolumeIdentity::sought, this, &ReplayController::compareVolumes);
}

void ReplayController::connectBar() {
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
  connect(&bar, &ui::ReplayBar::closeWanted, this, &ReplayController::close);
}

void ReplayController::open(const std::filesystem::path& path) {
  window_.showLoading(tr("Reading the recording"));
  opener_.start([path](const background::Watch& watch) { return Replay::read(path, watch.cancel); },
                [this, path](haptics::Expected<std::unique_ptr<Replay::Beginning>> read) {
                  window_.endLoading();
                  if (read) return begin(std::make_unique<Replay>(std::move(**read), path));
                  const QString why = sentenceOf(read.error());
                  window_.showMessage(why);
                  emit refused(why);
                });
}

void ReplayController::begin(std::unique_ptr<Replay> replay) {
  emit opened();
  replay_ = std::move(replay);
  shared_.replaying = true;
  scene_.reset();
  connect(replay_.get(), &Replay::moved, this, &ReplayController::show);
  connect(replay_.get(), &Replay::playing, &window_.replayBar(), &ui::ReplayBar::setPlaying);
  connect(replay_.get(), &Replay::failed, &window_, &ui::MainWindow::showMessage);
  connect(replay_.get(), &Replay::trackRead, this, [this] {
    window_.replayBar().timeline().show(replay_->track());
    window_.replayBar().setTime(shown_to_);
  });
  window_.clearMessage();
  window_.view().setMouseHand(false);
  window_.replayBar().show(replay_->track());
  window_.replayBar().show();
  replay_->setSpeed(window_.replayBar().speed());
  emit forcesCleared();
  if (shared_.shown) {
    on_view_ = shared_.shown->picture;
    edits_ = digestOf(on_view_);
    identity_.seek(shared_.shown->volume());
  }
  replay_->seek(replay_->track().begin);
}

void ReplayController::drop() {
  replay_.reset();
  shared_.replaying = false;
}

void ReplayController::close() {
  if (!replay_) return;
  drop();
  window_.replayBar().hide();
  emit forcesCleared();
  if (shared_.shown) {
    // as it was before
    showOnView({shared_.shown->picture, shared_.shown->scene});
    window_.show(shared_.shown->scene->tool.mesh);
    emit isovalueShown(shared_.shown->picture, shared_.settings.isovalue);
  }
  emit closed();
}

void ReplayController::closeFile(const std::filesystem::path& path) {
  if (replay_ && replay_->path() == path) close();
}

void ReplayController::showScene() {
  if (!replay_) return;
  scene_.reset();
  editor_.abandon();
  on_view_ = shared_.shown->picture;
  edits_ = digestOf(on_view_);
  identity_.seek(shared_.shown->volume());
  show(shown_to_);
}

void ReplayController::showOnView(const EditedScan& edited) {
  editor_.abandon();
  edits_ = digestOf(edited.picture);
  if (on_view_.volume == edited.picture.volume) return;
  on_view_ = edited.picture;
  window_.replace(edited.picture);
  window_.setTouched(touchedSurfaceOf(edited.scene));
  isovalue_.reset();
}

void ReplayController::showEdits(const haptics::RecordedScene& then) {
  if (then.edits_digest == edits_) return;
  if (then.edits_digest == digestOf(shared_.shown->picture))
    return showOnView({shared_.shown->picture, shared_.shown->scene});
  edits_ = then.edits_digest;
  editor_.start(
      [then, scan = scanOf(shared_.shown->volume()), live = shared_.shown->scene](
          const background::Watch& watch) -> haptics::Expected<EditedScan> {
        const auto volume =
            haptics::editedAsRecorded(scan, then, {.cancel = &watch.cancel, .advanced = {}});
        if (!volume) return tl::unexpected(volume.error());
        const auto scene = haptics::makeScene(
            *volume, live->tool, {.field = live->field.kind(), .cancel = &watch.cancel});
        if (!scene) return tl::unexpected(scene.error());
        return EditedScan{ui::pictureOf(*volume), *scene};
      },
      [this](const haptics::Expected<EditedScan>& edited) {
        if (!replay_) return;
        if (!edited) return window_.showMessage(sentenceOf(edited.error()));
        showOnView(*edited);
        show(shown_to_);
      });
}

/// Whether the volume on view is the one that was touched, as far as can be told.
void ReplayController::compareVolumes() {
  if (!replay_ || !shared_.shown) return;
  const haptics::RecordedScene* then = replay_->recording().scene(replay_->step().step.scene);
  same_volume_ = then != nullptr && haptics::liesLike(then->volume, *shared_.shown->volume());
  if (same_volume_)
    same_volume_ = haptics::compared(then->hash, identity_.of(shared_.shown->volume())) !=
                   haptics::SameVolume::Another;
  window_.replayBar().showWarning(
      then == nullptr || same_volume_
          ? QString{}
          : tr("The volume on view is not the one that was touched: %1; open that one to see it.")
                .arg(differenceOf(then->volume, *shared_.shown->volume())));
  if (same_volume_) showEdits(*then);
}

void ReplayController::show(double time) {
  if (!replay_ || !shared_.shown) return;
  const haptics::Step& step = replay_->step().step;
  if (scene_ != step.scene) {
    scene_ = step.scene;
    if (const haptics::RecordedScene* scene = replay_->recording().scene(step.scene))
      window_.show(scene->tool.mesh);
    compareVolumes();
    isovalue_.reset();
  }
  if (same_volume_ && isovalue_ != step.settings.isovalue) {
    isovalue_ = step.settings.isovalue;
    emit isovalueShown(on_view_, step.settings.isovalue);
  }
  window_.display(snapshotOf(step, shared_.shown->scene->id));
  // the plot goes on where it was, or begins anew after a jump
  const bool goes_on = time >= shown_to_ && time < shown_to_ + ui::ForcePlot::kSeconds;
  if (!goes_on) emit forcesCleared();
  emit forcesAppended(replay_->forces(goes_on ? shown_to_ : time - ui::ForcePlot::kSeconds, time));
  shown_to_ = time;
  window_.replayBar().setTime(time);
}

}  // namespace app
