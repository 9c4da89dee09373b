// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rivals/penalty.h"

#include <algorithm>
#include <cmath>

#include "app/study/reference/motion.h"

namespace rivals {
namespace {

constexpr double kFullPoints = 10.0;  // more share the stiffness of so many
constexpr double kMostVoxels = 2.0;   // depth beyond which nothing pushes harder

double critical(double stiffness, double mass) { return 2.0 * std::sqrt(stiffness * mass); }

/// What the points push the tool with.
Wrench pushOf(const std::vector<NearPoint>& touching, const PenaltySettings& settings, double layer,
              double most, const Twist& velocity) {
  const double brake = settings.braking *
                       critical(kFullPoints * settings.point_stiffness, settings.mass) /
                       kFullPoints;
  Wrench push;
  for (const NearPoint& point : touching) {
    const double depth = std::min(layer - point.gap, most);
    const double approach = -point.n_W.dot(velocity.linear + velocity.angular.cross(point.r_W));
    const double size = settings.point_stiffness * depth + brake * std::max(0.0, approach);
    push.force += size * point.n_W;
    push.torque += size * point.r_W.cross(point.n_W);
  }
  const double share = std::min(1.0, kFullPoints / std::max(1.0, double(touching.size())));
  push.force *= share;
  push.torque *= share;
  return push;
}

}  // namespace

Wrench penaltyTick(const reference::Scene& scene, const PenaltySettings& settings, double period,
                   const Pose& X_WD, PenaltyState& state) {
  const double h = period / settings.sub_steps;
  const double damper = settings.damping * critical(scene.stiffness, settings.mass);
  const double voxel = scene.solid.volume().grid.spacing.minCoeff();
  const double layer = settings.layer * voxel, most = kMostVoxels * voxel;
  const Pose X_from = state.X_WD.value_or(X_WD);
  const Twist way = reference::unconstrainedMotion(X_from, X_WD);
  Wrench felt;
  for (int n = 1; n <= settings.sub_steps; ++n) {
    const Pose X_to = reference::moved(X_from, way, double(n) / settings.sub_steps);
    pointsWithin(scene, state.X_WP, layer, state.touching);
    const Wrench push = pushOf(state.touching, settings, layer, most, state.velocity);
    const Mat3 inertia_W = reference::massMetric(state.X_WP, scene.shell.inertia).inertia_W;
    const auto coupled = [&] {
      Wrench wrench = reference::pull(scene, state.X_WP, X_to);
      wrench.force -= damper * (way.linear / period - state.velocity.linear);
      wrench.torque -= damper * inertia_W * (way.angular / period - state.velocity.angular);
      return wrench;
    };
    // what the hand feels is what the tool does not
    const Wrench held = coupled();
    state.velocity.linear += h / settings.mass * (push.force - held.force);
    state.velocity.angular += h / settings.mass * inertia_W.ldlt().solve(push.torque - held.torque);
    state.X_WP =
        reference::moved(state.X_WP, {h * state.velocity.linear, h * state.velocity.angular}, 1.0);
    felt = coupled();
  }
  state.X_WD = X_WD;
  return felt;
}

}  // namespace rivals
