// SPDX-License-Identifier: BSD-3-Clause

// A transport in a test's hand, for the tests of what threads carry.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "haptics/core/clock.h"
#include "haptics/devices/threaded.h"

namespace fakes {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Trouble;
using haptics::Wrench;

inline constexpr DeviceStatus kHang{100};  // what a test says for an exchange that does not return

/// What the test says and sees of a transport that it has given away.
struct ConnectionWatch {
  std::atomic<DeviceStatus> says{DeviceStatus::Ok};
  std::atomic<Trouble> trouble{Trouble::None};
  std::atomic<double> x{0.0};
  std::atomic<int> exchanges{0};
  std::atomic<int> pushes{0};            ///< exchanges that carried a force
  std::atomic<int> torques{0};           ///< exchanges that carried a torque
  std::atomic<int> not_finite{0};        ///< exchanges that carried no number
  std::atomic<double> force{0.0};        ///< of the last one
  std::atomic<double> greatest{0.0};     ///< of all, along x
  std::atomic<int> destroyed_after{-1};  ///< exchanges
  std::atomic<bool> hangs{false};
  std::function<void(const Wrench&)> during = [](const Wrench&) {};  ///< on the transport's thread
};

class FakeTransport final : public haptics::Transport {
 public:
  explicit FakeTransport(std::shared_ptr<ConnectionWatch> wire) : wire_{std::move(wire)} {}
  ~FakeTransport() override { wire_->destroyed_after = wire_->exchanges.load(); }

  DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading) noexcept override {
    ++wire_->exchanges;
    wire_->force = wrench_B.force.x();
    wire_->greatest = std::max(wire_->greatest.load(), wrench_B.force.x());
    wire_->pushes += !wrench_B.force.isZero(0.0);
    wire_->torques += !wrench_B.torque.isZero(0.0);
    wire_->not_finite += !wrench_B.force.allFinite() || !wrench_B.torque.allFinite();
    wire_->during(wrench_B);
    DeviceStatus status = wire_->says;
    while (status == kHang) {
      wire_->hangs = true;
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
      status = wire_->says;
    }
    if (status == DeviceStatus::Ok || status == DeviceStatus::NotReady) {
      reading.X_BD.translation().x() = wire_->x;
      reading.time_ns = haptics::monotonicNs();
      reading.trouble = wire_->trouble;
    }
    return status;
  }

 private:
  std::shared_ptr<ConnectionWatch> wire_;
};

/// Until it holds; a minute is for ever.
template <class Holds>
bool until(Holds&& holds) {
  for (int ms = 0; ms < 60'000; ++ms) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return false;
}

}  // namespace fakes
