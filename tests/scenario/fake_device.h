// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "haptics/devices/device.h"
#include "haptics/servo/servo_loop.h"

/// A device in the test's hand: it is where it is put, and every write is kept.
class FakeDevice final : public haptics::Device {
 public:
  explicit FakeDevice(const haptics::Pose& X) : X_BD{X} { writes.reserve(100'000); }

  const haptics::DeviceRating& rating() const noexcept override { return rated; }
  haptics::DeviceStatus read(haptics::DeviceReading& reading) noexcept override {
    if (status != haptics::DeviceStatus::Lost) reading.X_BD = X_BD;
    return status;
  }
  haptics::DeviceStatus write(const haptics::Wrench& wrench) noexcept override {
    writes.push_back(wrench);  // within what was reserved
    return status;
  }
  void stop() noexcept override { stopped = true; }
  void resume() noexcept override { stopped = false; }

  haptics::Pose X_BD;
  haptics::DeviceStatus status = haptics::DeviceStatus::Ok;
  haptics::DeviceRating rated{.force = 8.0, .torque = 0.2};
  std::vector<haptics::Wrench> writes;
  bool stopped = false;
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
