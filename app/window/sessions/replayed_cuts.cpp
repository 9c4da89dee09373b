// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/replayed_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/recording/recording.h"
#include "app/window/scan/edited_volume.h"
#include "haptics/scene/carved_scene.h"

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
  auto voxels = haptics::viewLike(*on_view);
  if (!voxels) return false;
  live_ = Live{on_view, scene, *on_view, *voxels, 0};
  live_->volume.voxels = *voxels;
  while (live_->next < cuts_.size() && cuts_[live_->next].scene != scene) ++live_->next;
  views_.showLive(live_->volume, scanOf(on_view));
  return true;
}

void ReplayedCuts::show(const std::shared_ptr<const haptics::Volume>& on_view, std::uint32_t scene,
                        std::uint64_t sequence) {
  if (std::ranges::find(cuts_, scene, &Cut::scene) == cuts_.end()) return;
  const auto isCutAlready = [&](std::size_t n) {
    return n > 0 && cuts_[n - 1].scene == scene && cuts_[n - 1].sequence > sequence;
  };
  const bool goes_on =
      live_ && live_->uncut == on_view && live_->scene == scene && !isCutAlready(live_->next);
  if (!goes_on && !begin(on_view, scene)) return;
  for (; live_->next < cuts_.size() && cuts_[live_->next].scene == scene &&
         cuts_[live_->next].sequence <= sequence;
       ++live_->next) {
    haptics::BurrCarving carving{live_->volume, cuts_[live_->next].cut};
    haptics::Removed removed;
    while (!carving.isDone())
      removed.add(carving.lowerRow(live_->voxels.get(), on_view->voxels.get(), {}));
    if (removed.voxels > 0) views_.carve(carving.box());
  }
}

}  // namespace app
