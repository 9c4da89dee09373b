// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/edit/operators.h"

namespace haptics {

/// What an operator lowered.
struct Lowered {
  std::vector<VoxelRun> runs;  ///< by k, j, i; a run may hold some voxels that keep their value
  std::int64_t solid = 0;      ///< voxels that were at the operator's isovalue and are below it now
};

/// Lowers the voxels of `written`, which has the grid of the volume and, in the rows of the
/// operator, its values. Null: writes nothing. It may be the volume's own memory.
Expected<Lowered> lower(const Volume& volume, const EditOperator& edit, void* written,
                        const EditProgress& progress);

}  // namespace haptics
