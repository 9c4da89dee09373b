// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/carving/tissues.h"

#include <algorithm>

namespace haptics {

Tissues::Tissues(const Grid& grid, std::span<const Part> parts) : rows_{grid.dims[1]} {
  struct Laid {
    const VoxelRun* run;
    float energy;
  };
  const auto rowOf = [&](const VoxelRun& run) {
    return static_cast<std::size_t>(std::int64_t{run.k} * rows_ + run.j);
  };
  const auto rows = static_cast<std::size_t>(rows_ * grid.dims[2]);
  std::vector<std::vector<Laid>> laid(rows);
  for (std::size_t axis = 0; axis < 3; ++axis)
    blocks_[axis] = (grid.dims[axis] + kBlock - 1) / kBlock;
  kept_.resize(static_cast<std::size_t>(blocks_[0] * blocks_[1] * blocks_[2]));
  for (const Part& part : parts)
    for (const VoxelRun& run : part.runs) {
      laid[rowOf(run)].push_back({&run, static_cast<float>(part.energy)});
      if (part.energy != kNever) continue;
      const std::int64_t row_of_blocks =
          (run.k / kBlock * blocks_[1] + run.j / kBlock) * blocks_[0];
      for (std::int64_t i = run.i / kBlock; i <= (run.i + run.count - 1) / kBlock; ++i)
        kept_[static_cast<std::size_t>(row_of_blocks + i)] = true;
    }
  begins_.reserve(rows + 1);
  std::vector<float> energies(static_cast<std::size_t>(grid.dims[0]));  // of a row; 0: none
  for (const std::vector<Laid>& row : laid) {
    begins_.push_back(runs_.size());
    if (row.empty()) continue;
    for (const auto& [run, energy] : row) {
      const auto first = energies.begin() + run->i;
      std::for_each(first, first + run->count, [energy = energy](float& now) {
        if (Run{.energy = now}.mayBeCut()) now = energy;
      });
    }
    for (auto at = energies.begin(); at != energies.end();) {
      const auto end =
          std::find_if(at, energies.end(), [&](float energy) { return energy != *at; });
      if (*at > 0.0F)
        runs_.push_back({static_cast<std::int32_t>(at - energies.begin()),
                         static_cast<std::int32_t>(end - energies.begin()), *at});
      at = end;
    }
    std::ranges::fill(energies, 0.0F);
  }
  begins_.push_back(runs_.size());
}

bool Tissues::mayKeep(const VoxelBox& box) const HAPTICS_RT {
  const auto lastOf = [&](std::size_t axis) { return (box.end[axis] - 1) / kBlock; };
  for (std::int64_t k = box.first[2] / kBlock; k <= lastOf(2); ++k)
    for (std::int64_t j = box.first[1] / kBlock; j <= lastOf(1); ++j)
      for (std::int64_t i = box.first[0] / kBlock; i <= lastOf(0); ++i)
        if (kept_[static_cast<std::size_t>((k * blocks_[1] + j) * blocks_[0] + i)]) return true;
  return false;
}

}  // namespace haptics
