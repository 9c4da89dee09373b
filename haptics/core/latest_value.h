// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <type_traits>

#include "haptics/core/realtime.h"

namespace haptics {

/// Hands the newest value from one writer thread to one reader thread.
///
/// Wait-free on both sides: a value the reader missed is overwritten, never queued. Of three
/// slots the writer owns one, the reader one, and the third waits in the middle; publishing and
/// taking each swap their own slot with the middle one in a single atomic exchange, so neither
/// side ever sees a slot that the other is touching.
template <class T>
class LatestValue {
  static_assert(std::is_trivially_destructible_v<T>,
                "T must own nothing: copies stay off the heap");

 public:
  /// Writer thread only.
  void publish(const T& value) HAPTICS_RT {
    slots_[back_] = value;
    back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kSlot;
  }

  /// Replaces `value` and returns true if something newer was published. Reader thread only.
  bool take(T& value) HAPTICS_RT {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kSlot;
    value = slots_[front_];
    return true;
  }

 private:
  static constexpr unsigned kSlot = 3, kFresh = 4;
  std::array<T, 3> slots_{};
  alignas(64) unsigned back_ = 0;
  alignas(64) std::atomic<unsigned> middle_{1};
  alignas(64) unsigned front_ = 2;
};

}  // namespace haptics
