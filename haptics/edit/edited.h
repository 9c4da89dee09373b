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

/// How one of the volumes differs from the other; null if they are not known to be neighbours.
inline const Edited* editBetween(const std::shared_ptr<const Volume>& one,
                                 const std::shared_ptr<const Volume>& other) {
  if (one->edited && one->edited->neighbour.lock() == other) return one->edited.get();
  if (other->edited && other->edited->neighbour.lock() == one) return other->edited.get();
  return nullptr;
}

}  // namespace haptics
