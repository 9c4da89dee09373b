// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "datasets/edits/edit.h"
#include "haptics/core/volume.h"

namespace datasets {

/// What was taken away from a scan: Volume::derivation.
struct Edited : haptics::Derivation {
  std::vector<Edit> edits;  ///< in force, oldest first
  /// A digest of the voxels that differ from the scan's, their places and the crop. Equal digests
  /// of one scan: equal voxels.
  std::uint64_t digest = 0;
};

/// What was taken away; null: nothing.
inline const Edited* editedOf(const haptics::Volume& volume) {
  return dynamic_cast<const Edited*>(volume.derivation.get());
}

}  // namespace datasets
