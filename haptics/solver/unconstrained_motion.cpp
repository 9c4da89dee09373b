// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/solver/unconstrained_motion.h"

#include <cmath>
#include <numbers>

namespace haptics {

Vec3 unwrappedTurn(const Pose& from, const Pose& to, const Vec3& last) HAPTICS_RT {
  constexpr double kWholeTurn = 2.0 * std::numbers::pi;
  Quat q = Quat{to.linear()} * Quat{from.linear()}.conjugate();
  q.normalize();
  const double sine = q.vec().norm();
  // a whole turn away, rounding alone would choose the axis
  const double before = last.norm();
  if (sine < (before > std::numbers::pi ? 1e-9 : 1e-300)) {
    // no rotation, or whole turns of the last axis
    const double turns = std::round(before / kWholeTurn);
    return turns > 0.0 ? Vec3{last * (turns * kWholeTurn / before)} : Vec3::Zero();
  }
  const double angle = 2.0 * std::atan2(sine, q.w());  // in [0, 2 pi]
  const Vec3 axis = q.vec() / sine;
  // along this axis every angle + k 2 pi is the same rotation
  const double k = std::round((last.dot(axis) - angle) / kWholeTurn);
  return axis * (angle + k * kWholeTurn);
}

Twist unconstrainedMotion(const Pose& X_WP, const Pose& X_WD, Vec3& turn) HAPTICS_RT {
  turn = unwrappedTurn(X_WP, X_WD, turn);
  return {X_WD.translation() - X_WP.translation(), turn};
}

}  // namespace haptics
