// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "app/recording/carved_copy.h"
#include "haptics/carving/burr.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace app::exporting {

/// Which voxels cuts remove as wholes. A voxel is removed by the cut at whose isovalue it was
/// within the surface before (its value at or above it) and is not after.
class RemovedVoxels {
 public:
  using Index = std::array<std::int64_t, 3>;  ///< i, j, k

  /// `uncut`: as it is before the first cut.
  explicit RemovedVoxels(std::shared_ptr<const haptics::Volume> uncut) : copy_{std::move(uncut)} {}

  /// Carries a cut out. Returns what it removed, i fastest; valid until the next.
  haptics::Expected<std::span<const Index>> carve(const haptics::BurrCut& cut);

 private:
  CarvedCopy copy_;
  std::vector<Index> voxels_;
};

}  // namespace app::exporting
