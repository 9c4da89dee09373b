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
  /// c: the tool's origin at the start; r_W: the point about it, written in W.
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
  /// Bound on how far the path leaves its chord over a time dt [m].
  double sagitta(double dt) const HAPTICS_RT {
    const double turned = angle_ * dt;
    return arm_ * turned * turned / 8.0;
  }
  /// The longest dt whose chord keeps within `sagitta` [m]; infinite for a straight path.
  double chordTime(double sagitta) const HAPTICS_RT {
    const double bend = arm_ * angle_ * angle_ / 8.0;
    return bend > 0.0 ? std::sqrt(sagitta / bend) : INFINITY;
  }

 private:
  Vec3 centre_, v_, across_, ahead_;
  double angle_, arm_, speed_;
};

/// The pose after a fraction t of the motion.
inline Pose moved(const Pose& X_WP, const Twist& motion, double t) HAPTICS_RT {
  const double angle = motion.angular.norm();
  Quat q{X_WP.linear()};
  if (angle > 0.0) q = Quat{Eigen::AngleAxisd{angle * t, Vec3{motion.angular / angle}}} * q;
  // orthonormal again at every step: the quaternion is the state, the matrix its picture
  q.normalize();
  Pose X = Pose::Identity();
  X.linear() = q.toRotationMatrix();
  X.translation() = X_WP.translation() + t * motion.linear;
  return X;
}

}  // namespace haptics
