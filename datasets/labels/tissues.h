// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "datasets/edits/edit.h"
#include "datasets/labels/label_map.h"

namespace datasets {

/// What it takes to cut a structure, by its number in a label map.
struct TissueWanted {
  int structure = 0;
  double energy = haptics::Tissues::kNever;  ///< J/m3, above 0; kNever: it may not be cut
};

/// The edit of these structures: of each voxel that belongs to one. Reads the whole map, so do not
/// call it on the GUI thread.
TissueTable tissuesOf(const LabelMap& labels, std::span<const TissueWanted> wanted);

}  // namespace datasets
