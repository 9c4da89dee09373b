// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <atomic>
#include <cstdint>

#include "haptics/core/realtime.h"
#include "haptics/servo/step.h"

namespace haptics {

/// Touches every page of an empty queue, so that no push causes a page fault.
template <class Queue>
void touchPages(Queue& queue) {
  while (queue.try_enqueue({})) {
  }
  while (queue.pop()) {
  }
}

/// Carries steps from the servo thread to the thread that writes them. The constructor allocates
/// all memory. One thread pushes and one takes; neither waits. If the ring is full, a step is lost,
/// and a gap in the sequence numbers shows it.
class StepRing {
 public:
  /// `begun_ns`: CLOCK_MONOTONIC when the recording began. It has room for eight seconds at this
  /// rate.
  explicit StepRing(std::int64_t begun_ns, ServoRate rate = {})
      : capacity_{8192 * static_cast<std::size_t>(rate.hz) / 1000},
        steps_{capacity_},
        begun_ns_{begun_ns} {
    touchPages(steps_);
    touchPages(starts_);
  }

  // For the servo thread.

  /// Whether a ProxyStart must be recorded before the next step: at the beginning, and once there
  /// is room again after a loss.
  bool startIsDue() const HAPTICS_RT {
    return next_ == 0 || (lost_ && steps_.size_approx() < capacity_ / 2);
  }
  bool start(ProxyStart start) HAPTICS_RT {
    start.sequence = next_;
    if (!starts_.try_enqueue(start)) return false;
    lost_ = false;
    return true;
  }
  /// Numbers the step and pushes it; returns false if it was lost. After a loss, every step is lost
  /// until start().
  bool push(Step& step) HAPTICS_RT {
    step.sequence = next_++;
    if (!lost_ && steps_.try_enqueue(step)) return true;
    lost_ = true;
    return false;
  }
  /// Whether push() would keep a step.
  bool hasRoom() const HAPTICS_RT { return !lost_ && !full(); }
  bool full() const HAPTICS_RT { return steps_.size_approx() >= capacity_; }
  std::int64_t begun() const HAPTICS_RT { return begun_ns_; }
  std::size_t capacity() const { return capacity_; }  ///< steps

  // For the writing thread.

  bool take(Step& step) { return steps_.try_dequeue(step); }
  bool take(ProxyStart& start) { return starts_.try_dequeue(start); }
  bool empty() const { return steps_.size_approx() == 0; }
  /// Number of steps, lost ones included. Call after the servo thread has left the ring.
  std::uint64_t numbered() const { return next_; }

 private:
  std::size_t capacity_;
  moodycamel::ReaderWriterQueue<Step> steps_;
  moodycamel::ReaderWriterQueue<ProxyStart> starts_{64};
  std::int64_t begun_ns_;
  std::uint64_t next_ = 0;
  bool lost_ = false;
};

}  // namespace haptics
