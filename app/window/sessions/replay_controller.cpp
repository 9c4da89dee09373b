// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/replay_controller.h"

#include <utility>

#include "app/recording/replay.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "app/window/scan/touched_surface.h"
#include "app/window/scan/volume_words.h"
#include "datasets/edits/edited.h"
#include "ui/panels/force_plot.h"
#include "ui/panels/replay_bar.h"
#include "ui/views/volume_view.h"

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
  snapshot.near = step.near;
  snapshot.cuts = (step.flags & haptics::StepFlags::kCut) != 0;
  snapshot.force_state = step.force_state;
  snapshot.late_ticks = step.late_ticks;
  snapshot.missed_ticks = step.missed_ticks;
  return snapshot;
}

/// What tells the volume that was touched from the one on view, which is another.
QString differenceOf(const haptics::Volume& touched, const haptics::Volume& here) {
  const QString then = geometryWords(touched.grid, touched.type);
  const QString now = geometryWords(here.grid, here.type);
  if (then != now) return ReplayController::tr("that one has %1, this one %2").arg(then, now);
  return liesLike(touched, here)
             ? ReplayController::tr("both have %1 at the same place, but the voxels differ")
                   .arg(then)
             : ReplayController::tr("both have %1, but they lie at other places").arg(then);
}

}  // namespace

ReplayController::ReplayController(ui::Views& views, ui::Messages& messages, ui::Loading& loading,
                                   ui::TouchState& touch, ui::ReplayBar& replay_bar,
                                   SharedState& shared)
    : views_(views),
      messages_(messages),
      loading_(loading),
      touch_(touch),
      replay_bar_(replay_bar),
      shared_(shared) {
  connectBar();
  cutting_.setSingleShot(true);
  connect(&cutting_, &QTimer::timeout, this, &ReplayController::showCuts);
  connect(&loading, &ui::Loading::cancelWanted, this, [this] { opener_.cancel(); });
  connect(&shared.identity, &VolumeIdentity::sought, this, &ReplayController::compareVolumes);
}

void ReplayController::connectBar() {
  ui::ReplayBar& bar = replay_bar_;
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

void ReplayController::openAt(const std::filesystem::path& path, double time) {
  if (replay_ && replay_->path() == path) {
    replay_->play(false);
    return replay_->seek(time);
  }
  open(path);
  first_ = time;
}

void ReplayController::open(const std::filesystem::path& path) {
  first_.reset();
  loading_.begin(tr("Reading the recording"));
  opener_.start([path](const background::Watch& watch) { return Replay::read(path, watch.cancel); },
                [this, path](haptics::Expected<std::unique_ptr<Replay::Beginning>> read) {
                  loading_.end();
                  if (read) return begin(std::make_unique<Replay>(std::move(**read), path));
                  const QString why = sentenceOf(read.error());
                  messages_.showMessage(why);
                  emit refused(why);
                });
}

void ReplayController::begin(std::unique_ptr<Replay> replay) {
  emit opened();
  replay_ = std::move(replay);
  shared_.replaying = true;
  scene_.reset();
  connect(replay_.get(), &Replay::moved, this, &ReplayController::show);
  connect(replay_.get(), &Replay::playing, &replay_bar_, &ui::ReplayBar::setPlaying);
  connect(replay_.get(), &Replay::failed, &messages_, &ui::Messages::showMessage);
  connect(replay_.get(), &Replay::trackRead, this, [this] {
    replay_bar_.timeline().show(replay_->track());
    replay_bar_.setTime(shown_to_);
  });
  messages_.clear();
  views_.volume().setMouseHand(false);
  replay_bar_.show(replay_->track());
  replay_bar_.show();
  replay_->setSpeed(replay_bar_.speed());
  emit forcesCleared();
  if (shared_.shown) {
    on_view_ = shared_.shown->picture;
    edits_ = MadeOfScan::of(on_view_);
    shared_.identity.seek(shared_.shown->volume());
  }
  readCuts();
  replay_->seek(std::exchange(first_, {}).value_or(replay_->track().begin));
}

void ReplayController::readCuts() {
  cuts_.set({});
  if (!replay_->recording().isCut()) return cut_reader_.abandon();
  cut_reader_.start(
      [path = replay_->path()](const background::Watch& watch) {
        return ReplayedCuts::read(path, [&watch] { return !watch.cancelled(); });
      },
      [this](haptics::Expected<std::vector<RecordedCut>> cuts) {
        // what cannot be read of it, the replay says when it comes there
        if (!cuts || !replay_) return;
        cuts_.set(std::move(*cuts));
        show(shown_to_);
      });
}

void ReplayController::drop() {
  cut_reader_.abandon();
  cuts_.set({});
  replay_.reset();
  shared_.replaying = shared_.replays_other = false;
}

void ReplayController::close() {
  if (!replay_) return;
  if (cuts_.isShown()) on_view_ = {};  // the voxels on view are those that were cut
  drop();
  replay_bar_.hide();
  emit forcesCleared();
  if (shared_.shown) {
    // as it was before
    showOnView({shared_.shown->picture, shared_.shown->seenScene()});
    views_.show(shared_.shown->scene->tool.mesh);
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
  edits_ = MadeOfScan::of(on_view_);
  shared_.identity.seek(shared_.shown->volume());
  show(shown_to_);
}

ReplayController::MadeOfScan ReplayController::MadeOfScan::of(
    std::uint64_t digest, std::span<const datasets::Edit> edits) {
  MadeOfScan made{digest};
  if (const auto* tissues = datasets::tissuesIn(edits)) made.tissues = *tissues;
  return made;
}

ReplayController::MadeOfScan ReplayController::MadeOfScan::of(const ui::Picture& picture) {
  const auto* edited = picture.volume ? datasets::editedOf(*picture.volume) : nullptr;
  return edited != nullptr ? of(edited->digest, edited->edits) : MadeOfScan{};
}

void ReplayController::showOnView(const EditedScan& edited) {
  editor_.abandon();
  edits_ = MadeOfScan::of(edited.picture);
  if (on_view_.volume == edited.picture.volume) return;
  on_view_ = edited.picture;
  cuts_.forget();
  views_.replace(edited.picture);
  views_.setTouched(touchedSurfaceOf(edited.scene));
  isovalue_.reset();
}

void ReplayController::showEdits(const RecordedScene& then) {
  const MadeOfScan wanted = MadeOfScan::of(then.edits_digest, then.edits);
  if (wanted == edits_) return;
  if (wanted == MadeOfScan::of(shared_.shown->picture))
    return showOnView({shared_.shown->picture, shared_.shown->seenScene()});
  edits_ = wanted;
  editor_.start(
      [then, scan = scanOf(shared_.shown->volume()), live = shared_.shown->scene](
          const background::Watch& watch) -> haptics::Expected<EditedScan> {
        const auto volume = editedAsRecorded(scan, then, {.cancel = &watch.cancel, .advanced = {}});
        if (!volume) return tl::unexpected(volume.error());
        const auto scene = haptics::makeScene(
            *volume, live->tool, {.field = live->field.kind(), .cancel = &watch.cancel});
        if (!scene) return tl::unexpected(scene.error());
        return EditedScan{ui::pictureOf(*volume), *scene};
      },
      [this](const haptics::Expected<EditedScan>& edited) {
        if (!replay_) return;
        if (!edited) return messages_.showMessage(sentenceOf(edited.error()));
        showOnView(*edited);
        show(shown_to_);
      });
}

/// Whether the volume on view is the one that was touched, as far as can be told.
void ReplayController::compareVolumes() {
  if (!replay_ || !shared_.shown) return;
  const RecordedScene* then = replay_->recording().scene(replay_->step().step.scene);
  same_volume_ = then != nullptr && liesLike(then->volume, *shared_.shown->volume());
  if (same_volume_)
    same_volume_ =
        compared(then->hash, shared_.identity.of(shared_.shown->volume())) != SameVolume::Another;
  const bool other = then != nullptr && !same_volume_;
  behind_ = false;
  // whose value is told, or no more
  if (std::exchange(shared_.replays_other, other) != other)
    touch_.display(snapshotOf(replay_->step().step, shared_.shown->scene->id));
  replay_bar_.showWarning(
      !other
          ? QString{}
          : tr("The volume on view is not the one that was touched: %1; open that one to see it.")
                .arg(differenceOf(then->volume, *shared_.shown->volume())));
  if (same_volume_) showEdits(*then);
}

void ReplayController::showCuts() {
  if (!replay_ || !same_volume_ || editor_.isRunning() || !on_view_.volume) return;
  const haptics::Step& step = replay_->step().step;
  const bool behind = !cuts_.show(on_view_, step.scene, step.sequence);
  if (behind) cutting_.start();
  if (std::exchange(behind_, behind) != behind)
    replay_bar_.showWarning(behind ? tr("What was cut until here is being cut again.") : QString{});
}

void ReplayController::show(double time) {
  if (!replay_ || !shared_.shown) return;
  const haptics::Step& step = replay_->step().step;
  if (scene_ != step.scene) {
    scene_ = step.scene;
    if (const RecordedScene* scene = replay_->recording().scene(step.scene))
      views_.show(scene->tool.mesh);
    compareVolumes();
    isovalue_.reset();
  }
  if (same_volume_ && isovalue_ != step.settings.isovalue) {
    isovalue_ = step.settings.isovalue;
    emit isovalueShown(on_view_, step.settings.isovalue);
  }
  showCuts();
  const haptics::Snapshot snapshot = snapshotOf(step, shared_.shown->scene->id);
  views_.display(snapshot);
  touch_.display(snapshot);
  // the plot goes on where it was, or begins anew after a jump
  const bool goes_on = time >= shown_to_ && time < shown_to_ + ui::ForcePlot::kSeconds;
  if (!goes_on) emit forcesCleared();
  emit forcesAppended(replay_->forces(goes_on ? shown_to_ : time - ui::ForcePlot::kSeconds, time));
  shown_to_ = time;
  replay_bar_.setTime(time);
}

}  // namespace app
