// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rivals/static_god_object.h"

#include <algorithm>
#include <cmath>

#include "app/study/reference/motion.h"

namespace rivals {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kStill = 1e-9;  // m: a motion that is none

/// The motion nearest to `free` that no point forbids. Only the rows that it meets are projected
/// on: each time the one that is broken most is added.
Twist constrained(const Twist& free, const std::vector<NearPoint>& near, double skin,
                  const reference::MassMetric& M, GodObjectState& state) {
  std::vector<reference::Row> rows;
  Twist motion = free;
  while (rows.size() < near.size()) {
    double least = -kStill;
    reference::Row broken;
    for (const NearPoint& point : near) {
      const reference::Row row{point.n_W, point.r_W, skin - point.gap};
      const double excess = reference::excess(row, motion);
      if (excess >= least) continue;
      least = excess;
      broken = row;
    }
    if (least == -kStill) break;
    rows.push_back(broken);
    motion = reference::constrainedMotion(free, rows, M, &state.pivots);
  }
  state.contacts = static_cast<int>(rows.size());
  return motion;
}

/// The motion to where the coupling and the springs of the points inside are in equilibrium.
Twist balanced(const Twist& free, const std::vector<NearPoint>& near, double skin, double penalty,
               const reference::MassMetric& M, GodObjectState& state) {
  Matrix6 A = Matrix6::Zero();
  A.topLeftCorner<3, 3>().diagonal().setConstant(M.mass);
  A.bottomRightCorner<3, 3>() = M.inertia_W;
  Vector6 b;
  b << M.mass * free.linear, M.inertia_W * free.angular;
  state.contacts = 0;
  for (const NearPoint& point : near) {
    if (point.gap >= 0.0) continue;
    Vector6 row;
    row << point.n_W, point.r_W.cross(point.n_W);
    A += penalty * row * row.transpose();
    b += penalty * (skin - point.gap) * row;
    ++state.contacts;
  }
  const Vector6 motion = A.ldlt().solve(b);
  return {motion.head<3>(), motion.tail<3>()};
}

}  // namespace

Wrench godObjectTick(const reference::Scene& scene, const GodObjectSettings& settings,
                     const Pose& X_WD, GodObjectState& state) {
  const double voxel = scene.solid.volume().grid.spacing.minCoeff();
  const double stride = settings.stride * voxel, skin = settings.skin * voxel;
  state.sub_steps = 0;
  while (state.sub_steps < settings.sub_steps) {
    ++state.sub_steps;
    const Twist free = reference::unconstrainedMotion(state.X_WP, X_WD);
    pointsWithin(scene, state.X_WP, stride + skin, state.near);
    const auto M = reference::massMetric(state.X_WP, scene.shell.inertia);
    const bool inside =
        std::ranges::any_of(state.near, [](const NearPoint& point) { return point.gap < 0.0; });
    Twist motion = inside ? balanced(free, state.near, skin, settings.penalty, M, state)
                          : constrained(free, state.near, skin, M, state);
    const double length = reference::pathBound(motion, scene.shell.radius);
    if (length < kStill) break;
    state.X_WP = reference::moved(state.X_WP, motion, std::min(1.0, stride / length));
  }
  return reference::pull(scene, state.X_WP, X_WD);
}

}  // namespace rivals
