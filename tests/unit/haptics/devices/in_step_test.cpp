// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <thread>
#include <vector>

#include "haptics/devices/rendezvous.h"
#include "haptics/servo/servo_loop.h"
#include "tests/support/passing_device.h"
#include "tests/unit/haptics/devices/fake_transport.h"

// To be run under the thread sanitizer too: what it says counts as a failure.

namespace {

using fakes::ConnectionWatch;
using fakes::FakeTransport;
using fakes::kHang;
using fakes::until;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Vec3;
using haptics::Wrench;
using namespace std::chrono_literals;

// a tick that was very long answers a wait that has ended
TEST(Rendezvous, AnAnswerThatComesTooLateIsNotTakenForTheNext) {
  haptics::Rendezvous rendezvous;
  const auto cameWithin = [&](std::chrono::nanoseconds longest) {
    return std::async(std::launch::async, [&rendezvous, longest] {
      while (!rendezvous.readingCame(longest.count())) std::this_thread::sleep_for(100us);
    });
  };
  auto first = cameWithin(0ns);
  EXPECT_NE(rendezvous.awaitReading(haptics::monotonicNs() + 60'000'000'000), 0);
  first.get();  // it waits no longer
  rendezvous.answer();
  auto second = cameWithin(60s);
  EXPECT_NE(rendezvous.awaitReading(haptics::monotonicNs() + 60'000'000'000), 0);
  EXPECT_EQ(second.wait_for(20ms), std::future_status::timeout);
  rendezvous.answer();
  EXPECT_EQ(second.wait_for(30s), std::future_status::ready);
}

TEST(Rendezvous, WhoWaitsForNothingHoldsNobodyUp) {
  haptics::Rendezvous rendezvous;
  EXPECT_FALSE(rendezvous.readingCame(60'000'000'000));
  rendezvous.answer();
  EXPECT_EQ(rendezvous.awaitReading(haptics::monotonicNs()), 0);
  EXPECT_FALSE(rendezvous.readingCame(60'000'000'000));  // that wait has ended
}

/// A link in step whose exchange takes a round of its own and whose readings are numbered.
struct InStep {
  static constexpr int kMost = 1 << 16;
  /// `each`: called in each exchange with its number.
  explicit InStep(
      std::function<void(int)> each = [](int) {}, std::chrono::microseconds lasts = 230us) {
    wire->during = [this, lasts, each = std::move(each)](const Wrench& wrench) {
      const int n = round + 1;
      if (n < kMost) begun[std::size_t(n)] = haptics::monotonicNs();
      if (n < kMost) sent[std::size_t(n)] = wrench.force.x();
      round = n;
      wire->x = n;
      each(n);
      std::this_thread::sleep_for(lasts);
    };
    device = haptics::threaded(std::make_unique<FakeTransport>(wire), haptics::DeviceRating{}, 0ms,
                               true);
  }
  /// Waits for a reading, and gives its number; 0: none came.
  int awaited(std::chrono::nanoseconds longest) {
    came = device->awaitReading(haptics::monotonicNs() + longest.count());
    if (came == 0) return 0;
    device->read(reading);
    return int(reading.X_BD.translation().x());
  }

  std::shared_ptr<ConnectionWatch> wire = std::make_shared<ConnectionWatch>();
  std::atomic<int> round{0};
  /// By the number of the exchange: when it began [ns], and the force that it carried.
  std::vector<std::atomic<std::int64_t>> begun = std::vector<std::atomic<std::int64_t>>(kMost);
  std::vector<std::atomic<double>> sent = std::vector<std::atomic<double>>(kMost);
  std::unique_ptr<haptics::Device> device;
  DeviceReading reading;
  std::int64_t came = 0;  ///< when the reading came that was awaited last [ns]
};

TEST(InStep, TheNextExchangeCarriesTheAnswerToTheLastReading) {
  InStep it;
  ASSERT_TRUE(it.device->inStep());
  int answered = 0;
  std::int64_t soonest = INT64_MAX;
  for (int tick = 0; tick < 20'000 && answered < 100; ++tick) {
    const int n = it.awaited(1s);
    ASSERT_LT(n + 1, InStep::kMost);
    // another reading has come since, on a busy machine
    if (n == 0 || it.reading.time_ns > it.came) continue;
    it.device->write(Wrench{Vec3{double(n), 0, 0}, Vec3::Zero()});
    // the link's thread waits no longer
    if (haptics::monotonicNs() - it.came > 250'000) continue;
    ASSERT_TRUE(until([&] { return it.round > n; }));
    EXPECT_EQ(it.sent[std::size_t(n + 1)], n);
    soonest = std::min(soonest, it.begun[std::size_t(n + 1)] - it.came);
    ++answered;
  }
  EXPECT_EQ(answered, 100);
  EXPECT_LT(soonest, 240'000) << "the answer is not what ends the wait";
}

TEST(InStep, AServoThreadThatDoesNotAnswerHoldsNothingUp) {
  InStep it;
  for (int tick = 0; tick < 20; ++tick) {
    const int n = it.awaited(1s);
    ASSERT_TRUE(until([&] { return it.round > n + 2; }));
  }
  EXPECT_EQ(it.wire->greatest, 0.0);
}

TEST(InStep, AWaitEndsAtItsTimeWhereNothingComesAndLaterOnesGoOn) {
  InStep it;
  ASSERT_TRUE(until([&] { return it.awaited(1s) > 0; }));
  it.wire->says = kHang;
  ASSERT_TRUE(until([&] { return it.wire->hangs.load(); }));
  for (int wait = 0; wait < 3; ++wait) {
    const std::int64_t until = haptics::monotonicNs() + 5'000'000;
    EXPECT_EQ(it.device->awaitReading(until), 0);
    EXPECT_GE(haptics::monotonicNs(), until);
    it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()});
  }
  it.wire->says = DeviceStatus::Ok;
  EXPECT_TRUE(until([&] { return it.awaited(1s) > 0; }));
}

// it keeps the reading, and a tick has nothing to answer
TEST(InStep, AnExchangeThatBroughtNothingIsNoReading) {
  ConnectionWatch* raw = nullptr;
  std::atomic<bool> seldom{false};
  InStep it{[&](int n) {
    if (seldom) raw->says = n % 3 == 0 ? DeviceStatus::Ok : DeviceStatus::Stale;
  }};
  raw = it.wire.get();
  seldom = true;
  ASSERT_TRUE(until([&] { return it.wire->says == DeviceStatus::Stale; }));
  for (int tick = 0; tick < 50; ++tick) {
    it.awaited(1s);
    const int last = it.round;
    // its thread waits for the answer for so long, and exchanges nothing
    if (it.came != 0 && haptics::monotonicNs() - it.came < 250'000) {
      EXPECT_EQ(last % 3, 0);
    }
    it.device->write(Wrench{});
  }
}

// its readings come one upon another
TEST(InStep, ALinkThatIsTooFastDrivesNoTickTooEarly) {
  InStep it{[](int) {}, 0us};
  haptics::ServoLoop loop{std::move(it.device), {}, true, haptics::ServoRate{4000}};
  const std::int64_t begun = haptics::monotonicNs();
  loop.start();
  ASSERT_TRUE(until([&] { return loop.boundary >= 400; }));
  const std::uint64_t ticks = loop.boundary;
  EXPECT_GE(haptics::monotonicNs() - begun, std::int64_t(ticks - 2) * 125'000);
}

TEST(InStep, StopIsObeyedThoughTheAnswerIsAForce) {
  InStep it;
  for (int tick = 0; tick < 20; ++tick) {
    it.awaited(1s);
    it.device->write(Wrench{Vec3{4, 0, 0}, Vec3::Zero()});
  }
  EXPECT_TRUE(until([&] { return it.wire->pushes > 0; }));
  it.device->stop();
  const int stopped = it.round;
  for (int tick = 0; tick < 20; ++tick) {
    it.awaited(1s);
    it.device->write(Wrench{Vec3{4, 0, 0}, Vec3::Zero()});
  }
  ASSERT_TRUE(until([&] { return it.round > stopped + 10; }));
  // the one under way, and one that had looked already
  for (int n = stopped + 2; n < it.round && n < InStep::kMost; ++n)
    EXPECT_EQ(it.sent[std::size_t(n)], 0.0) << n - stopped;
}

/// A device whose writes tell which reading they answer.
class Numbered final : public support::PassingDevice {
 public:
  Numbered(std::unique_ptr<haptics::Device> device, std::atomic<int>& answered)
      : PassingDevice{std::move(device)}, answered_{answered} {}
  DeviceStatus read(DeviceReading& reading) noexcept override {
    const DeviceStatus status = PassingDevice::read(reading);
    number_ = int(reading.X_BD.translation().x());
    return status;
  }
  DeviceStatus write(const Wrench& wrench) noexcept override {
    answered_ = number_;
    return PassingDevice::write(wrench);
  }

 private:
  std::atomic<int>& answered_;
  int number_ = 0;
};

TEST(InStep, TheServoLoopTicksWhenAReadingComesAndGoesOnWhereNoneDoes) {
  std::atomic<int> answered{0}, in_step{0};
  InStep it{[&](int n) {
    if (n % 50 == 0) in_step = 0;
    in_step += answered == n - 1;
  }};
  haptics::ServoLoop loop{std::make_unique<Numbered>(std::move(it.device), answered),
                          {},
                          true,
                          haptics::ServoRate{4000}};
  loop.start();
  // of fifty; out of step next to none is, for an exchange begins when the last has ended
  EXPECT_TRUE(until([&] { return in_step >= 30; }));
  it.wire->says = kHang;
  ASSERT_TRUE(until([&] { return it.wire->hangs.load(); }));
  const std::uint64_t ticks = loop.boundary;
  EXPECT_TRUE(until([&] { return loop.boundary > ticks + 20; }));
  it.wire->says = DeviceStatus::Ok;
}

}  // namespace
