// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include "haptics/core/realtime.h"
#include "haptics/devices/device.h"

namespace haptics {

/// Stops the device if there is no tick. Its own thread checks every millisecond whether the servo
/// thread has begun a tick in the last 5 ms. If not, or if stopAllMotors() was called
/// (servo/emergency.h), it stops the device. In the next tick beat() reports the gap, and the servo
/// thread releases the device and ramps the force in. Three gaps within ten seconds are a fault.
class Watchdog {
 public:
  static constexpr std::int64_t kLongestGap = 5'000'000;   ///< ns without a tick
  static constexpr std::int64_t kWindow = 10'000'000'000;  ///< ns in which kMostGaps are a fault
  static constexpr int kMostGaps = 3;

  /// ns, of a clock that also runs while the machine sleeps.
  static std::int64_t clock() HAPTICS_RT;

  /// `device` must outlive the watchdog. start() starts the thread.
  explicit Watchdog(Device& device) : device_{device} {}
  ~Watchdog();
  void start();

  /// Report to the servo thread at the beginning of a tick.
  struct Beat {
    bool gap = false;      ///< there was a gap before this tick
    bool stalled = false;  ///< it was the third gap in ten seconds
  };
  /// Servo thread only, at the beginning of each tick: reports that it is alive at time `now` of
  /// clock().
  Beat beat(std::int64_t now) HAPTICS_RT;

  /// One check by the watchdog's thread, at time `now`. Public for tests, which have a clock of
  /// their own.
  void look(std::int64_t now) HAPTICS_RT;

 private:
  void run();

  Device& device_;
  std::atomic<std::int64_t> last_beat_{0};  ///< 0: no tick yet, so nothing to watch
  std::atomic<std::uint64_t> stops_{0};     ///< stops by the watchdog's thread
  std::uint64_t stops_seen_ = 0;            ///< stops that the servo thread has seen
  /// Times of the last gaps; used by the servo thread.
  std::array<std::int64_t, kMostGaps> gaps_{};
  int next_gap_ = 0;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace haptics
