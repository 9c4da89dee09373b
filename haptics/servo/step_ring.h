// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <atomic>
#include <cstdint>

#include "haptics/core/realtime.h"
#include "haptics/servo/step.h"

namespace haptics {

/// What carries steps from the servo thread to the one that writes them. Everything is allocated
/// when it is made. One thread puts in, one takes out, neither waits: where there is no room a step
/// is lost, and the numbers of those that are not show it.
class StepRing {
 public:
  static constexpr std::size_t kCapacity = 8192;  ///< steps: eight seconds

  /// `begun_ns`: CLOCK_MONOTONIC when the recording began.
  explicit StepRing(std::int64_t begun_ns) : begun_ns_{begun_ns} {
    // every page is touched here, so that none is fetched in a tick
    while (steps_.try_enqueue({})) {
    }
    while (steps_.pop()) {
    }
    while (starts_.try_enqueue({})) {
    }
    while (starts_.pop()) {
    }
  }

  // The servo thread's side.

  /// Whether a ProxyStart is due before the next step: at the beginning, and once there is room
  /// again after steps were lost.
  bool startIsDue() const HAPTICS_RT {
    return next_ == 0 || (lost_ && steps_.size_approx() < kCapacity / 2);
  }
  bool start(ProxyStart start) HAPTICS_RT {
    start.sequence = next_;
    if (!starts_.try_enqueue(start)) return false;
    lost_ = false;
    return true;
  }
  /// Numbers the step and puts it in; false if it was lost. After a loss every step is, until
  /// start().
  bool push(Step& step) HAPTICS_RT {
    step.sequence = next_++;
    if (!lost_ && steps_.try_enqueue(step)) return true;
    lost_ = true;
    return false;
  }
  bool full() const HAPTICS_RT { return steps_.size_approx() >= kCapacity; }
  std::int64_t begun() const HAPTICS_RT { return begun_ns_; }

  // The other thread's side.

  bool take(Step& step) { return steps_.try_dequeue(step); }
  bool take(ProxyStart& start) { return starts_.try_dequeue(start); }
  bool empty() const { return steps_.size_approx() == 0; }
  /// Steps that were given a number, the lost ones too; once the servo thread has left.
  std::uint64_t numbered() const { return next_; }

 private:
  moodycamel::ReaderWriterQueue<Step> steps_{kCapacity};
  moodycamel::ReaderWriterQueue<ProxyStart> starts_{64};
  std::int64_t begun_ns_;
  std::uint64_t next_ = 0;
  bool lost_ = false;
};

}  // namespace haptics
