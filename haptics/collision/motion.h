// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// The path of one shell point while the tool moves by a twist in unit time, [Chan 2011], (2):
/// p(t) = c + v t + R(w t) r.
class PointPath {
 public:
  /// c_W: the tool's origin at the start; r_W: vector from it to the point, in W.
  PointPath(const Vec3& c_W, const Vec3& r_W, const Twist& motion) HAPTICS_RT
      : v_{motion.linear},
        angle_{motion.angular.norm()} {
    if (angle_ > 0.0) {
      const Vec3 axis = motion.angular / angle_;
      const Vec3 along = axis * axis.dot(r_W);
      centre_ = c_W + along;
      across_ = r_W - along;
      ahead_ = axis.cross(r_W);
    } else {
      centre_ = c_W;
      across_ = r_W;
      ahead_ = Vec3::Zero();
    }
    arm_ = across_.norm();
    speed_ = v_.norm() + angle_ * arm_;
  }
  Vec3 at(double t) const HAPTICS_RT {
    if (angle_ == 0.0) return centre_ + v_ * t + across_;
    return centre_ + v_ * t + std::cos(angle_ * t) * across_ + std::sin(angle_ * t) * ahead_;
  }
  /// Bound on the distance travelled in unit time [m].
  double speed() const HAPTICS_RT { return speed_; }

 private:
  Vec3 centre_, v_, across_, ahead_;
  double angle_, arm_, speed_;
};

/// Bound [m] on the distance from its chord of a point at a distance `arm` [m] from the tool's
/// origin, while the tool turns by `angle` [rad]. It is the sagitta of the arc; translation does
/// not increase it.
inline double sagitta(double arm, double angle) HAPTICS_RT { return arm * angle * angle / 8.0; }

/// The pose after a fraction t of the motion.
inline Pose moved(const Pose& X_WP, const Twist& motion, double t) HAPTICS_RT {
  const double angle = motion.angular.norm();
  Quat q{X_WP.linear()};
  if (angle > 0.0) q = Quat{Eigen::AngleAxisd{angle * t, Vec3{motion.angular / angle}}} * q;
  // the matrix is made from the quaternion, so it is orthonormal after every step
  q.normalize();
  Pose X = Pose::Identity();
  X.linear() = q.toRotationMatrix();
  X.translation() = X_WP.translation() + t * motion.linear;
  return X;
}

}  // namespace haptics
