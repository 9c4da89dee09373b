// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "haptics/devices/device.h"
#include "haptics/servo/servo_loop.h"

/// A device in the test's hand: it is where it is put, and every write is kept.
class FakeDevice final : public haptics::Device {
 public:
  explicit FakeDevice(const haptics::Pose& X) : X_BD{X} { writes.reserve(100'000); }

  const haptics::DeviceRating& rating() const noexcept override { return rated; }
  haptics::DeviceStatus read(haptics::DeviceReading& reading) noexcept override {
    while (hang) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    if (status != haptics::DeviceStatus::Lost) reading.X_BD = X_BD;
    reading.buttons = buttons;
    reading.trouble = trouble;
    return status_of_read.value_or(status);
  }
  haptics::DeviceStatus write(const haptics::Wrench& wrench) noexcept override {
    if (writes.size() < writes.capacity()) writes.push_back(wrench);
    return status;
  }
  void stop() noexcept override {
    stopped = true;
    constexpr char kWords[] = "motors stopped\n";
    if (says_stopped) says_stopped = ::write(STDERR_FILENO, kWords, sizeof kWords - 1) < 0;
  }
  void resume() noexcept override { stopped = false; }

  haptics::Pose X_BD;
  haptics::DeviceStatus status = haptics::DeviceStatus::Ok;
  haptics::DeviceRating rated{.force = 8.0, .torque = 0.2};
  std::vector<haptics::Wrench> writes;
  std::optional<haptics::DeviceStatus> status_of_read = {};  ///< where it is not the same
  std::uint32_t buttons = 0;
  haptics::Trouble trouble = haptics::Trouble::None;
  std::atomic<bool> hang{false};  ///< the next read does not come back
  std::atomic<bool> stopped{false};
  bool says_stopped = false;  ///< on standard error, once
};

/// A servo loop without its thread, one period a call.
struct Stepped {
  Stepped(const std::shared_ptr<const haptics::Scene>& scene, double isovalue,
          const haptics::Pose& start)
      : settings{.isovalue = isovalue} {
    auto made = std::make_unique<FakeDevice>(start);
    device = made.get();
    loop = std::make_unique<haptics::ServoLoop>(std::move(made), settings);
    loop->scenes.offer(std::make_unique<haptics::Engagement>(scene, start));
  }
  const haptics::Wrench& step() {
    loop->step(1e-3 * double(ticks++));
    return device->writes.back();
  }
  void steps(int n) {
    for (int i = 0; i < n; ++i) step();
  }
  void set(double isovalue) {
    settings.isovalue = isovalue;
    loop->settings.publish(settings);
  }
  haptics::Snapshot snapshot() {
    haptics::Snapshot s;
    loop->snapshots.take(s);
    return s;
  }

  haptics::Settings settings;
  FakeDevice* device = nullptr;
  std::unique_ptr<haptics::ServoLoop> loop;
  std::int64_t ticks = 0;
};
