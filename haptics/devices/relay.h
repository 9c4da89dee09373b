// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "haptics/core/clock.h"
#include "haptics/core/latest_value.h"
#include "haptics/devices/device.h"

namespace haptics {

/// Passes readings and wrenches between the servo thread and the one thread that talks to a device,
/// without waiting, and decides what may be sent. The wrench to send is zero if no write renewed it
/// for 5 ms, if a number in it is not finite, while the device is stopped or not Ok, and after it
/// is lost. A wrench written before resume() is never sent after it.
class Relay {
 public:
  /// `fresh`: an older reading is Stale. `silent`: if nothing came for so long, a read makes the
  /// device Lost for good. 0: no limit.
  Relay(std::chrono::milliseconds fresh, std::chrono::milliseconds silent)
      : fresh_ns_{fresh.count() * 1'000'000}, silent_ns_{silent.count() * 1'000'000} {
    last_.at_ns = monotonicNs();
  }

  // Servo thread: Device's four, stop() from any thread.
  DeviceStatus read(DeviceReading& reading) noexcept {
    // in this order: who sees that it is lost sees in whose words
    bool lost = lost_.load(std::memory_order_acquire);
    seen_.take(last_);
    const std::int64_t age = monotonicNs() - last_.at_ns;
    lost = lost || last_.status == DeviceStatus::Lost || (silent_ns_ > 0 && age > silent_ns_);
    if (lost) {
      lost_.store(true, std::memory_order_relaxed);
      const bool told = last_.status == DeviceStatus::Lost;
      reading.trouble = told ? last_.reading.trouble : Trouble::Lost;
      return DeviceStatus::Lost;
    }
    reading = last_.reading;
    if (last_.status == DeviceStatus::NotReady) return DeviceStatus::NotReady;
    return fresh_ns_ > 0 && age > fresh_ns_ ? DeviceStatus::Stale : DeviceStatus::Ok;
  }
  DeviceStatus write(const Wrench& wrench_B) noexcept {
    wanted_.publish({wrench_B, monotonicNs()});
    return lost_.load(std::memory_order_relaxed) ? DeviceStatus::Lost : DeviceStatus::Ok;
  }
  void stop() noexcept { stopped_.store(true); }
  /// Changes nothing where it is not stopped.
  void resume() noexcept {
    if (!stopped_.load()) return;
    wanted_.publish({});
    stopped_.store(false);
  }

  // The device's thread.
  /// What to send now: zero if stop() had returned when this call began. A stop() during this call
  /// takes effect in the next call.
  Wrench due() noexcept {
    // in this order: a call that sees the resume() also sees that it discarded earlier wrenches
    const bool stop_said = stopped_.load();
    wanted_.take(newest_);
    const bool zero = stop_said || lost_.load(std::memory_order_relaxed) ||
                      monotonicNs() - newest_.at_ns > kConfirmedNs ||
                      !newest_.wrench_B.force.allFinite() || !newest_.wrench_B.torque.allFinite();
    const Wrench wrench_B = zero ? Wrench{} : newest_.wrench_B;
    asked_ = !wrench_B.force.isZero(0.0) || !wrench_B.torque.isZero(0.0);
    return coming_.status == DeviceStatus::Ok ? wrench_B : Wrench{};
  }
  /// Whether the last due() was unlike zero, or was zero only because the device is not Ok.
  bool asked() const noexcept { return asked_; }
  /// The status of a round, and its reading, which is used unless the status is Stale. The third
  /// Stale in a row is Lost; after Lost nothing is used. Returns false if the device is lost.
  bool came(DeviceStatus status, const DeviceReading& reading) noexcept {
    if (coming_.status == DeviceStatus::Lost) return false;
    if (status == DeviceStatus::Stale) {
      if (polls_.failed() != DeviceStatus::Lost) return true;
      status = DeviceStatus::Lost;
      coming_.reading.trouble = Trouble::Lost;
    } else {
      polls_.succeeded();
      coming_.reading = reading;
      coming_.at_ns = monotonicNs();
    }
    coming_.status = status;
    const bool lost = status == DeviceStatus::Lost;
    if (lost && coming_.reading.trouble == Trouble::None) coming_.reading.trouble = Trouble::Lost;
    seen_.publish(coming_);
    if (lost) lost_.store(true, std::memory_order_release);
    return !lost;
  }

 private:
  static constexpr std::int64_t kConfirmedNs = 5'000'000;

  /// What the device's thread last saw, and when.
  struct Seen {
    DeviceReading reading;
    DeviceStatus status = DeviceStatus::NotReady;
    std::int64_t at_ns = 0;
  };
  /// What the servo thread last wrote, and when.
  struct Wanted {
    Wrench wrench_B;
    std::int64_t at_ns = 0;
  };

  const std::int64_t fresh_ns_, silent_ns_;
  LatestValue<Seen> seen_;
  LatestValue<Wanted> wanted_;
  Seen last_;                         ///< the servo thread's copy
  Seen coming_;                       ///< the device thread's
  Wanted newest_;                     ///< the device thread's
  FailedPolls polls_;                 ///< the device thread's
  bool asked_ = false;                ///< the device thread's
  std::atomic<bool> stopped_{false};  ///< of one order for all: who looks after a stop() sees it
  std::atomic<bool> lost_{false};
};

}  // namespace haptics
