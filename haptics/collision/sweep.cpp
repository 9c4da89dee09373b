// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptics {
namespace {

/// A cubic on [0, 1] by its Bernstein coefficients; their hull contains it.
struct Cubic {
  double b0, b1, b2, b3;
  double greatest() const HAPTICS_RT { return std::max(std::max(b0, b1), std::max(b2, b3)); }
};

/// The cell's field along the segment a→b of index coordinates. A trilinear function is its own
/// blossom in each coordinate, so the inner coefficients are means over the mixed corners of the
/// segment's box.
Cubic alongSegment(const Cell& cell, const Vec3& a, const Vec3& b) HAPTICS_RT {
  const double x[2] = {a.x() - double(cell.at[0]), b.x() - double(cell.at[0])};
  const double y[2] = {a.y() - double(cell.at[1]), b.y() - double(cell.at[1])};
  const double z[2] = {a.z() - double(cell.at[2]), b.z() - double(cell.at[2])};
  const auto& c = cell.corner;
  double f[2][2][2];  // [x][y][z]
  for (int ix = 0; ix < 2; ++ix) {
    const double c00 = c[0] + x[ix] * (c[1] - c[0]), c10 = c[2] + x[ix] * (c[3] - c[2]);
    const double c01 = c[4] + x[ix] * (c[5] - c[4]), c11 = c[6] + x[ix] * (c[7] - c[6]);
    for (int iy = 0; iy < 2; ++iy) {
      const double d0 = c00 + y[iy] * (c10 - c00), d1 = c01 + y[iy] * (c11 - c01);
      for (int iz = 0; iz < 2; ++iz) f[ix][iy][iz] = d0 + z[iz] * (d1 - d0);
    }
  }
  return {f[0][0][0], (f[1][0][0] + f[0][1][0] + f[0][0][1]) / 3.0,
          (f[1][1][0] + f[1][0][1] + f[0][1][1]) / 3.0, f[1][1][1]};
}

/// The left end of the first piece, no longer than `tolerance`, on which the cubic's hull reaches
/// `level`; 2 if there is none.
double firstReach(const Cubic& f, double level, double from, double to,
                  double tolerance) HAPTICS_RT {
  if (f.greatest() < level) return 2.0;
  if (f.b0 >= level || to - from <= tolerance) return from;
  const double m01 = 0.5 * (f.b0 + f.b1), m12 = 0.5 * (f.b1 + f.b2), m23 = 0.5 * (f.b2 + f.b3);
  const double m012 = 0.5 * (m01 + m12), m123 = 0.5 * (m12 + m23);
  const double middle = 0.5 * (m012 + m123), half = 0.5 * (from + to);
  const double left = firstReach({f.b0, m01, m012, middle}, level, from, half, tolerance);
  if (left <= 1.0) return left;
  return firstReach({middle, m123, m23, f.b3}, level, half, to, tolerance);
}

/// The fraction of the segment a→b (index coordinates) at which F first reaches `level`; 2 if it
/// does not. Walks the cells between.
double firstReachOnSegment(const ScalarField& field, const Vec3& a, const Vec3& b, double level,
                           double tolerance, Budget& budget) HAPTICS_RT {
  const Vec3 d = b - a;
  std::array<std::int64_t, 3> at;
  std::array<int, 3> step;
  Vec3 next, stride;
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::clamp(std::floor(a[axis]), -1e15, 1e15);
    at[axis] = static_cast<std::int64_t>(cell);
    step[axis] = d[axis] > 0.0 ? 1 : -1;
    if (d[axis] == 0.0) {
      next[axis] = stride[axis] = std::numeric_limits<double>::infinity();
      continue;
    }
    stride[axis] = 1.0 / std::abs(d[axis]);
    next[axis] = (d[axis] > 0.0 ? cell + 1.0 - a[axis] : a[axis] - cell) * stride[axis];
  }
  double from = 0.0;
  while (from < 1.0) {
    int axis = 0;
    if (next[1] < next[axis]) axis = 1;
    if (next[2] < next[axis]) axis = 2;
    const double to = std::min(1.0, next[axis]);
    if (to > from) {
      budget.spend();
      const double t = firstReach(alongSegment(field.cellAt(at), a + from * d, a + to * d), level,
                                  from, to, tolerance);
      if (t <= 1.0) return t;
      from = to;
    }
    if (next[axis] >= 1.0) break;
    at[axis] += step[axis];
    next[axis] += stride[axis];
  }
  return 2.0;
}

}  // namespace

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
    budget.spend();
    const double ahead = (level - guard - field.value(u)) / bound.lipschitz;
    if (ahead > 0.75 * h) {
      t += std::min(ahead, bound.radius) / speed;
      continue;
    }
    const Vec3 u_end = field.indexOf(path.at(t + dt));
    const double tolerance = lengths.root / std::max(speed * dt, lengths.root);
    const double reach = firstReachOnSegment(field, u, u_end, level, tolerance, budget);
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
    const Cell cell = solid.field.cellAround(u);
    const Vec3 gradient = solid.field.worldGradient(cell.gradient(u));
    const double slope = gradient.norm();
    budget.spend();
    Contact& contact = impact.contact;
    contact.point = point.point;
    contact.r_W = point.r_W;
    contact.p_W = X_WP.translation() + point.r_W;
    if (slope > 0.0) {
      contact.n_W = -gradient / slope;
      contact.gap = (solid.ceiling() - cell.value(u)) / slope +
                    contact.n_W.dot(contact.p_W - path.at(impact.time + beyond));
    }
  }
  return impact;
}

}  // namespace haptics
