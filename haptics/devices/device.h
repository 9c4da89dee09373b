// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"

namespace haptics {

/// What a device can take.
struct DeviceLimits {
  double force = 0.0;    ///< N, norm
  double torque = 0.0;   ///< N·m, norm; 0 without torque motors
  double io_wait = 0.0;  ///< s that read or write may take at most
};

enum class DeviceStatus { Ok, Stale, Lost };

struct DeviceReading {
  Pose X_BD = Pose::Identity();  ///< the handle in the device's base
};

/// A force-feedback device that is open. Opening is the driver's `open…()` function; closing is
/// the destructor, which leaves the motors off. There is no third state.
class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceLimits& limits() const noexcept = 0;
  // Servo thread only; may wait no longer than limits().io_wait. `Stale` keeps the last
  // reading. After `Lost` the device is stopped, and there is no force until it is armed again.
  virtual DeviceStatus read(DeviceReading& reading) noexcept = 0;
  virtual DeviceStatus write(const Wrench& wrench_B) noexcept = 0;
  /// Any thread: zero is the last word from here on.
  virtual void stop() noexcept = 0;
};

}  // namespace haptics
