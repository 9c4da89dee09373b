// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/legal_pose.h"

#include <cmath>
#include <limits>

namespace haptics {

bool legal(const Isosurface& solid, const PointShell& shell, const Pose& X_WT,
           Budget& budget) HAPTICS_RT {
  for (const Vec3& p : shell.points) {
    if (!budget.left()) return false;
    budget.spend(solid.field.work());
    ++budget.counts.samples;
    if (solid.inside(X_WT * p)) return false;
  }
  return true;
}

double placeAround(const Pose& X_WT, double voxel, int n, Pose& place) HAPTICS_RT {
  const int direction = n % 26 + (n % 26 >= 13 ? 1 : 0);  // of 27 steps, without the middle one
  const Vec3 way{double(direction % 3 - 1), double(direction / 3 % 3 - 1),
                 double(direction / 9 - 1)};
  const double distance = voxel * std::pow(1.25, n / 26);
  place = X_WT;
  place.translation() += distance * way.normalized();
  return distance;
}

std::optional<Pose> legalPoseNear(const Scene& scene, double isovalue, const Pose& X_WT) {
  constexpr double kFarthest = 0.050;  // m
  const Isosurface solid{scene.field, isovalue};
  Budget unlimited = Budget::counted(std::numeric_limits<std::int64_t>::max());
  if (legal(solid, scene.tool.shell, X_WT, unlimited)) return X_WT;
  Pose place;
  for (int n = 0; placeAround(X_WT, scene.field.voxel(), n, place) <= kFarthest; ++n)
    if (legal(solid, scene.tool.shell, place, unlimited)) return place;
  return {};
}

}  // namespace haptics
