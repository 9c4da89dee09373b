// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/grip.h"

namespace haptics {
namespace {

/// Dry friction takes away so much speed, and never turns a motion round.
Vec3 slowed(const Vec3& v, double by) HAPTICS_RT {
  const double speed = v.norm();
  return speed > by ? Vec3{v * (1.0 - by / speed)} : Vec3::Zero();
}

}  // namespace

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
    const Twist before = velocity;
    velocity.linear = (velocity.linear + pull * (dt / mass)) * keep;
    if (coulomb > 0.0) velocity.linear = slowed(velocity.linear, coulomb * dt / mass);
    // by the mean velocity: the new one alone would bring the motion forward by half a step, a
    // twentieth of a period, and a sampled spring would seem stable a tenth beyond its limit
    X_WD.translation() += 0.5 * (before.linear + velocity.linear) * dt;

    const Eigen::AngleAxisd away{Quat{X_WH.linear()} * q.conjugate()};
    const Vec3 twist = turn_stiffness * away.angle() * away.axis() + felt_W.torque;
    velocity.angular = (velocity.angular + twist * (dt * inverse_inertia)) * keep;
    if (coulomb > 0.0)
      velocity.angular = slowed(velocity.angular, coulomb * gyration * dt * inverse_inertia);
    const Vec3 turn = 0.5 * (before.angular + velocity.angular) * dt;
    const double angle = turn.norm();
    if (angle > 0.0) q = Quat{Eigen::AngleAxisd{angle, turn / angle}} * q;
    q.normalize();
  }
  X_WD.linear() = q.toRotationMatrix();
}

}  // namespace haptics
