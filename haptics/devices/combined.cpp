// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/combined.h"

#include <algorithm>
#include <utility>

#include "haptics/settings.h"

namespace haptics {
namespace {

class Combined final : public Device {
 public:
  Combined(std::unique_ptr<Device> position, std::unique_ptr<Device> rotation)
      : position_{std::move(position)},
        rotation_{std::move(rotation)},
        rating_{position_->rating()} {
    rating_.sensed = std::max(rating_.sensed, 6);
    rating_.actuated = std::min(rating_.actuated, 3);
    rating_.torque = rating_.angular_stiffness = 0.0;
    rating_.lead = 0.0;  // it would lead the other device's turns as well
  }

  const DeviceRating& rating() const noexcept override { return rating_; }

  DeviceStatus read(DeviceReading& reading) noexcept override {
    const DeviceStatus moved = position_->read(where_);
    const DeviceStatus turned = rotation_->read(turn_);
    reading.trouble = where_.trouble != Trouble::None ? where_.trouble : turn_.trouble;
    if (moved == DeviceStatus::Lost || turned == DeviceStatus::Lost) return DeviceStatus::Lost;

    if (turned == DeviceStatus::Ok) R_BD_ = turn_.X_BD.linear();
    reading.X_BD.translation() = where_.X_BD.translation();
    reading.X_BD.linear() = R_BD_;
    reading.time_ns = where_.time_ns;
    constexpr std::uint32_t kMask = (1u << kButtonsEach) - 1u;
    reading.buttons = (where_.buttons & kMask);
    reading.buttons |= turn_.buttons << kButtonsEach;

    if (moved == DeviceStatus::NotReady || turned == DeviceStatus::NotReady)
      return DeviceStatus::NotReady;
    return turned == DeviceStatus::Ok ? moved : DeviceStatus::Stale;
  }

  DeviceStatus write(const Wrench& wrench_B) noexcept override {
    return position_->write({wrench_B.force, Vec3::Zero()});
  }
  bool inStep() const noexcept override { return position_->inStep(); }
  std::int64_t awaitReading(std::int64_t until_ns) noexcept override {
    return position_->awaitReading(until_ns);
  }

  void stop() noexcept override {
    position_->stop();
    rotation_->stop();
  }
  void resume() noexcept override {
    position_->resume();
    rotation_->resume();
  }

 private:
  const std::unique_ptr<Device> position_, rotation_;
  DeviceRating rating_;
  DeviceReading where_, turn_;  ///< of each, what it last gave
  Mat3 R_BD_ = Mat3::Identity();
};

}  // namespace

std::unique_ptr<Device> combined(std::unique_ptr<Device> position,
                                 std::unique_ptr<Device> rotation) {
  return std::make_unique<Combined>(std::move(position), std::move(rotation));
}

}  // namespace haptics
