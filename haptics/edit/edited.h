// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/core/volume.h"
#include "haptics/edit/edit.h"

namespace haptics {

/// How an edited volume came about: Volume::edited.
struct Edited {
  std::shared_ptr<const Volume> scan;  ///< the volume before any edit
  std::vector<Edit> edits;             ///< in force, oldest first
  /// A digest of the voxels that differ from the scan's, their places and the crop. Equal digests
  /// of one scan: equal voxels.
  std::uint64_t digest = 0;
  /// The volume of one step before or after this one, and boxes that hold every voxel and every
  /// face of the crop that differs from it. For what was built over that volume and is renewed only
  /// where it changed.
  std::weak_ptr<const Volume> neighbour;
  std::vector<VoxelBox> changed;
};

}  // namespace haptics
