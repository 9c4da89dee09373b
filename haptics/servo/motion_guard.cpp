// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/motion_guard.h"

#include <algorithm>

#include "haptics/coupling/passivity.h"

namespace haptics {

ForceReason MotionGuard::judge(const Pose& X_BD, std::int64_t time_ns) HAPTICS_RT {
  // s: samples taken in a row tell no speed, so the place is kept until it is that old
  constexpr double kLeastStep = 5e-4;
  constexpr auto kCalmNs = static_cast<std::int64_t>(kCalm * 1e9);
  if (!X_BD.matrix().allFinite()) return fast_ ? ForceReason::TooFast : ForceReason::None;
  if (begun_ && time_ns == time_ns_) return fast_ ? ForceReason::TooFast : ForceReason::None;
  const Twist motion = begun_ ? motionBetween(X_BD_, X_BD) : Twist{};
  const double passed = double(time_ns - time_ns_) * 1e-9, step = std::max(kLeastStep, passed);
  const double speed = motion.linear.norm() / step;
  const bool jumped = begun_ && (speed > kJump || motion.angular.norm() / step > kSpin);
  if (begun_ && !jumped && passed >= 0.0 && passed < kLeastStep)
    return fast_ ? ForceReason::TooFast : ForceReason::None;
  X_BD_ = X_BD;
  time_ns_ = time_ns;
  begun_ = true;
  if (jumped) return ForceReason::Jump;
  if (speed > kFastest || (fast_ && speed > 0.5 * kFastest)) {
    fast_ = true;
    fast_ns_ = time_ns;
  } else if (fast_ && time_ns - fast_ns_ > kCalmNs) {
    fast_ = false;
  }
  return fast_ ? ForceReason::TooFast : ForceReason::None;
}

}  // namespace haptics
