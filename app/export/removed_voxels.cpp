// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/removed_voxels.h"

namespace app::exporting {

using haptics::BurrCut;

haptics::Expected<std::span<const RemovedVoxels::Index>> RemovedVoxels::carve(const BurrCut& cut) {
  voxels_.clear();
  if (!haptics::isPossible(cut)) return voxels_;
  if (auto opened = copy_.open(); !opened) return tl::unexpected(opened.error());
  const haptics::Volume& volume = copy_.volume();
  const auto& dims = volume.grid.dims;
  const haptics::VoxelBox box = haptics::BurrCarving{*copy_.uncut(), cut}.box();
  return haptics::visitVoxels(
      volume.type, volume.voxels.get(),
      [&](const auto* voxels) -> haptics::Expected<std::span<const Index>> {
        const auto isWithin = [&](const Index& at) {
          return double(voxels[(at[2] * dims[1] + at[1]) * dims[0] + at[0]]) >= cut.isovalue;
        };
        for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
          for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
            for (std::int64_t i = box.first[0]; i < box.end[0]; ++i)
              if (isWithin({i, j, k})) voxels_.push_back({i, j, k});
        if (auto done = copy_.carve(cut); !done) return tl::unexpected(done.error());
        std::erase_if(voxels_, isWithin);
        return voxels_;
      });
}

}  // namespace app::exporting
