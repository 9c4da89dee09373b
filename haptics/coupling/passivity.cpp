// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/coupling/passivity.h"

#include <algorithm>
#include <cmath>

namespace haptics {

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

Wrench damped(const Wrench& wrench, const Twist& motion, double period, double damping,
              double gyration) HAPTICS_RT {
  if (wrench.force.isZero(0.0) && wrench.torque.isZero(0.0)) return wrench;
  return {wrench.force - (damping / period) * motion.linear,
          wrench.torque - (damping * gyration * gyration / period) * motion.angular};
}

}  // namespace haptics
