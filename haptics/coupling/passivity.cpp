// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/coupling/passivity.h"

#include <algorithm>
#include <cmath>

namespace haptics {
namespace {

constexpr double kSlow = 0.008;     // s: the time constant of 20 Hz
constexpr double kWindow = 0.1;     // s
constexpr double kMostMade = 6e-4;  // J
constexpr double kMostTurns = 6.0;
constexpr double kBetween = 0.02;  // s between two lowerings
constexpr double kLowered = 0.8;
constexpr double kLeastShare = 0.2;
constexpr double kShort = 0.05, kLong = 0.2;  // s
constexpr double kLasting = 0.8;

}  // namespace

Twist motionBetween(const Pose& X_from, const Pose& X_to) HAPTICS_RT {
  const Eigen::AngleAxisd turn{X_to.linear() * X_from.linear().transpose()};
  return {X_to.translation() - X_from.translation(), turn.angle() * turn.axis()};
}

void PassivityObserver::add(const Wrench& held, const Twist& motion) HAPTICS_RT {
  const double work = held.force.dot(motion.linear) + held.torque.dot(motion.angular);
  if (std::isfinite(work)) energy_ += work;
}

Wrench PassivityController::pass(const Wrench& wanted, const Twist& motion,
                                 double period) HAPTICS_RT {
  if (!torque_) held_.torque.setZero();
  observer_.add(held_, motion);
  Wrench wrench = wanted;
  if (observer_.energy() > 0.0) {
    // |v|^2 + |gyration w|^2: b times it is the power that a damper of b takes
    double squares = motion.linear.squaredNorm();
    if (torque_) squares += gyration_ * gyration_ * motion.angular.squaredNorm();
    squares /= period * period;
    if (squares > 0.0) {
      const double damping = std::min(most_damping_, observer_.energy() / (period * squares));
      wrench.force -= (damping / period) * motion.linear;
      if (torque_) wrench.torque -= (damping * gyration_ * gyration_ / period) * motion.angular;
    }
  }
  held_ = wrench;
  return wrench;
}

void PassivityGuard::add(const Wrench& held, const Pose& X_WD, double scale,
                         double period) HAPTICS_RT {
  if (!X_WD.matrix().allFinite() || !(scale > 0.0)) return;
  // a reading that came again is no motion, and the next one is that of two ticks
  at_.waited += period;
  if (at_.begun && (X_WD.matrix().array() == at_.X_WD.matrix().array()).all() && at_.waited < kSlow)
    return;
  const double step = at_.waited, ticks = step / period;
  at_.waited = 0.0;
  Twist motion = at_.begun ? motionBetween(at_.X_WD, X_WD) : Twist{};
  motion.linear /= scale;
  at_.X_WD = X_WD;
  at_.begun = true;
  const double share = step / (kSlow + step);
  at_.slow_motion.linear += share * (motion.linear / ticks - at_.slow_motion.linear);
  at_.slow_motion.angular += share * (motion.angular / ticks - at_.slow_motion.angular);
  at_.slow_wrench.force += share * (held.force - at_.slow_wrench.force);
  at_.slow_wrench.torque += share * (held.torque - at_.slow_wrench.torque);
  const Vec3 shaken = motion.linear - ticks * at_.slow_motion.linear;
  const Vec3 turned = motion.angular - ticks * at_.slow_motion.angular;
  const double left = 1.0 - step / kWindow;
  at_.made = left * at_.made + (held.force - at_.slow_wrench.force).dot(shaken) +
             (held.torque - at_.slow_wrench.torque).dot(turned);
  const double along = held.force.dot(shaken) + held.torque.dot(turned);
  at_.turns *= left;
  if (along * at_.direction < 0.0) at_.turns += 1.0;
  at_.power += step / kShort * (std::abs(along) / ticks - at_.power);
  at_.power_before += step / kLong * (std::abs(along) / ticks - at_.power_before);
  if (along != 0.0) at_.direction = along > 0.0 ? 1.0 : -1.0;
  at_.since += step;
  const bool lasts = at_.power > kLasting * at_.power_before;
  if (lasts && at_.made > kMostMade && at_.turns > kMostTurns && at_.since > kBetween) {
    at_.share = std::max(kLeastShare, kLowered * at_.share);
    at_.since = 0.0;
  }
}

Wrench damped(const Wrench& wrench, const Twist& motion, double period, double damping,
              double gyration) HAPTICS_RT {
  if (wrench.force.isZero(0.0) && wrench.torque.isZero(0.0)) return wrench;
  return {wrench.force - (damping / period) * motion.linear,
          wrench.torque - (damping * gyration * gyration / period) * motion.angular};
}

}  // namespace haptics
