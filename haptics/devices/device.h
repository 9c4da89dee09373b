// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

#include "haptics/core/geometry.h"
#include "haptics/core/trouble.h"
#include "haptics/devices/ratings.h"

namespace haptics {

/// What came of a read or a write.
enum class DeviceStatus : std::uint8_t {
  Ok,
  Stale,     ///< nothing new came in time: the last reading stands
  NotReady,  ///< open and answering, but its poses mean nothing yet: not homed, not calibrated
  Lost       ///< gone, or three polls failed in a row: it stays so until it is opened again
};

/// The device's base B: x to the user's right, y up, z towards the user. Every driver turns the
/// axes of its maker into these.
struct DeviceReading {
  Pose X_BD = Pose::Identity();     ///< the handle in the base
  std::uint32_t buttons = 0;        ///< bit n: button n is down
  std::int64_t time_ns = 0;         ///< monotonic: when the pose was measured; 0: not told
  Trouble trouble = Trouble::None;  ///< what the user is to see to: NotHomed, MotorsHot, …
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
  /// Any thread, a watchdog's too while the servo thread hangs in read or write: zero goes to the
  /// motors at once and is the last word, whatever is written, until resume(). Waits for nothing.
  virtual void stop() noexcept = 0;
  /// Servo thread only: what is written counts again.
  virtual void resume() noexcept = 0;
};

/// Counts polls that failed in a row, for a driver to say what came of a read.
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
