// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/replayed_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/recording/recording.h"
#include "app/window/scan/edited_volume.h"

namespace app {

haptics::Expected<std::vector<ReplayedCuts::Cut>> ReplayedCuts::read(
    const std::filesystem::path& path, const std::function<bool()>& goes_on) {
  auto recording = Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  std::vector<Cut> cuts;
  const auto done = recording->forEach(-INFINITY, INFINITY, [&](const RecordedStep& step) {
    if (step.step.cut) cuts.push_back({step.step.sequence, step.step.scene, *step.step.cut});
    return goes_on();
  });
  if (!done) return tl::unexpected(done.error());
  return cuts;
}

void ReplayedCuts::set(std::vector<Cut> cuts) {
  cuts_ = std::move(cuts);
  live_.reset();
}

bool ReplayedCuts::begin(const std::shared_ptr<const haptics::Volume>& on_view,
                         std::uint32_t scene) {
  live_ = Live{CarvedCopy{on_view}, scene, 0};
  if (!live_->copy.open()) {
    live_.reset();
    return false;
  }
  while (live_->next < cuts_.size() && cuts_[live_->next].scene != scene) ++live_->next;
  views_.showLive(live_->copy.volume(), scanOf(on_view));
  return true;
}

void ReplayedCuts::show(const std::shared_ptr<const haptics::Volume>& on_view, std::uint32_t scene,
                        std::uint64_t sequence) {
  if (std::ranges::find(cuts_, scene, &Cut::scene) == cuts_.end()) return;
  const auto isCutAlready = [&](std::size_t n) {
    return n > 0 && cuts_[n - 1].scene == scene && cuts_[n - 1].sequence > sequence;
  };
  const bool goes_on = live_ && live_->copy.uncut() == on_view && live_->scene == scene &&
                       !isCutAlready(live_->next);
  if (!goes_on && !begin(on_view, scene)) return;
  haptics::VoxelBox changed;
  for (; live_->next < cuts_.size() && cuts_[live_->next].scene == scene &&
         cuts_[live_->next].sequence <= sequence;
       ++live_->next)
    changed = joined(changed, live_->copy.carve(cuts_[live_->next].cut).value().box);
  if (!isEmpty(changed)) views_.carve(changed);
}

}  // namespace app
