// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/smoothing.h"

#include <algorithm>

#include "haptics/field/spline_cell.h"

namespace haptics {

SmoothingEffect smoothingEffect(const Volume& volume, double isovalue) {
  constexpr std::int64_t kVoxels = 200'000;
  const auto& dims = volume.grid.dims;
  const std::int64_t count = volume.grid.voxelCount();
  // a step that shares no factor with a row or a slice does not walk along one plane
  std::int64_t step = std::max<std::int64_t>(1, count / kVoxels);
  while (step > 1 && (step % 2 == 0 || dims[0] % step == 0 || dims[1] % step == 0)) ++step;
  std::int64_t solid = 0, erased = 0, gained = 0;
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    for (std::int64_t v = 0; v < count; v += step) {
      const std::array<std::int64_t, 3> at{v % dims[0], v / dims[0] % dims[1],
                                           v / dims[0] / dims[1]};
      const bool inside = double(voxels[v]) >= isovalue;
      const Vec3 u{double(at[0]), double(at[1]), double(at[2])};
      const bool smoothed = splineCellAt(volume, at).value(u) >= isovalue;
      solid += inside;
      erased += inside && !smoothed;
      gained += smoothed && !inside;
    }
  });
  if (solid == 0) return {};
  return {double(erased) / double(solid), double(gained) / double(solid)};
}

}  // namespace haptics
