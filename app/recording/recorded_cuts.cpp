// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/recorded_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/recording/cut_words.h"
#include "app/recording/recording.h"

namespace app {

haptics::Expected<std::map<std::uint32_t, haptics::CutLaw>> lawsOf(const Recording& recording) {
  std::map<std::uint32_t, haptics::CutLaw> laws;
  for (const RecordedEvent& event : recording.events()) {
    if (event.kind != kCutLawEvent || !event.value) continue;
    auto law = lawFrom(event.text);
    if (!law) return tl::unexpected(law.error());
    // the last one counts: nothing was cut before
    for (const RecordedScene& scene : recording.scenes())
      if (double(scene.id) == *event.value) laws.insert_or_assign(scene.id, *law);
  }
  return laws;
}

haptics::Expected<std::vector<RecordedCut>> cutsOf(Recording& recording,
                                                   const std::function<bool()>& goes_on) {
  std::vector<RecordedCut> cuts;
  const auto done = recording.forEach(-INFINITY, INFINITY, [&](const RecordedStep& step) {
    if (step.step.cut) cuts.push_back({step.step.sequence, step.step.scene, *step.step.cut});
    return goes_on();
  });
  if (!done) return tl::unexpected(done.error());
  return cuts;
}

void CutsUntil::set(std::vector<RecordedCut> cuts) {
  cuts_ = std::move(cuts);
  live_.reset();
}

haptics::Expected<void> CutsUntil::begin(const std::shared_ptr<const haptics::Volume>& uncut,
                                         std::uint32_t scene) {
  live_ = Live{CarvedCopy{uncut}, scene, 0};
  if (auto opened = live_->copy.open(); !opened) {
    live_.reset();
    return opened;
  }
  while (live_->next < cuts_.size() && cuts_[live_->next].scene != scene) ++live_->next;
  return {};
}

haptics::Expected<CutsUntil::Moved> CutsUntil::moveTo(
    const std::shared_ptr<const haptics::Volume>& uncut, std::uint32_t scene,
    std::uint64_t sequence, std::int64_t most) {
  Moved moved;
  if (std::ranges::find(cuts_, scene, &RecordedCut::scene) == cuts_.end()) {
    moved.anew = isCarved();
    forget();
    return moved;
  }
  const auto isCutAlready = [&](std::size_t n) {
    return n > 0 && cuts_[n - 1].scene == scene && cuts_[n - 1].sequence > sequence;
  };
  moved.anew =
      !live_ || live_->copy.uncut() != uncut || live_->scene != scene || isCutAlready(live_->next);
  if (moved.anew)
    if (auto begun = begin(uncut, scene); !begun) return tl::unexpected(begun.error());
  for (; live_->next < cuts_.size() && cuts_[live_->next].scene == scene &&
         cuts_[live_->next].sequence <= sequence;
       ++live_->next) {
    if (most <= 0) {
      moved.whole = false;
      break;
    }
    const auto done = live_->copy.carve(cuts_[live_->next].cut);
    if (!done) return tl::unexpected(done.error());
    most -= done->looked;
    haptics::add(done->box, moved.changed);
  }
  return moved;
}

}  // namespace app
