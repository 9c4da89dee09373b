// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/clearance.h"

#include <algorithm>

namespace haptics {

void Clearance::forget() HAPTICS_RT {
  std::fill(until_.begin(), until_.end(), 0.0);
  translated_ = rotated_ = 0.0;
  found_ = 0;
}

Clearance::Verdict Clearance::collect(const Isosurface& solid, const PointShell& shell,
                                      const Pose& X_WP, double reach, Budget& budget) HAPTICS_RT {
  const ScalarField& field = solid.field;
  const double ceiling = solid.ceiling();
  const Mat3 R = X_WP.linear();
  const Vec3 c = X_WP.translation();
  found_ = 0;
  for (std::size_t i = 0; i < shell.points.size(); ++i) {
    const double travelled = translated_ + rotated_ * shell.points[i].norm();
    if (until_[i] - travelled >= reach) continue;
    if (!budget.left()) return Verdict::Cut;
    budget.spend();
    const Vec3 r = R * shell.points[i];
    const Vec3 u = field.indexOf(c + r);
    const MaxPyramid::Bound bound = field.pyramid().bound(u, ceiling);
    double free = bound.radius;
    if (bound.lipschitz > 0.0) {
      budget.spend(field.work());
      const FieldSample here = field.sample(u);
      const double value = here.value;
      free = std::clamp((ceiling - value) / bound.lipschitz, 0.0, bound.radius);
      if (value >= ceiling) return Verdict::Inside;
      if (free < reach) {
        NearPoint& near = near_[found_++];
        near.point = static_cast<int>(i);
        near.r_W = r;
        near.u = u;
        near.value = value;
        near.free = free;
        near.gradient_W = here.gradient_W;
      }
    } else if (free < reach) {
      NearPoint& near = near_[found_++];
      near.point = static_cast<int>(i);
      near.r_W = r;
      near.u = u;
      near.value = field.value(u);
      near.free = free;
      near.gradient_W.setZero();
    }
    until_[i] = free + travelled;
  }
  return Verdict::Legal;
}

}  // namespace haptics
