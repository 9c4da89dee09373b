// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptics {
namespace {

/// Distance from p to the nearest voxel centre below the isovalue, by growing shells of voxels.
double nearestLegalVoxel(const ScalarField& field, double isovalue, const Vec3& u) {
  const Grid& grid = field.volume().grid;
  const Vec3 centre{std::round(u.x()), std::round(u.y()), std::round(u.z())};
  double nearest = std::numeric_limits<double>::infinity();
  const VoxelBox& box = field.bounds();
  std::int64_t longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    longest = std::max(longest, box.end[axis] - box.first[axis]);
  for (std::int64_t n = 0; n <= longest + 1; ++n) {
    // no voxel of this shell can be nearer than this
    if ((double(n) - 0.5) * grid.spacing.minCoeff() > nearest) break;
    for (std::int64_t k = -n; k <= n; ++k)
      for (std::int64_t j = -n; j <= n; ++j) {
        const bool face = std::abs(k) == n || std::abs(j) == n;
        for (std::int64_t i = -n; i <= n; i += face ? 1 : std::max<std::int64_t>(2 * n, 1)) {
          const Vec3 v = centre + Vec3{double(i), double(j), double(k)};
          if (field.value(v) < isovalue)
            nearest = std::min(nearest, (v - u).cwiseProduct(grid.spacing).norm());
        }
      }
  }
  return nearest;
}

}  // namespace

double penetration(const Scene& scene, double isovalue, const Pose& X_WP) {
  double deepest = 0.0;
  for (const Vec3& p : scene.tool.shell.points) {
    const Vec3 u = scene.field.indexOf(X_WP * p);
    const FieldSample here = scene.field.sample(u);
    const double above = here.value - isovalue;
    if (above < 0.0) continue;
    const double slope = here.gradient_W.norm();
    deepest = std::max(deepest,
                       slope > 0.0 ? above / slope : nearestLegalVoxel(scene.field, isovalue, u));
  }
  return deepest;
}

}  // namespace haptics
