// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/motion.h"

#include <cmath>

namespace reference {

Twist unconstrainedMotion(const Pose& X_WP, const Pose& X_WD) {
  const Quat turn = haptics::rotationOf(X_WD) * haptics::rotationOf(X_WP).conjugate();
  // the logarithm, from the half that turns by at most pi
  const double sign = turn.w() < 0.0 ? -1.0 : 1.0;
  const Vec3 axis = sign * turn.vec();
  const double size = axis.norm();
  const double angle = 2.0 * std::atan2(size, sign * turn.w());
  return {.linear = X_WD.translation() - X_WP.translation(),
          .angular = size > 0.0 ? Vec3{axis * (angle / size)} : Vec3::Zero()};
}

Pose moved(const Pose& X_WP, const Twist& motion, double t) {
  if (t == 0.0) return X_WP;
  Quat rotation = haptics::rotationOf(X_WP);
  const double angle = motion.angular.norm() * t;
  if (angle > 0.0) rotation = Eigen::AngleAxisd{angle, motion.angular.normalized()} * rotation;
  return haptics::poseOf(X_WP.translation() + motion.linear * t, rotation);
}

double pathBound(const Twist& motion, double radius) {
  return motion.linear.norm() + radius * motion.angular.norm();
}

}  // namespace reference
