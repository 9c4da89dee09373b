// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/threaded.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include "haptics/core/clock.h"
#include "haptics/servo/servo_loop.h"

// To be run under the thread sanitizer too: what it says counts as a failure.

namespace {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;
using namespace std::chrono_literals;

constexpr DeviceStatus kHang{100};  // what a test says for an exchange that does not return

/// What the test says and sees of a transport that it has given away.
struct Wire {
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
  explicit FakeTransport(std::shared_ptr<Wire> wire) : wire_{std::move(wire)} {}
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
      std::this_thread::sleep_for(1ms);
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
  std::shared_ptr<Wire> wire_;
};

struct Threaded {
  explicit Threaded(std::chrono::milliseconds fresh = 0ms,
                    std::function<void(const Wrench&)> during = nullptr) {
    if (during) wire->during = std::move(during);
    device =
        haptics::threaded(std::make_unique<FakeTransport>(wire), haptics::DeviceRating{}, fresh);
  }
  /// Until it holds; a minute is for ever.
  template <class Holds>
  static bool until(Holds&& holds) {
    for (int ms = 0; ms < 60'000; ++ms) {
      if (holds()) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }
  /// So many exchanges more have begun.
  bool exchanged(int more) {
    const int from = wire->exchanges;
    return until([&] { return wire->exchanges >= from + more; });
  }
  bool reads(DeviceStatus status) {
    return until([&] { return device->read(reading) == status; });
  }
  /// Writes until a force has gone out.
  bool pushed(double newtons) {
    const int from = wire->pushes;
    return until([&] {
      device->write(Wrench{Vec3{newtons, 0, 0}, Vec3::Zero()});
      return wire->pushes > from;
    });
  }

  std::shared_ptr<Wire> wire = std::make_shared<Wire>();
  std::unique_ptr<haptics::Device> device;
  DeviceReading reading;
};

TEST(Threaded, IsNotReadyBeforeTheFirstExchangeAndGivesWhatCameLast) {
  Threaded it;
  it.wire->says = DeviceStatus::NotReady;
  it.wire->trouble = Trouble::NotHomed;
  ASSERT_TRUE(Threaded::until([&] {
    return it.device->read(it.reading) == DeviceStatus::NotReady &&
           it.reading.trouble == Trouble::NotHomed;
  }));
  it.wire->says = DeviceStatus::Ok;
  it.wire->trouble = Trouble::None;
  it.wire->x = 0.25;
  ASSERT_TRUE(it.reads(DeviceStatus::Ok));
  EXPECT_EQ(it.reading.trouble, Trouble::None);
  EXPECT_TRUE(Threaded::until([&] {
    it.device->read(it.reading);
    return it.reading.X_BD.translation().x() == 0.25;
  }));
}

TEST(Threaded, StaysNotReadyForAsLongAsTheTransportSaysSo) {
  Threaded it{1ms};
  it.wire->says = DeviceStatus::NotReady;
  ASSERT_TRUE(it.reads(DeviceStatus::NotReady));
  ASSERT_TRUE(it.exchanged(10));
  EXPECT_EQ(it.device->read(it.reading), DeviceStatus::NotReady);
}

TEST(Threaded, NoForceGoesToADeviceThatIsNotReady) {
  Threaded it;
  it.wire->says = DeviceStatus::NotReady;
  ASSERT_TRUE(it.exchanged(3));
  const int before = it.wire->pushes;
  for (int tick = 0; tick < 20; ++tick) {
    it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()});
    ASSERT_TRUE(it.exchanged(1));
  }
  EXPECT_EQ(it.wire->pushes, before);
  it.wire->says = DeviceStatus::Ok;
  EXPECT_TRUE(it.pushed(1.0));
}

TEST(Threaded, SendsTheNewestWrenchWhole) {
  Threaded it;
  ASSERT_TRUE(it.pushed(1.0));
  const Wrench newest{Vec3{2, 0, 0}, Vec3{0, 0.1, 0}};
  EXPECT_TRUE(Threaded::until([&] {
    it.device->write(newest);
    return it.wire->force == 2.0 && it.wire->torques > 0;
  }));
  EXPECT_EQ(it.wire->greatest, 2.0);
}

TEST(Threaded, WhatNoWriteConfirmsIsZeroAfterFiveMilliseconds) {
  Threaded it;
  for (int round = 0; round < 5; ++round) {
    ASSERT_TRUE(it.pushed(3.0));
    // no exchange that begins so much later carries it, however late the test is
    std::this_thread::sleep_for(6ms);
    ASSERT_TRUE(it.exchanged(2));
    const int before = it.wire->pushes;
    ASSERT_TRUE(it.exchanged(20));
    EXPECT_EQ(it.wire->pushes, before);
    EXPECT_EQ(it.wire->force, 0.0);
  }
}

TEST(Threaded, AWrenchThatIsConfirmedStays) {
  std::atomic<std::int64_t> written{0};
  // zero may be sent only where the last write is five milliseconds old
  std::atomic<int> early_zeros{0}, pushed{0};
  const auto now = [] { return std::chrono::steady_clock::now().time_since_epoch().count(); };
  {
    Threaded it{0ms, [&](const Wrench& wrench) {
                  const std::int64_t last = written;
                  if (last == 0) return;
                  pushed += wrench.force.x() > 0.0;
                  early_zeros += wrench.force.x() == 0.0 && now() - last < 4'000'000;
                }};
    ASSERT_TRUE(it.pushed(1.0));
    for (int tick = 0; tick < 200; ++tick) {
      const std::int64_t before = now();
      it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()});
      it.exchanged(2);  // the one under way had looked before
      written = before;
      std::this_thread::sleep_for(1ms);
      written = 0;
    }
  }
  EXPECT_GT(pushed, 0);
  EXPECT_EQ(early_zeros, 0);
}

TEST(Threaded, WhatIsNotFiniteNeverReachesTheTransport) {
  Threaded it;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ASSERT_TRUE(it.pushed(1.0));
  int before = 0;
  for (const Wrench& bad :
       {Wrench{Vec3{kNan, 0, 0}, Vec3::Zero()}, Wrench{Vec3{1, kInfinity, 0}, Vec3::Zero()},
        Wrench{Vec3{1, 0, 0}, Vec3{0, 0, -kInfinity}}}) {
    it.device->write(bad);
    ASSERT_TRUE(it.exchanged(2));
    before = it.wire->pushes;
    for (int tick = 0; tick < 20; ++tick) {
      it.device->write(bad);
      ASSERT_TRUE(it.exchanged(1));
    }
    EXPECT_EQ(it.wire->pushes, before) << "a wrench with one bad number is zero as a whole";
  }
  EXPECT_EQ(it.wire->not_finite, 0);
}

// stop() may fall between an exchange's look at it and what it sends: so one more may carry a force
TEST(Threaded, StopFromAnotherThreadIsTheLastWordUnderAWriteLoop) {
  Threaded it;
  std::atomic<bool> ending{false};
  std::atomic<int> resumes{0}, resumed{0};
  std::thread servo{[&] {
    while (!ending) {
      if (resumes != resumed) {
        it.device->resume();
        resumed = resumes.load();
      }
      it.device->write(Wrench{Vec3{4, 0, 0}, Vec3::Zero()});
      std::this_thread::sleep_for(100us);
    }
  }};
  for (int round = 0; round < 30; ++round) {
    const int pushes = it.wire->pushes;
    EXPECT_TRUE(Threaded::until([&] { return it.wire->pushes > pushes; }));
    it.device->stop();
    const int at_stop = it.wire->pushes;
    EXPECT_TRUE(it.exchanged(2));  // the one under way, and one that began later
    const int after = it.wire->pushes;
    EXPECT_LE(after, at_stop + 1) << "two exchanges after stop() carried a force";
    EXPECT_TRUE(it.exchanged(10));
    EXPECT_EQ(it.wire->pushes, after);
    ++resumes;
    EXPECT_TRUE(Threaded::until([&] { return resumes == resumed; }));
  }
  ending = true;
  servo.join();
}

TEST(Threaded, TheOneExchangeThatStopMissesIsFollowedByZero) {
  // the flag falls while the exchange is under way, the worst that can be
  std::atomic<haptics::Device*> device{nullptr};
  std::atomic<int> after{0}, pushes_after{0};
  std::atomic<bool> stopped{false};
  Threaded it{0ms, [&](const Wrench& wrench) {
                if (stopped) {
                  ++after;
                  pushes_after += wrench.force.x() != 0.0;
                } else if (device != nullptr && wrench.force.x() != 0.0) {
                  std::thread{[&] { device.load()->stop(); }}.join();
                  stopped = true;
                }
              }};
  device = it.device.get();
  EXPECT_TRUE(Threaded::until([&] {
    it.device->write(Wrench{Vec3{4, 0, 0}, Vec3::Zero()});
    return after >= 10;
  }));
  EXPECT_EQ(pushes_after, 0);
}

TEST(Threaded, WhatWasWrittenBeforeResumeIsNotSentAfterIt) {
  Threaded it;
  for (int round = 0; round < 50; ++round) {
    ASSERT_TRUE(it.pushed(5.0));
    it.device->stop();
    it.device->write(Wrench{Vec3{5, 0, 0}, Vec3::Zero()});
    ASSERT_TRUE(it.exchanged(2));
    const int before = it.wire->pushes;
    it.device->write(Wrench{Vec3{5, 0, 0}, Vec3::Zero()});
    it.device->resume();
    ASSERT_TRUE(it.exchanged(3));
    EXPECT_EQ(it.wire->pushes, before);
  }
}

TEST(Threaded, ResumeWithoutAStopChangesNothing) {
  Threaded it;
  bool sent = false;
  for (int round = 0; round < 200 && !sent; ++round) {
    it.device->write(Wrench{Vec3{6, 0, 0}, Vec3::Zero()});
    it.device->resume();
    ASSERT_TRUE(it.exchanged(3));
    sent = it.wire->force == 6.0;
  }
  EXPECT_TRUE(sent);
}

TEST(Threaded, ThreeExchangesInARowThatFailMakeItLostAndItStaysSo) {
  Threaded it;
  ASSERT_TRUE(it.pushed(1.0));
  ASSERT_TRUE(it.reads(DeviceStatus::Ok));
  it.wire->says = DeviceStatus::Stale;
  const int from = it.wire->exchanges;
  ASSERT_TRUE(Threaded::until([&] {
    it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()});
    return it.device->read(it.reading) == DeviceStatus::Lost;
  }));
  EXPECT_EQ(it.reading.trouble, Trouble::Lost);
  EXPECT_EQ(it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()}), DeviceStatus::Lost);
  // three that failed and the zero at the end, and one or two that had begun before
  ASSERT_TRUE(Threaded::until([&] { return it.wire->destroyed_after >= 0; }));
  EXPECT_LE(it.wire->exchanges, from + 5);
  EXPECT_EQ(it.wire->force, 0.0);
  it.wire->says = DeviceStatus::Ok;
  EXPECT_EQ(it.device->read(it.reading), DeviceStatus::Lost);
  it.device->resume();
  EXPECT_EQ(it.device->write(Wrench{}), DeviceStatus::Lost);
}

TEST(Threaded, TwoThatFailAreForgivenByOneThatDoesNot) {
  std::atomic<int> n{0};
  auto wire = std::make_shared<Wire>();
  wire->during = [&, raw = wire.get()](const Wrench&) {
    raw->says = ++n % 3 == 0 ? DeviceStatus::Ok : DeviceStatus::Stale;
  };
  const auto device =
      haptics::threaded(std::make_unique<FakeTransport>(wire), haptics::DeviceRating{}, 0ms);
  ASSERT_TRUE(Threaded::until([&] { return wire->exchanges > 60; }));
  DeviceReading reading;
  EXPECT_EQ(device->read(reading), DeviceStatus::Ok);
}

TEST(Threaded, ATransportThatSaysLostIsBelievedAtOnceInItsOwnWords) {
  Threaded it;
  ASSERT_TRUE(it.reads(DeviceStatus::Ok));
  it.wire->trouble = Trouble::MotorsHot;
  ASSERT_TRUE(it.exchanged(3));
  it.wire->says = DeviceStatus::Lost;
  const int from = it.wire->exchanges;
  ASSERT_TRUE(it.reads(DeviceStatus::Lost));
  EXPECT_EQ(it.reading.trouble, Trouble::MotorsHot);
  ASSERT_TRUE(Threaded::until([&] { return it.wire->destroyed_after >= 0; }));
  EXPECT_LE(it.wire->exchanges, from + 3);
}

TEST(Threaded, AReadingThatGrowsOldIsStaleAndStands) {
  Threaded it{20ms};
  it.wire->x = 0.125;
  ASSERT_TRUE(Threaded::until([&] {
    it.device->read(it.reading);
    return it.reading.X_BD.translation().x() == 0.125;
  }));
  it.wire->says = kHang;
  ASSERT_TRUE(it.reads(DeviceStatus::Stale));
  EXPECT_EQ(it.reading.X_BD.translation().x(), 0.125);
  it.wire->says = DeviceStatus::Ok;
  EXPECT_TRUE(Threaded::until([&] {
    const DeviceStatus status = it.device->read(it.reading);
    return status == DeviceStatus::Ok || status == DeviceStatus::Lost;
  }));
}

TEST(Threaded, WhoseReadingsNeverAgeIsNotStale) {
  Threaded it{0ms};
  ASSERT_TRUE(it.reads(DeviceStatus::Ok));
  it.wire->says = kHang;
  ASSERT_TRUE(Threaded::until([&] { return it.wire->hangs.load(); }));
  EXPECT_NE(it.device->read(it.reading), DeviceStatus::Stale);
  it.wire->says = DeviceStatus::Ok;
}

TEST(Threaded, AnExchangeThatHangsIsLostAndClosingDoesNotHang) {
  auto wire = std::make_shared<Wire>();
  {
    Threaded it;
    wire = it.wire;
    ASSERT_TRUE(it.pushed(1.0));
    wire->says = kHang;
    ASSERT_TRUE(it.reads(DeviceStatus::Lost));
    EXPECT_EQ(it.reading.trouble, Trouble::Lost);
    EXPECT_EQ(it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()}), DeviceStatus::Lost);
  }
  EXPECT_EQ(wire->destroyed_after, -1);  // left behind, not destroyed under its own feet
  wire->says = DeviceStatus::Ok;
  ASSERT_TRUE(Threaded::until([&] { return wire->destroyed_after >= 0; }));
  EXPECT_EQ(wire->force, 0.0);
}

TEST(Threaded, OnceLostToAHangItIsLostWhateverComesLater) {
  Threaded it;
  ASSERT_TRUE(it.pushed(1.0));
  it.wire->says = kHang;
  ASSERT_TRUE(it.reads(DeviceStatus::Lost));
  it.wire->says = DeviceStatus::Ok;
  ASSERT_TRUE(it.exchanged(3));
  const int before = it.wire->pushes;
  for (int tick = 0; tick < 20; ++tick) {
    EXPECT_EQ(it.device->read(it.reading), DeviceStatus::Lost);
    it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()});
    ASSERT_TRUE(it.exchanged(1));
  }
  EXPECT_EQ(it.wire->pushes, before);
}

TEST(Threaded, ATransportThatNeverWaitsIsNotABusyLoop) {
  Threaded it;
  const auto begun = std::chrono::steady_clock::now();
  ASSERT_TRUE(it.exchanged(400));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  EXPECT_GT(took.count(), 0.08);  // 399 rounds of 250 us, less what had begun
}

TEST(Threaded, TheDestructorSendsZeroLast) {
  for (int round = 0; round < 20; ++round) {
    std::shared_ptr<Wire> wire;
    {
      Threaded it;
      wire = it.wire;
      ASSERT_TRUE(it.pushed(7.0));
      it.device->write(Wrench{Vec3{7, 0, 0}, Vec3::Zero()});
    }
    EXPECT_EQ(wire->force, 0.0);
    EXPECT_EQ(wire->destroyed_after, wire->exchanges);
  }
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

  std::shared_ptr<Wire> wire = std::make_shared<Wire>();
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
    ASSERT_TRUE(Threaded::until([&] { return it.round > n; }));
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
    ASSERT_TRUE(Threaded::until([&] { return it.round > n + 2; }));
  }
  EXPECT_EQ(it.wire->greatest, 0.0);
}

TEST(InStep, AWaitEndsAtItsTimeWhereNothingComesAndLaterOnesGoOn) {
  InStep it;
  ASSERT_TRUE(Threaded::until([&] { return it.awaited(1s) > 0; }));
  it.wire->says = kHang;
  ASSERT_TRUE(Threaded::until([&] { return it.wire->hangs.load(); }));
  for (int wait = 0; wait < 3; ++wait) {
    const std::int64_t until = haptics::monotonicNs() + 5'000'000;
    EXPECT_EQ(it.device->awaitReading(until), 0);
    EXPECT_GE(haptics::monotonicNs(), until);
    it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()});
  }
  it.wire->says = DeviceStatus::Ok;
  EXPECT_TRUE(Threaded::until([&] { return it.awaited(1s) > 0; }));
}

// it keeps the reading, and a tick has nothing to answer
TEST(InStep, AnExchangeThatBroughtNothingIsNoReading) {
  Wire* raw = nullptr;
  std::atomic<bool> seldom{false};
  InStep it{[&](int n) {
    if (seldom) raw->says = n % 3 == 0 ? DeviceStatus::Ok : DeviceStatus::Stale;
  }};
  raw = it.wire.get();
  seldom = true;
  ASSERT_TRUE(Threaded::until([&] { return it.wire->says == DeviceStatus::Stale; }));
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
  ASSERT_TRUE(Threaded::until([&] { return loop.boundary >= 400; }));
  const std::uint64_t ticks = loop.boundary;
  EXPECT_GE(haptics::monotonicNs() - begun, std::int64_t(ticks - 2) * 125'000);
}

TEST(InStep, StopIsObeyedThoughTheAnswerIsAForce) {
  InStep it;
  for (int tick = 0; tick < 20; ++tick) {
    it.awaited(1s);
    it.device->write(Wrench{Vec3{4, 0, 0}, Vec3::Zero()});
  }
  EXPECT_TRUE(Threaded::until([&] { return it.wire->pushes > 0; }));
  it.device->stop();
  const int stopped = it.round;
  for (int tick = 0; tick < 20; ++tick) {
    it.awaited(1s);
    it.device->write(Wrench{Vec3{4, 0, 0}, Vec3::Zero()});
  }
  ASSERT_TRUE(Threaded::until([&] { return it.round > stopped + 10; }));
  // the one under way, and one that had looked already
  for (int n = stopped + 2; n < it.round && n < InStep::kMost; ++n)
    EXPECT_EQ(it.sent[std::size_t(n)], 0.0) << n - stopped;
}

TEST(Threaded, IsNotInStepUnlessItsTransportIs) {
  Threaded it;
  EXPECT_FALSE(it.device->inStep());
  EXPECT_EQ(it.device->write(Wrench{}), DeviceStatus::Ok);
}

/// A device whose writes tell which reading they answer.
class Numbered final : public haptics::Device {
 public:
  Numbered(std::unique_ptr<haptics::Device> device, std::atomic<int>& answered)
      : device_{std::move(device)}, answered_{answered} {}
  const haptics::DeviceRating& rating() const noexcept override { return device_->rating(); }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    const DeviceStatus status = device_->read(reading);
    number_ = int(reading.X_BD.translation().x());
    return status;
  }
  DeviceStatus write(const Wrench& wrench) noexcept override {
    answered_ = number_;
    return device_->write(wrench);
  }
  bool inStep() const noexcept override { return device_->inStep(); }
  std::int64_t awaitReading(std::int64_t until_ns) noexcept override {
    return device_->awaitReading(until_ns);
  }
  void stop() noexcept override { device_->stop(); }
  void resume() noexcept override { device_->resume(); }

 private:
  std::unique_ptr<haptics::Device> device_;
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
  EXPECT_TRUE(Threaded::until([&] { return in_step >= 40; }));
  it.wire->says = kHang;
  ASSERT_TRUE(Threaded::until([&] { return it.wire->hangs.load(); }));
  const std::uint64_t ticks = loop.boundary;
  EXPECT_TRUE(Threaded::until([&] { return loop.boundary > ticks + 20; }));
  it.wire->says = DeviceStatus::Ok;
}

}  // namespace
