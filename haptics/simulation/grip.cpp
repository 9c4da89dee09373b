// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/grip.h"

namespace haptics {

void Grip::advance(const Pose& X_WH, const Wrench& felt_W, double period) HAPTICS_RT {
  constexpr int kSteps = 10;
  const double dt = period / kSteps;
  // implicit in the damper, so that a light grip cannot ring by itself
  const double keep = 1.0 / (1.0 + damping * dt / mass);
  const double inverse_inertia = 1.0 / (mass * gyration * gyration);
  const double turn_stiffness = stiffness * gyration * gyration;
  Quat q{X_WD.linear()};
  for (int step = 0; step < kSteps; ++step) {
    const Vec3 pull = stiffness * (X_WH.translation() - X_WD.translation()) + felt_W.force;
    velocity.linear = (velocity.linear + pull * (dt / mass)) * keep;
    X_WD.translation() += velocity.linear * dt;

    const Eigen::AngleAxisd away{Quat{X_WH.linear()} * q.conjugate()};
    const Vec3 twist = turn_stiffness * away.angle() * away.axis() + felt_W.torque;
    velocity.angular = (velocity.angular + twist * (dt * inverse_inertia)) * keep;
    const double angle = velocity.angular.norm() * dt;
    if (angle > 0.0) q = Quat{Eigen::AngleAxisd{angle, velocity.angular.normalized()}} * q;
    q.normalize();
  }
  X_WD.linear() = q.toRotationMatrix();
}

}  // namespace haptics
