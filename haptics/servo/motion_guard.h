// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/snapshot.h"

namespace haptics {

/// Judges how the handle moved between two readings, in the base. A hand under force moves at most
/// some tenths of a m/s: above kFastest the device is running away and is let go of, until it has
/// been slower than half of that for kCalm. No hand moves it as fast as kJump or turns it as
/// fast as kSpin: then a reading is wrong.
class MotionGuard {
 public:
  static constexpr double kFastest = 1.5;  ///< m/s
  static constexpr double kJump = 10.0;    ///< m/s
  static constexpr double kSpin = 150.0;   ///< rad/s
  static constexpr double kCalm = 0.05;    ///< s

  /// None, TooFast or Jump. `time_ns`: when it was measured; a time that was judged already gives
  /// the same answer again, but for Jump.
  ForceReason judge(const Pose& X_BD, std::int64_t time_ns) HAPTICS_RT;

 private:
  Pose X_BD_ = Pose::Identity();
  std::int64_t time_ns_ = 0;
  std::int64_t fast_ns_ = 0;  ///< when it was last too fast
  bool begun_ = false;
  bool fast_ = false;
};

}  // namespace haptics
