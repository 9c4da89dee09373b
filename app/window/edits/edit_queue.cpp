// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/edits/edit_queue.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "app/window/scan/sentence.h"
#include "app/window/scan/start_pose.h"
#include "datasets/edits/edited.h"
#include "haptics/scene/legal_pose.h"

namespace app {
namespace {

using datasets::Edit;

constexpr int kUntouchedMs = 100;

/// An edit for a recording. What may be long it has elsewhere: cuts, and the edits of a scene.
QString noteOf(const Edit& edit) {
  if (std::holds_alternative<datasets::Stroke>(edit)) return QStringLiteral("stroke");
  if (std::holds_alternative<datasets::TissueTable>(edit)) return QStringLiteral("tissues");
  return QString::fromStdString(datasets::textOf(edit));
}

}  // namespace

EditQueue::EditQueue(ui::Messages& messages, ui::Loading& loading, SharedState& shared)
    : messages_(messages),
      loading_(loading),
      shared_(shared),
      // with its words: a load that ended meanwhile has put the bar away
      task_([&loading](double fraction) {
        loading.begin(tr("Editing"));
        loading.advance(fraction);
      }) {
  untouched_.start();
}

void EditQueue::begin(std::shared_ptr<const haptics::Volume> scan) {
  if (running_) {
    task_.abandon();
    loading_.end();
  }
  painter_.abandon();
  running_.reset();
  held_.reset();
  queue_.clear();
  history_.reset();
  scan_ = std::move(scan);
  endWait();
}

void EditQueue::want(Job job) {
  // what is cut is cut: it does not wait behind an undo that waits for the tool
  const auto at =
      job.felt_in == 0 ? queue_.end() : std::ranges::find(queue_, std::uint64_t{0}, &Job::felt_in);
  queue_.insert(at, std::move(job));
  startNext();
}

bool EditQueue::hasStrokes() const {
  const auto isStroke = [](const Job& job) { return job.felt_in != 0; };
  return (running_ && isStroke(*running_)) || std::ranges::any_of(queue_, isStroke);
}

void EditQueue::cancel() {
  cancelWait();
  if (running_ && !isOwed(*running_)) task_.cancel();
}

bool EditQueue::raises(const Job& job) const {
  if (job.step == Step::Renew) return job.puts_back;
  if (job.step != Step::Apply) return true;
  const auto* crop = std::get_if<datasets::Crop>(&job.edits.front());
  if (crop == nullptr) return false;
  const haptics::VoxelBox now = shared_.shown->volume()->bounds();
  for (std::size_t a = 0; a < 3; ++a)
    if (crop->kept.first[a] < now.first[a] || crop->kept.end[a] > now.end[a]) return true;
  return false;
}

bool EditQueue::putsBack(const Job& job) const {
  if (isFelt(job)) return false;
  // a stroke that ended meanwhile is in the touch, and not in what was made
  return raises(job) || std::ranges::any_of(queue_, [this](const Job& j) { return isFelt(j); });
}

bool EditQueue::touches() const {
  return shared_.snapshot.contacts > 0 || shared_.snapshot.scene != shared_.shown->scene->id;
}

bool EditQueue::isClear() const {
  // the time alone does not tell: it goes on while a busy window looks at no snapshot
  return !shared_.session.isOpen() || (!touches() && untouched_.elapsed() >= kUntouchedMs);
}

void EditQueue::refresh() {
  if (!shared_.shown) return;
  if (touches()) untouched_.restart();
  if (held_)
    adopt();
  else
    startNext();
}

void EditQueue::showWait(Step step) {
  const QString words = step == Step::Undo   ? tr("Undo waits until the tool no longer touches.")
                        : step == Step::Redo ? tr("Redo waits until the tool no longer touches.")
                        : step == Step::Reset
                            ? tr("Taking all edits back waits until the tool no longer touches.")
                            : tr("This edit puts material back, and waits until the tool no "
                                 "longer touches.");
  if (words == wait_shown_) return;
  wait_shown_ = words;
  emit waitChanged(words);
  loading_.begin(words);
}

void EditQueue::endWait() {
  wait_shown_.clear();
  emit waitChanged({});
}

void EditQueue::cancelWait() {
  if (running_ && isOwed(*running_)) return;
  if (held_) {
    task_.start(
        [history = held_->history, step = running_->step](const Watch&) -> haptics::Expected<Made> {
          rollBack(*history, step);
          return tl::unexpected(haptics::Error{haptics::Error::Kind::Cancelled, {}, "cancelled"});
        },
        [this](haptics::Expected<Made> made) { deliver(std::move(made)); });
    held_.reset();
    endWait();
    return;
  }
  if (running_ || queue_.empty() || isOwed(queue_.front()) || !raises(queue_.front())) return;
  queue_.pop_front();
  endWait();
  loading_.end();
}

void EditQueue::startNext() {
  if (running_ || held_ || queue_.empty() || !shared_.shown) return;
  // the stroke under way comes first: it is the last edit then
  if (queue_.front().felt_in == 0 && cuts_()) return;
  if (raises(queue_.front()) && !isClear()) return showWait(queue_.front().step);
  endWait();
  running_ = std::move(queue_.front());
  queue_.pop_front();
  start(*running_);
}

void EditQueue::start(const Job& job) {
  if (!history_) history_ = std::make_shared<datasets::EditHistory>(scan_);
  loading_.begin(tr("Editing"));
  task_.start(
      [history = history_, job, shown = *shared_.shown, options = optionsOf(job),
       isovalue = shared_.settings.isovalue](const Watch& watch) {
        return worked(history, job, shown, options, isovalue, watch);
      },
      [this](haptics::Expected<Made> made) { deliver(std::move(made)); });
}

void EditQueue::rollBack(datasets::EditHistory& history, Step step) {
  if (step == Step::Apply || step == Step::Redo) {
    (void)history.undo();
  } else if (step == Step::Undo) {
    (void)history.redo();
  } else if (step == Step::Reset) {
    while (history.canRedo() && history.redo()) {
    }
  }  // a list of edits had a history of its own
}

haptics::SceneOptions EditQueue::optionsOf(const Job& job) const {
  haptics::SceneOptions options = shared_.options;
  if (job.felt_in == shared_.shown->scene->id) options.id = job.felt_in;
  return options;
}

haptics::Expected<EditQueue::Made> EditQueue::worked(std::shared_ptr<datasets::EditHistory> history,
                                                     const Job& job, const Loaded& shown,
                                                     haptics::SceneOptions options, double isovalue,
                                                     const Watch& watch) {
  // a list of edits gets a history of its own, so that the present one stays if it fails
  if (job.step == Step::Restore) history = std::make_shared<datasets::EditHistory>(history->scan());
  const datasets::EditWatch edit_watch{
      .cancel = &watch.cancel, .advanced = [&](double done) { watch.advanced(0.6 * done); }};
  haptics::Expected<std::shared_ptr<const haptics::Volume>> volume = history->present();
  switch (job.step) {
    case Step::Undo:
      volume = history->undo(edit_watch);
      break;
    case Step::Redo:
      volume = history->redo(edit_watch);
      break;
    case Step::Reset:
      volume = history->reset(edit_watch);
      break;
    case Step::Renew:
      break;
    case Step::Apply:
    case Step::Restore:
      for (const Edit& edit : job.edits)
        if (volume) volume = history->apply(edit, edit_watch);
      break;
  }
  if (!volume) return tl::unexpected(volume.error());
  Made made;
  made.history = history;
  if (auto ready = built(made, shown, options, isovalue, watch); !ready) {
    rollBack(*history, job.step);
    return tl::unexpected(ready.error());
  }
  return made;
}

haptics::Expected<void> EditQueue::built(Made& made, const Loaded& shown,
                                         haptics::SceneOptions options, double isovalue,
                                         const Watch& watch) {
  const auto& volume = made.history->present();
  options.field = shown.scene->field.kind();
  auto scene = haptics::makeScene(volume, shown.scene->tool, options, shown.seenScene().get());
  if (!scene) return tl::unexpected(scene.error());
  made.scene = std::move(*scene);
  made.base = shown.scene;
  watch.advanced(0.9);
  if (auto near = haptics::legalPoseNear(*made.scene, isovalue, shown.start))
    made.start = *near;
  else
    made.start = startPose(*made.scene, isovalue).value_or(shown.start);
  return {};
}

void EditQueue::deliver(haptics::Expected<Made> made) {
  if (!made) {
    // the touch has a stroke that is no edit: back to what is one
    if (running_->felt_in != 0) queue_.push_front({.step = Step::Renew, .puts_back = true});
    running_.reset();
    loading_.end();
    haptics::Error& error = made.error();
    if (error.reason == background::kNoMemory)
      error.message =
          tr("There is not enough memory for this edit; nothing was changed.").toStdString();
    else if (error.reason == background::kThrew)
      error.message = tr("The edit could not be made: %1").arg(sentenceOf(error)).toStdString();
    if (error.kind != haptics::Error::Kind::Cancelled) messages_.showMessage(sentenceOf(error));
    emit failed();
    return startNext();
  }
  // refresh() adopts it, on what the tool does then
  held_ = std::move(*made);
}

void EditQueue::adopt() {
  if (held_->base != shared_.shown->scene) {
    // another tool or field came meanwhile: the same volume with it
    Made again;
    again.history = held_->history;
    held_.reset();
    task_.start(
        [again, step = running_->step, shown = *shared_.shown, options = optionsOf(*running_),
         isovalue = shared_.settings.isovalue](const Watch& watch) -> haptics::Expected<Made> {
          Made made = again;
          if (auto ready = built(made, shown, options, isovalue, watch); !ready) {
            rollBack(*made.history, step);
            return tl::unexpected(ready.error());
          }
          return made;
        },
        [this](haptics::Expected<Made> made) { deliver(std::move(made)); });
    return;
  }
  if (!isFelt(*running_) && cuts_()) return;
  if (putsBack(*running_) && !isClear()) return showWait(running_->step);
  const Job job = *std::exchange(running_, std::nullopt);
  Made made = *std::exchange(held_, std::nullopt);
  endWait();
  loading_.end();
  history_ = std::move(made.history);
  Loaded loaded = *shared_.shown;
  loaded.scene = std::move(made.scene);
  loaded.seen.reset();  // walls of structures follow
  loaded.start = made.start;
  loaded.note.clear();
  const char* const words[] = {"", "undo", "redo", "reset", "restore", "renew"};
  if (job.step == Step::Apply)
    emit noted(noteOf(job.edits.front()));
  else
    emit noted(words[static_cast<int>(job.step)]);
  const bool seen = loaded.scene->id == shared_.shown->scene->id;
  if (seen)
    emit renewed(loaded);
  else
    emit edited(loaded);
  if (job.step != Step::Renew) paint(seen);
  startNext();
}

/// The picture follows: the touch does not wait for it.
void EditQueue::paint(bool seen) {
  // a picture that is dropped for this one was to show something else
  painting_seen_ = seen && (painting_seen_ || !painter_.isRunning());
  painter_.start(
      [volume = shared_.shown->volume(),
       before = shared_.shown->picture](const Watch& watch) -> haptics::Expected<ui::Picture> {
        const haptics::Derivation* edit = haptics::derivationBetween(volume, before.volume);
        return edit != nullptr ? ui::pictureOf(volume, before, edit->changed)
                               : ui::pictureOf(volume, &watch.cancel);
      },
      [this](const haptics::Expected<ui::Picture>& picture) {
        if (picture) return emit pictured(*picture, painting_seen_);
        messages_.showMessage(tr(
            "The picture of the edited volume could not be made: it still shows the volume before "
            "the edit, but you touch the edited volume. Close other programs and undo the edit."));
      });
}

}  // namespace app
