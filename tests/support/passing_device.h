// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "haptics/devices/device.h"

namespace support {

/// A device that passes every call on to another, for one that does something beside.
class PassingDevice : public haptics::Device {
 public:
  explicit PassingDevice(std::unique_ptr<haptics::Device> device) : device_{std::move(device)} {}
  const haptics::DeviceRating& rating() const noexcept override { return device_->rating(); }
  haptics::DeviceStatus read(haptics::DeviceReading& reading) noexcept override {
    return device_->read(reading);
  }
  haptics::DeviceStatus write(const haptics::Wrench& wrench_B) noexcept override {
    return device_->write(wrench_B);
  }
  bool inStep() const noexcept override { return device_->inStep(); }
  std::int64_t awaitReading(std::int64_t until_ns) noexcept override {
    return device_->awaitReading(until_ns);
  }
  void stop() noexcept override { device_->stop(); }
  void resume() noexcept override { device_->resume(); }
  void place(const haptics::Pose& X_BD, const haptics::Pose& X_pull) noexcept override {
    device_->place(X_BD, X_pull);
  }

 private:
  const std::unique_ptr<haptics::Device> device_;
};

}  // namespace support
