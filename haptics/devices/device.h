// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

#include "haptics/core/geometry.h"
#include "haptics/core/trouble.h"
#include "haptics/devices/ratings.h"

namespace haptics {

/// Result of a read or a write.
enum class DeviceStatus : std::uint8_t {
  Ok,
  Stale,     ///< nothing new came in time: the last reading is kept
  NotReady,  ///< open and answering, but its poses are not valid: not homed, not calibrated
  Lost       ///< gone, or three polls failed in a row; remains until it is opened again
};

/// The device's base B: x to the user's right, y up, z towards the user. Every driver converts
/// its maker's axes to these.
struct DeviceReading {
  Pose X_BD = Pose::Identity();     ///< the handle in the base
  std::uint32_t buttons = 0;        ///< bit n: button n is down
  std::int64_t time_ns = 0;         ///< monotonic time of the measurement; 0: unknown
  Trouble trouble = Trouble::None;  ///< what the user must do: NotHomed, MotorsHot, …
};

/// A force-feedback device that is open. Opening is the driver's `open…()` function; closing is
/// the destructor, which leaves the motors off.
class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceRating& rating() const noexcept = 0;
  // Servo thread only; may wait no longer than the driver's documentation says. `Stale` keeps the
  // last reading. After `Lost` there is no force until the device is opened again.
  virtual DeviceStatus read(DeviceReading& reading) noexcept = 0;
  virtual DeviceStatus write(const Wrench& wrench_B) noexcept = 0;
  /// Whether the device tells when a reading comes, so that a tick can begin then.
  virtual bool inStep() const noexcept { return false; }
  /// Servo thread, between ticks, only where inStep(): waits for a reading that comes after this
  /// call, until `until_ns` (monotonic). Returns when it came [ns], and the next write answers it:
  /// that wrench is sent at once. 0: none came.
  virtual std::int64_t awaitReading(std::int64_t until_ns) noexcept {
    static_cast<void>(until_ns);
    return 0;
  }
  /// Any thread, also the watchdog's while the servo thread hangs in read or write. Sends zero to
  /// the motors at once. Later writes have no effect until resume(). Does not wait.
  virtual void stop() noexcept = 0;
  /// Servo thread only: writes have an effect again.
  virtual void resume() noexcept = 0;
  /// Servo thread only: puts the handle at rest at a pose, from where the hand pulls to another,
  /// where the device is one that can be put somewhere: the mouse.
  virtual void place(const Pose& X_BD, const Pose& X_pull) noexcept {
    static_cast<void>(X_BD);
    static_cast<void>(X_pull);
  }
  /// Servo thread only: a tool with another radius of gyration [m] is held from now on, where the
  /// hand is a model: it turns a tool as if it were its own.
  virtual void fit(double gyration) noexcept { static_cast<void>(gyration); }
};

/// Counts polls that failed in a row, to give a driver the status of a read.
class FailedPolls {
 public:
  static constexpr int kMost = 3;
  DeviceStatus succeeded() noexcept {
    count_ = 0;
    return DeviceStatus::Ok;
  }
  /// Stale, and from the third in a row on Lost.
  DeviceStatus failed() noexcept {
    return ++count_ >= kMost ? DeviceStatus::Lost : DeviceStatus::Stale;
  }

 private:
  int count_ = 0;
};

}  // namespace haptics
