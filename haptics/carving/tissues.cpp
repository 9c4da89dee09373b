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
  for (const Part& part : parts)
    for (const VoxelRun& run : part.runs) {
      laid[rowOf(run)].push_back({&run, static_cast<float>(part.energy)});
      if (part.energy == kNever)
        kept_ = joined(kept_, {{run.i, run.j, run.k}, {run.i + run.count, run.j + 1, run.k + 1}});
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
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (box.first[axis] >= kept_.end[axis] || box.end[axis] <= kept_.first[axis]) return false;
  return true;
}

}  // namespace haptics
