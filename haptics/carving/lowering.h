// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "haptics/core/volume.h"

namespace haptics {

/// A row of voxels along i.
struct VoxelRun {
  std::int32_t i = 0, j = 0, k = 0;  ///< its first voxel
  std::int32_t count = 0;
  bool operator==(const VoxelRun&) const = default;
};

/// What becomes of one row of voxels.
struct RowCut {
  /// Voxels first <= i < end. All of them become background, or each becomes at most its ceiling.
  struct Span {
    std::int32_t first = 0, end = 0;
    bool background = false;
  };
  std::vector<Span> spans;      ///< by i, apart
  std::vector<double> ceiling;  ///< by i of the grid; only within spans that are not background
};

/// Gives each voxel of a volume a greatest value.
class RowCutter {
 public:
  virtual ~RowCutter() = default;
  VoxelBox box;           ///< within which voxels may change
  double isovalue = 0.0;  ///< at which its volume is counted
  /// The row (j, k) within the box; several threads at a time. `cut.ceiling` has the length of a
  /// row of the grid.
  virtual void cutRow(std::int64_t j, std::int64_t k, RowCut& cut) const = 0;
};

/// What was lowered.
struct Lowered {
  std::vector<VoxelRun> runs;  ///< by k, j, i; a run may hold some voxels that keep their value
  std::int64_t solid = 0;      ///< voxels that were at the cutter's isovalue and are below it now
};

/// Calls work(n) for 0 <= n < count, in any order, on any threads; false if it was cancelled.
using EachPart = std::function<bool(std::int64_t count, const std::function<void(std::int64_t)>&)>;

/// Lowers the voxels of `written`, which has the grid of the volume and, in the rows of the cutter,
/// its values. Null: writes nothing. It may be the volume's own memory. The work is parted by
/// `each`; none if that was cancelled.
std::optional<Lowered> lower(const Volume& volume, const RowCutter& cutter, void* written,
                             const EachPart& each);

}  // namespace haptics
