// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "app/window/device/device_watch.h"

namespace window {

/// Keeps who comes to it until it is lifted.
class Gate {
 public:
  void lift() {
    const std::lock_guard lock(mutex_);
    lifted_ = true;
    changed_.notify_all();
  }
  /// From here on, who comes is kept again.
  void shut() {
    const std::lock_guard lock(mutex_);
    lifted_ = false;
  }
  void pass() {
    std::unique_lock lock(mutex_);
    ++came_;
    // whoever keeps the window waiting for it is to fail, and not to hang
    if (!changed_.wait_for(lock, std::chrono::minutes(2), [this] { return lifted_; }))
      ADD_FAILURE() << "nobody lifted the gate";
    ++passed_;
  }
  int came() const {
    const std::lock_guard lock(mutex_);
    return came_;
  }
  int passed() const {
    const std::lock_guard lock(mutex_);
    return passed_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool lifted_ = false;
  int came_ = 0, passed_ = 0;
};

/// The test's end of a device that is not there: where its handle is led to, and every wrench that
/// was written to it.
struct Handle {
  static constexpr double kStep = 5e-5;  ///< m a read, 50 mm/s: what a hand does

  std::atomic<haptics::DeviceStatus> status{haptics::DeviceStatus::Ok};
  std::atomic<haptics::Trouble> trouble{haptics::Trouble::None};
  std::atomic<std::uint32_t> buttons{0};
  std::atomic<bool> open{false};
  std::atomic<std::size_t> written{0};

  void lead(const haptics::Vec3& p_B) {
    const std::lock_guard lock(mutex_);
    target_B_ = p_B;
  }
  haptics::Vec3 led() const {
    const std::lock_guard lock(mutex_);
    return p_B_;
  }
  bool arrived() const {
    const std::lock_guard lock(mutex_);
    return p_B_ == target_B_;
  }
  haptics::Vec3 step() {
    const std::lock_guard lock(mutex_);
    const haptics::Vec3 way = target_B_ - p_B_;
    p_B_ = way.norm() <= kStep ? target_B_ : haptics::Vec3(p_B_ + way.normalized() * kStep);
    return p_B_;
  }
  void keep(const haptics::Wrench& wrench) {
    const std::lock_guard lock(mutex_);
    forces_.push_back(wrench.force.norm() + wrench.torque.norm());
    written.store(forces_.size());
  }
  /// How many of the writes from number `first` on were not zero.
  std::ptrdiff_t pushesSince(std::size_t first) const {
    const std::lock_guard lock(mutex_);
    const auto begin =
        forces_.begin() + static_cast<std::ptrdiff_t>(std::min(first, forces_.size()));
    return std::count_if(begin, forces_.end(), [](double f) { return f != 0.0; });
  }
  double lastForce() const {
    const std::lock_guard lock(mutex_);
    return forces_.empty() ? 0.0 : forces_.back();
  }

 private:
  mutable std::mutex mutex_;
  haptics::Vec3 target_B_ = haptics::Vec3::Zero(), p_B_ = haptics::Vec3::Zero();
  std::vector<double> forces_;
};

/// A device of three degrees of freedom, with the rating of a Falcon.
class HandDevice final : public haptics::Device {
 public:
  explicit HandDevice(std::shared_ptr<Handle> handle) : handle_(std::move(handle)) {
    handle_->open = true;
  }
  ~HandDevice() override { handle_->open = false; }
  const haptics::DeviceRating& rating() const noexcept override { return rating_; }
  haptics::DeviceStatus read(haptics::DeviceReading& reading) noexcept override {
    reading.trouble = handle_->trouble;
    reading.buttons = handle_->buttons;
    const haptics::DeviceStatus status = handle_->status;
    if (status == haptics::DeviceStatus::Ok) reading.X_BD.translation() = handle_->step();
    return status;
  }
  haptics::DeviceStatus write(const haptics::Wrench& wrench_B) noexcept override {
    handle_->keep(stopped_ ? haptics::Wrench{} : wrench_B);
    return handle_->status;
  }
  void stop() noexcept override { stopped_ = true; }
  void resume() noexcept override { stopped_ = false; }

 private:
  std::shared_ptr<Handle> handle_;
  haptics::DeviceRating rating_ = *haptics::findRating("falcon");
  std::atomic<bool> stopped_{false};
};

}  // namespace window
