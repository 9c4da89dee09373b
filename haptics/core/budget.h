// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <ctime>
#include <limits>

#include "haptics/core/realtime.h"

namespace haptics {

/// What a tick did, counted for those who measure it: nothing is decided by it.
struct Counts {
  std::int64_t samples = 0;    ///< look-ups of F: of a value, or of a cell and the bounds in it
  std::int64_t gradients = 0;  ///< of whatever kind; six look-ups more if by central differences
  std::int64_t pivots = 0;     ///< rows that entered or left an active set
  std::int64_t sub_steps = 0;  ///< motions tried
};

/// What a tick may spend. One unit of work is some 10 ns: a point looked at among sixteen, or a
/// quarter of a cell fetched alone. Two clocks, one interface: counted work, which repeats exactly,
/// and the thread's CPU time for the live loop. To ask is work too, so that no two questions are
/// asked at the same count: a tick that was cut live is cut at the same place by the count at
/// which it was.
class Budget {
 public:
  /// As much work as this, whatever the time.
  static Budget counted(std::int64_t work) { return Budget{work, 0}; }
  /// CPU time of the calling thread from now on [ns]; starts the clock.
  static Budget timed(std::int64_t nanoseconds) HAPTICS_RT {
    return Budget{std::numeric_limits<std::int64_t>::max(), threadTime() + nanoseconds};
  }

  void spend(std::int64_t work = 1) HAPTICS_RT { spent_ += work; }
  /// What was done meanwhile: kept by hand where it is done, beside spend().
  Counts counts;
  /// False once the budget is used up, and from then on.
  bool left() HAPTICS_RT {
    if (cut_) return false;
    ++spent_;
    bool used_up = spent_ >= work_;
    // the clock costs as much as thirty units of work: look at it only now and then
    if (deadline_ != 0 && spent_ >= next_look_) {
      next_look_ = spent_ + 400;
      used_up = used_up || threadTime() >= deadline_;
    }
    if (!used_up) return true;
    cut_ = true;
    cut_at_ = spent_;
    return false;
  }
  std::int64_t spent() const HAPTICS_RT { return spent_; }
  /// Whether it was used up.
  bool cut() const HAPTICS_RT { return cut_; }
  /// The count at which it was found to be, 0 if it was not: as much counted work is cut at the
  /// same place. What is under way then is finished, so spent() may be more.
  std::int64_t cutAt() const HAPTICS_RT { return cut_at_; }

  /// CPU time of the calling thread [ns].
  static std::int64_t threadTime() HAPTICS_RT {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
  }

 private:
  Budget(std::int64_t work, std::int64_t deadline) : work_{work}, deadline_{deadline} {}
  std::int64_t work_, deadline_;
  std::int64_t spent_ = 0, next_look_ = 0, cut_at_ = 0;
  bool cut_ = false;
};

}  // namespace haptics
