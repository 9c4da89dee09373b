// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <ctime>
#include <limits>

#include "haptics/core/realtime.h"

namespace haptics {

/// Counts of what a tick did, for studies and benchmarks. The tick itself does not use them.
struct Counts {
  std::int64_t samples = 0;    ///< look-ups of F: of a value, or of a cell and the bounds in it
  std::int64_t gradients = 0;  ///< of any kind; one by central differences adds six samples
  std::int64_t pivots = 0;     ///< rows that entered or left an active set
  std::int64_t sub_steps = 0;  ///< passes of steps 1 to 5 that searched a motion for collisions
};

/// What a tick may spend. One unit of work takes about 10 ns: one of sixteen points processed
/// together, or a quarter of a cell fetched alone. The interface has two clocks: counted work,
/// which repeats exactly, and the thread's CPU time for the live loop. Each call of left() costs
/// one unit, so no two calls have the same count, and a replay cuts a tick at the count at which
/// the live loop cut it.
class Budget {
 public:
  /// Ends after `work` units, however long they take.
  static Budget counted(std::int64_t work) { return Budget{work, 0}; }
  /// Ends after this CPU time of the calling thread [ns], from now on.
  static Budget timed(std::int64_t nanoseconds) HAPTICS_RT {
    return Budget{std::numeric_limits<std::int64_t>::max(), threadTime() + nanoseconds};
  }

  void spend(std::int64_t work = 1) HAPTICS_RT { spent_ += work; }
  /// Counts of the work done. The code that does the work updates them beside spend().
  Counts counts;
  /// Whether there is budget left. Costs one unit. Once false, it stays false.
  bool left() HAPTICS_RT {
    if (cut_) return false;
    ++spent_;
    bool used_up = spent_ >= work_;
    // reading the clock costs as much as thirty units of work, so it is read only now and then
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
  /// Whether the budget was used up.
  bool cut() const HAPTICS_RT { return cut_; }
  /// The count at which left() first returned false, or 0. A budget counted(cutAt()) is cut at the
  /// same place. Work under way is finished after a cut, so spent() may be larger.
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
