// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <variant>
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

/// Whether an edit lowers voxels or crops: a TissueTable does neither.
inline bool takesAway(const Edit& edit) { return !std::holds_alternative<TissueTable>(edit); }

/// What was taken away; null: nothing.
inline const Edited* editedOf(const haptics::Volume& volume) {
  return dynamic_cast<const Edited*>(volume.derivation.get());
}

/// Boxes that hold all voxels that strokes took away from a volume's scan.
std::vector<haptics::VoxelBox> boxesOfStrokes(const haptics::Volume& volume);

/// What it takes to cut structures after these edits; null: what the scan's values say.
inline const TissueTable* tissuesIn(std::span<const Edit> edits) {
  const TissueTable* last = nullptr;
  for (const Edit& edit : edits)
    if (const auto* table = std::get_if<TissueTable>(&edit)) last = table;
  return last;
}
inline const TissueTable* tissuesIn(const haptics::Volume& volume) {
  const Edited* edited = editedOf(volume);
  return edited != nullptr ? tissuesIn(edited->edits) : nullptr;
}

}  // namespace datasets
