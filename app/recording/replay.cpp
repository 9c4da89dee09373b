// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/replay.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <vector>

#include "app/recording/carved_copy.h"
#include "app/recording/cut_words.h"
#include "app/recording/felt_words.h"
#include "app/recording/recorded_cuts.h"
#include "datasets/edits/edited.h"
#include "datasets/edits/walls.h"
#include "haptics/servo/engagement.h"
#include "haptics/servo/servo_tick.h"

namespace app {
namespace {

haptics::Vec3 placeOf(const PoseNumbers& n) { return {n[0], n[1], n[2]}; }
haptics::Quat turnOf(const PoseNumbers& n) { return {n[3], n[4], n[5], n[6]}; }

/// What was recorded and what came out, number by number.
void compare(const RecordedStep& recorded, const haptics::Pose& X_WP, const haptics::Wrench& sent_W,
             ReplayDifference& difference) {
  ++difference.steps;
  const PoseNumbers proxy = numbersOf(X_WP);
  const haptics::Wrench& then = recorded.step.sent_W;
  const bool same = recorded.check
                        ? *recorded.check == checkOf(proxy, sent_W)
                        : std::memcmp(&proxy, &recorded.proxy, sizeof proxy) == 0 &&
                              std::memcmp(&then.force, &sent_W.force, sizeof(haptics::Vec3)) == 0 &&
                              std::memcmp(&then.torque, &sent_W.torque, sizeof(haptics::Vec3)) == 0;
  if (same) return;
  ++difference.differing;
  if (!difference.first) difference.first = recorded.step.sequence;
  const auto grow = [](double& most, double value) {
    // what is no number is as far away as can be
    most = std::max(most, std::isnan(value) ? std::numeric_limits<double>::infinity() : value);
  };
  grow(difference.distance, (placeOf(proxy) - placeOf(recorded.proxy)).norm());
  grow(difference.angle, turnOf(proxy).angularDistance(turnOf(recorded.proxy)));
  grow(difference.force, (sent_W.force - then.force).norm());
  grow(difference.torque, (sent_W.torque - then.torque).norm());
}

/// The distances to the structures that were watched then and are watched now.
void compareDistances(const RecordedStep& recorded, const haptics::Watch& watch,
                      const haptics::Scene& scene, const haptics::Pose& X_WP,
                      ReplayDifference& difference) {
  haptics::Nearnesses now;
  haptics::measure(watch, scene, X_WP, now);
  const float rounding = recorded.check ? 0.51e-7F : 0.0F;  // m
  for (const haptics::Nearness& then : recorded.step.near) {
    const auto* same = std::ranges::find(now, then.structure, &haptics::Nearness::structure);
    if (same == now.end()) continue;
    ++difference.distances;
    difference.differing_distances += !(std::abs(same->tip - then.tip) <= rounding &&
                                        std::abs(same->nearest - then.nearest) <= rounding);
  }
}

/// The cuts of a recording, carried out once more as they were recorded.
class CutsThen {
 public:
  static haptics::Expected<CutsThen> of(const Recording& recording) {
    CutsThen cuts;
    auto laws = lawsOf(recording);
    if (!laws) return tl::unexpected(laws.error());
    cuts.laws_ = std::move(*laws);
    for (const RecordedEvent& event : recording.events())
      if (event.kind == kCarvedEvent) cuts.said_.push_back(&event);
    return cuts;
  }
  /// What is touched in a scene from a start on: by a tool that cuts, with all cuts until now.
  /// `before`: what was touched until then; null: nothing.
  haptics::Expected<std::unique_ptr<haptics::Engagement>> engaged(
      const std::shared_ptr<const haptics::Scene>& scene, std::uint32_t number,
      const haptics::Pose& X_WP, std::unique_ptr<haptics::Cutting> before) {
    const auto law = laws_.find(number);
    if (law == laws_.end()) return std::make_unique<haptics::Engagement>(scene, X_WP);
    if (number == number_ && before) {
      before->forget();
      return std::make_unique<haptics::Engagement>(std::move(before), X_WP);
    }
    auto carved = haptics::CarvedScene::of(*scene);
    if (!carved) return tl::unexpected(carved.error());
    auto cutting = std::make_unique<haptics::Cutting>(std::move(*carved), law->second);
    if (number != number_) made_.clear();
    for (const haptics::BurrCut& cut : made_) cutting->make(cut);
    if (number != number_) copy_.emplace(scene->volume);
    number_ = number;
    return std::make_unique<haptics::Engagement>(std::move(cutting), X_WP);
  }
  /// After a step: its cut, and what the recording says was left then.
  haptics::Expected<void> add(const haptics::Step& step, ReplayDifference& difference) {
    if (step.cut) ++difference.cuts;
    // of a scene that is not at hand nothing can be carried out
    if (step.cut && copy_ && step.scene == number_) {
      made_.push_back(*step.cut);
      if (const auto done = copy_->carve(*step.cut); !done) return tl::unexpected(done.error());
    }
    for (; next_ < said_.size() && said_[next_]->sequence <= step.sequence; ++next_) {
      if (!copy_ || step.scene != number_ || said_[next_]->sequence != step.sequence) continue;
      ++difference.carved_said;
      difference.differing_carved += wordOf(copy_->digest()) != said_[next_]->text;
    }
    return {};
  }
  void tell(ReplayDifference& difference) const {
    if (difference.cuts > 0 && copy_) difference.carved = copy_->digest();
  }

 private:
  std::map<std::uint32_t, haptics::CutLaw> laws_;  ///< by scene
  std::vector<const RecordedEvent*> said_;
  std::size_t next_ = 0;
  std::uint32_t number_ = 0;            ///< of the scene that is cut
  std::vector<haptics::BurrCut> made_;  ///< in it
  std::optional<CarvedCopy> copy_;
};

/// How structures were felt, from event to event.
class FeltThen {
 public:
  FeltThen(const Recording& recording, const haptics::Watch* watch) : watch_{watch} {
    for (const RecordedEvent& event : recording.events())
      if (event.kind == kFeltEvent) events_.push_back(&event);
  }
  /// At a start: what was felt at this time, or since the recording began.
  haptics::Expected<void> begin(std::int64_t time_ns) {
    while (next_ < events_.size() &&
           (events_[next_]->value.has_value() || events_[next_]->time_ns <= time_ns))
      if (auto moved = move(); !moved) return moved;
    return {};
  }
  /// The next of them.
  haptics::Expected<void> move() {
    if (next_ == events_.size()) return {};
    auto felt = feltAsSaid(events_[next_++]->text, watch_ ? *watch_ : haptics::Watch{});
    if (!felt) return tl::unexpected(felt.error());
    felt_ = std::move(*felt);
    return {};
  }
  const haptics::Watch* watch() const { return felt_.isFelt() ? &felt_ : nullptr; }

 private:
  const haptics::Watch* watch_;
  std::vector<const RecordedEvent*> events_;
  std::size_t next_ = 0;
  haptics::Watch felt_;
};

}  // namespace

haptics::Expected<std::shared_ptr<const haptics::Volume>> editedAsRecorded(
    std::shared_ptr<const haptics::Volume> scan, const RecordedScene& scene,
    const datasets::EditWatch& watch) {
  auto volume = edited(std::move(scan), scene.edits, watch);
  if (volume && !scene.edits.empty() && datasets::editedOf(**volume)->digest != scene.edits_digest)
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported, {"replay-other-edits", {}}, "other-edits"});
  return volume;
}

haptics::Expected<std::map<std::uint32_t, std::shared_ptr<const haptics::Volume>>> editedAsRecorded(
    const std::shared_ptr<const haptics::Volume>& scan, const std::optional<VolumeHash>& hash,
    const Recording& recording) {
  std::map<std::uint32_t, std::shared_ptr<const haptics::Volume>> volumes;
  for (const RecordedScene& scene : recording.scenes()) {
    if (!isOf(scene, *scan, hash)) continue;
    auto volume = editedAsRecorded(scan, scene);
    if (!volume) return tl::unexpected(volume.error());
    volumes[scene.id] = std::move(*volume);
  }
  return volumes;
}

haptics::Expected<std::shared_ptr<const haptics::Volume>> touchedAsRecorded(
    std::shared_ptr<const haptics::Volume> scan, const RecordedScene& scene,
    const haptics::Watch* watch, const std::shared_ptr<const haptics::Volume>& previous) {
  auto seen = editedAsRecorded(std::move(scan), scene);
  if (!seen || scene.walls.empty()) return seen;
  std::vector<datasets::StructureWall> walls;
  for (const datasets::Walled::Wall& wall : scene.walls) {
    const haptics::Watch::Watched* watched = watch ? watch->find(wall.structure) : nullptr;
    if (watched == nullptr) return tl::unexpected(structureMissing(wall.structure));
    walls.push_back({wall.structure, wall.solid, watched->distances});
  }
  auto touched = walled(std::move(*seen), walls, scene.walls_isovalue, previous);
  if (!touched) return touched;
  const datasets::Walled* made = datasets::walledOf(**touched);
  if (made == nullptr || made->digest_of_walls != scene.walls_digest)
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported, {"replay-other-structures", {}}, "other-structures"});
  return touched;
}

haptics::Expected<ReplayDifference> replay(
    Recording& recording,
    const std::function<std::shared_ptr<const haptics::Scene>(std::uint32_t)>& scene,
    const std::function<bool(double)>& goes_on, const haptics::Watch* watch) {
  ReplayDifference difference;
  std::map<std::uint32_t, std::shared_ptr<const haptics::Scene>> scenes;
  std::unique_ptr<haptics::Engagement> touched;
  std::uint32_t scene_touched = 0;
  haptics::ServoRate rate;
  std::optional<haptics::Safety> safety;
  auto start = recording.starts().begin();
  const double span = std::max(1e-9, recording.end() - recording.begin());
  bool cancelled = false;
  std::int64_t until_told = 0;
  std::uint64_t expected = 0;
  FeltThen felt{recording, watch};
  auto cuts = CutsThen::of(recording);
  if (!cuts) return tl::unexpected(cuts.error());
  std::optional<haptics::Error> failed;
  const auto each = [&](const RecordedStep& recorded) {
    const haptics::Step& step = recorded.step;
    if (--until_told < 0) {
      until_told = 1000;
      cancelled = !goes_on((double(step.time_ns) * 1e-9 - recording.begin()) / span);
      if (cancelled) return false;
    }
    // what is missing before this step was not seen: without a new start nothing is known
    if (step.sequence != expected) {
      safety.reset();
      if (touched && touched->cutting) touched->cutting->settle();
    }
    expected = step.sequence + 1;
    while (start != recording.starts().end() && start->sequence <= step.sequence) {
      if (start->sequence == step.sequence) {
        if (auto found = felt.begin(step.time_ns); !found) {
          failed = found.error();
          return false;
        }
        safety.emplace(start->limits, start->safety);
        rate = start->rate;
        std::unique_ptr<haptics::Cutting> cutting = touched ? std::move(touched->cutting) : nullptr;
        touched.reset();
        if (!scenes.contains(start->scene))
          scenes[start->scene] = start->scene == 0 ? nullptr : scene(start->scene);
        if (const auto& found = scenes[start->scene]) {
          auto engaged = cuts->engaged(found, start->scene, start->X_WP, std::move(cutting));
          if (!engaged) {
            failed = engaged.error();
            return false;
          }
          touched = std::move(*engaged);
          touched->proxy.turn = start->turn;
          scene_touched = start->scene;
        }
      }
      ++start;
    }
    if (auto added = cuts->add(step, difference); !added) {
      failed = added.error();
      return false;
    }
    const bool at_hand = step.scene == 0 || (touched && scene_touched == step.scene);
    if (!safety || !at_hand) {
      // what the gate let through depends on what was not computed
      if (!at_hand) safety.reset();
      ++difference.skipped;
      return true;
    }
    if ((step.flags & haptics::StepFlags::kWatchMoved) != 0)
      if (auto found = felt.move(); !found) {
        failed = found.error();
        return false;
      }
    // as much work as then, where it was cut then
    haptics::Budget budget = haptics::Budget::counted(
        step.cut_at > 0 ? step.cut_at : std::numeric_limits<std::int64_t>::max());
    haptics::Engagement* const engaged = step.scene == 0 ? nullptr : touched.get();
    const haptics::ServoResult result =
        haptics::servoTick({.X_WD = step.X_WD,
                            .settings = step.settings,
                            .flags = step.flags,
                            .watch = felt.watch(),
                            .felt = engaged ? &engaged->felt : nullptr,
                            .cutting = engaged ? engaged->cutting.get() : nullptr},
                           engaged ? engaged->scene.get() : nullptr,
                           engaged ? &engaged->proxy : nullptr, *safety, rate.period(), budget);
    compare(recorded, engaged ? engaged->proxy.X_WP : step.X_WD, result.sent_W, difference);
    if (engaged != nullptr && engaged->cutting)
      difference.differing_cuts += engaged->cutting->begun() != step.cut;
    if (watch != nullptr && engaged != nullptr)
      compareDistances(recorded, *watch, *engaged->scene, engaged->proxy.X_WP, difference);
    return true;
  };
  const double everything = std::numeric_limits<double>::infinity();
  if (auto read = recording.forEach(-everything, everything, each); !read)
    return tl::unexpected(read.error());
  if (failed) return tl::unexpected(*failed);
  if (cancelled)
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
  cuts->tell(difference);
  return difference;
}

}  // namespace app
