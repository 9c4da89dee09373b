// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/sweep.h"

#include <algorithm>

namespace haptics {

Crossing firstCrossing(const Isosurface& solid, const PointPath& path, double from, double to,
                       double start_value, const Tolerances& lengths, Budget& budget) HAPTICS_RT {
  const ScalarField& field = solid.field;
  const double ceiling = solid.ceiling(), h = field.voxel(), speed = path.speed();
  if (speed <= 0.0) return {to, false};
  const double longest = std::min(path.chordTime(lengths.sagitta), 1.5 * h / speed);
  double t = from;
  while (t < to) {
    const Vec3 u = field.indexOf(path.at(t));
    budget.spend();
    const MaxPyramid::Bound bound = field.pyramid().bound(u, ceiling);
    if (bound.lipschitz == 0.0) {
      t += bound.radius / speed;
      continue;
    }
    const double dt = std::min(longest, to - t);
    // a path stays within the sagitta of its chord, and F within this much of the chord's; a
    // point that already stands there may slide or leave, but go no deeper
    const double guard = bound.lipschitz * path.sagitta(dt);
    const double level =
        std::min(ceiling, std::max(ceiling - guard, start_value + field.roundingMargin()));
    // conservative advancement where the field is far below
    budget.spend(field.work());
    const double ahead = (level - guard - field.value(u)) / bound.lipschitz;
    if (ahead > 0.75 * h) {
      t += std::min(ahead, bound.radius) / speed;
      continue;
    }
    const Vec3 u_end = field.indexOf(path.at(t + dt));
    const double tolerance = lengths.root / std::max(speed * dt, lengths.root);
    const double reach = field.firstReach(u, u_end, level, tolerance, budget);
    if (reach <= 1.0) return {t + reach * dt, true};
    t += dt;
    if (!budget.left()) return {std::min(t, to), false};
  }
  return {to, false};
}

Impact sweep(const Isosurface& solid, const Clearance& near, const Pose& X_WP, const Twist& motion,
             const Tolerances& lengths, Budget& budget) HAPTICS_RT {
  Impact impact;
  const double v = motion.linear.norm(), w = motion.angular.norm();
  int met = -1;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const NearPoint& point = near.near(i);
    const double speed = v + w * point.r_W.norm();
    if (speed <= 0.0) continue;
    // nothing can happen to it before its clearance is used up
    const double earliest = point.free / speed;
    if (earliest >= impact.time) continue;
    if (!budget.left()) {
      impact = {earliest, false, {}};
      met = -1;
      continue;
    }
    const PointPath path{X_WP.translation(), point.r_W, motion};
    const Crossing crossing =
        firstCrossing(solid, path, earliest, impact.time, point.value, lengths, budget);
    if (crossing.time < impact.time) {
      impact.time = crossing.time;
      impact.met = crossing.met;
      met = crossing.met ? static_cast<int>(i) : -1;
    }
  }
  if (met >= 0) {
    // the exact normal of the cell in which the first point was met
    const NearPoint& point = near.near(static_cast<std::size_t>(met));
    const PointPath path{X_WP.translation(), point.r_W, motion};
    // just beyond the crossing, so that a crossing on a face belongs to the cell behind it
    const double beyond = lengths.root / path.speed();
    const Vec3 u = solid.field.indexOf(path.at(impact.time + beyond));
    const FieldSample beyond_it = solid.field.sample(u);
    const double slope = beyond_it.gradient_W.norm();
    budget.spend(solid.field.work());
    Contact& contact = impact.contact;
    contact.point = point.point;
    contact.r_W = point.r_W;
    contact.p_W = X_WP.translation() + point.r_W;
    if (slope > 0.0) {
      contact.n_W = -beyond_it.gradient_W / slope;
      contact.gap = (solid.ceiling() - beyond_it.value) / slope +
                    contact.n_W.dot(contact.p_W - path.at(impact.time + beyond));
    }
  }
  return impact;
}

}  // namespace haptics
