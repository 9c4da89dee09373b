// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/snapshot.h"

namespace haptics {

/// Judges the motion of the handle between two readings, in B. A hand under force moves at most
/// some tenths of a m/s. Above kFastest the device is running away; the force is zero until it has
/// been slower than half of kFastest for kCalm. No hand is as fast as kJump or kSpin; such a
/// reading is wrong.
class MotionGuard {
 public:
  static constexpr double kFastest = 1.5;  ///< m/s
  static constexpr double kJump = 10.0;    ///< m/s
  static constexpr double kSpin = 150.0;   ///< rad/s
  static constexpr double kCalm = 0.05;    ///< s

  /// Returns None, TooFast or Jump. `time_ns`: time of the measurement. The same time again gives
  /// the same answer, except that Jump is returned once.
  ForceReason judge(const Pose& X_BD, std::int64_t time_ns) HAPTICS_RT;

 private:
  Pose X_BD_ = Pose::Identity();
  std::int64_t time_ns_ = 0;
  std::int64_t fast_ns_ = 0;  ///< when the handle was last too fast
  bool begun_ = false;
  bool fast_ = false;
};

}  // namespace haptics
