// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/smoothing.h"

#include <algorithm>

#include "haptics/field/spline_cell.h"

namespace haptics {

SmoothingEffect smoothingEffect(const Volume& volume, double isovalue) {
  constexpr std::int64_t kVoxels = 200'000;
  const VoxelBox box = volume.bounds();
  const auto& dims = volume.grid.dims;
  std::array<std::int64_t, 3> sides;
  for (std::size_t axis = 0; axis < 3; ++axis) sides[axis] = box.end[axis] - box.first[axis];
  const std::int64_t count = sides[0] * sides[1] * sides[2];
  // a step that shares no factor with a row or a slice does not walk along one plane
  std::int64_t step = std::max<std::int64_t>(1, count / kVoxels);
  while (step > 1 && (step % 2 == 0 || sides[0] % step == 0 || sides[1] % step == 0)) ++step;
  std::int64_t solid = 0, erased = 0, gained = 0;
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    for (std::int64_t v = 0; v < count; v += step) {
      const std::array<std::int64_t, 3> at{box.first[0] + v % sides[0],
                                           box.first[1] + v / sides[0] % sides[1],
                                           box.first[2] + v / sides[0] / sides[1]};
      const bool inside = double(voxels[(at[2] * dims[1] + at[1]) * dims[0] + at[0]]) >= isovalue;
      const Vec3 u{double(at[0]), double(at[1]), double(at[2])};
      const bool smoothed = splineCellAt(volume, box, at).value(u) >= isovalue;
      solid += inside;
      erased += inside && !smoothed;
      gained += smoothed && !inside;
    }
  });
  if (solid == 0) return {};
  return {double(erased) / double(solid), double(gained) / double(solid)};
}

}  // namespace haptics
