// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rivals/near_points.h"

namespace rivals {

void pointsWithin(const reference::Scene& scene, const Pose& X_WP, double reach,
                  std::vector<NearPoint>& found) {
  const reference::Solid& solid = scene.solid;
  found.clear();
  for (const Vec3& r_P : scene.shell.points) {
    const Vec3 r_W = X_WP.linear() * r_P, p_W = X_WP.translation() + r_W;
    const double F = solid.value(p_W);
    if (solid.farOutside(F, reach)) continue;
    const Vec3 gradient_W = solid.gradient(p_W);
    const double slope = gradient_W.norm();
    if (slope == 0.0) continue;
    const double gap = (solid.isovalue() - F) / slope;
    if (gap <= reach) found.push_back({r_W, -gradient_W / slope, gap});
  }
}

}  // namespace rivals
