// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/replayed_cuts.h"

#include "app/recording/recording.h"
#include "app/window/scan/edited_volume.h"
#include "datasets/edits/edited.h"

namespace app {

haptics::Expected<std::vector<RecordedCut>> ReplayedCuts::read(
    const std::filesystem::path& path, const std::function<bool()>& goes_on) {
  auto recording = Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  return cutsOf(*recording, goes_on);
}

bool ReplayedCuts::show(const ui::Picture& on_view, std::uint32_t scene, std::uint64_t sequence) {
  constexpr std::int64_t kAtOnce = 1'000'000;  // voxels, some 20 ms
  const auto& volume = on_view.volume;
  const auto moved = cuts_.moveTo(volume, scene, sequence, kAtOnce);
  if (!moved) return true;
  if (moved->anew && isShown())
    views_.showLive(cuts_.volume(), scanOf(volume), datasets::boxesOfStrokes(*volume));
  else if (moved->anew)
    views_.replace(on_view);
  for (const haptics::VoxelBox& box : moved->changed) views_.carve(box);
  return moved->whole;
}

}  // namespace app
