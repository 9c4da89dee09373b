// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include "haptics/core/realtime.h"
#include "haptics/devices/device.h"

namespace haptics {

/// No tick, no force. A thread of its own looks every millisecond whether the servo thread has
/// begun a tick in the last 5 ms, and stops the device if not, or if stopAllMotors() was called
/// (servo/emergency.h). The servo thread, once it is back, learns of the gap, lets the device
/// go on and ramps the force in anew; three gaps within ten seconds are a fault.
class Watchdog {
 public:
  static constexpr std::int64_t kLongestGap = 5'000'000;   ///< ns without a tick
  static constexpr std::int64_t kWindow = 10'000'000'000;  ///< ns in which kMostGaps are a fault
  static constexpr int kMostGaps = 3;

  /// ns, of a clock that goes on while the machine sleeps.
  static std::int64_t clock() HAPTICS_RT;

  /// `device` outlives it. The thread begins with `start`.
  explicit Watchdog(Device& device) : device_{device} {}
  ~Watchdog();
  void start();

  /// What the servo thread learns as it begins a tick.
  struct Beat {
    bool gap = false;      ///< there was a gap before this tick
    bool stalled = false;  ///< it was the third in ten seconds
  };
  /// Servo thread only, at the begin of each tick: it is alive at `now` of `clock`.
  Beat beat(std::int64_t now) HAPTICS_RT;

  /// One look at the clock, by the thread. Public for tests, which have a clock of their own.
  void look(std::int64_t now) HAPTICS_RT;

 private:
  void run();

  Device& device_;
  std::atomic<std::int64_t> last_beat_{0};      ///< 0: no tick yet, so nothing to watch
  std::atomic<std::uint64_t> stops_{0};         ///< that the thread made
  std::uint64_t stops_seen_ = 0;                ///< by the servo thread
  std::array<std::int64_t, kMostGaps> gaps_{};  ///< when the last ones were; the servo thread's
  int next_gap_ = 0;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace haptics
