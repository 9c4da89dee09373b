// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "app/study/rivals/near_points.h"

namespace rivals {

/// What [McNeely 1999] leaves to whoever uses it. The defaults are the best that the sweep of
/// README.md found.
struct PenaltySettings {
  double point_stiffness = 30'000.0;  ///< N/m of a point that is inside
  double mass = 0.05;                 ///< kg of the tool
  double damping = 1.0;               ///< of the coupling, as a share of the critical
  double braking = 0.2;               ///< of what points approach with, likewise
  double layer = 0.25;                ///< voxels outside the surface, from which points push
  int sub_steps = 4;                  ///< integration steps in a tick
};

/// What one tick leaves to the next.
struct PenaltyState {
  Pose X_WP = Pose::Identity();
  Twist velocity = {};            ///< m/s, rad/s
  std::optional<Pose> X_WD = {};  ///< of the last tick
  std::vector<NearPoint> touching = {};
};

/// A tick of `period` seconds of the penalty method of [McNeely 1999] with the field in place of
/// the voxel map: each point that is inside pushes along the field's normal by its depth; with more
/// than ten of them they push with the stiffness of ten. A tool with mass moves under that push and
/// the coupling's spring and damper, and the hand feels the coupling.
Wrench penaltyTick(const reference::Scene& scene, const PenaltySettings& settings, double period,
                   const Pose& X_WD, PenaltyState& state);

}  // namespace rivals
