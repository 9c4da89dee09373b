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

#include "tests/unit/haptics/devices/fake_transport.h"

// To be run under the thread sanitizer too: what it says counts as a failure.

namespace {

using fakes::ConnectionWatch;
using fakes::FakeTransport;
using fakes::kHang;
using fakes::until;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;
using namespace std::chrono_literals;

struct Threaded {
  explicit Threaded(std::chrono::milliseconds fresh = 0ms,
                    std::function<void(const Wrench&)> during = nullptr) {
    if (during) wire->during = std::move(during);
    device =
        haptics::threaded(std::make_unique<FakeTransport>(wire), haptics::DeviceRating{}, fresh);
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

  std::shared_ptr<ConnectionWatch> wire = std::make_shared<ConnectionWatch>();
  std::unique_ptr<haptics::Device> device;
  DeviceReading reading;
};

TEST(Threaded, IsNotReadyBeforeTheFirstExchangeAndGivesWhatCameLast) {
  Threaded it;
  it.wire->says = DeviceStatus::NotReady;
  it.wire->trouble = Trouble::NotHomed;
  ASSERT_TRUE(until([&] {
    return it.device->read(it.reading) == DeviceStatus::NotReady &&
           it.reading.trouble == Trouble::NotHomed;
  }));
  it.wire->says = DeviceStatus::Ok;
  it.wire->trouble = Trouble::None;
  it.wire->x = 0.25;
  ASSERT_TRUE(it.reads(DeviceStatus::Ok));
  EXPECT_EQ(it.reading.trouble, Trouble::None);
  EXPECT_TRUE(until([&] {
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
  EXPECT_TRUE(until([&] {
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
    EXPECT_TRUE(until([&] { return it.wire->pushes > pushes; }));
    it.device->stop();
    const int at_stop = it.wire->pushes;
    EXPECT_TRUE(it.exchanged(2));  // the one under way, and one that began later
    const int after = it.wire->pushes;
    EXPECT_LE(after, at_stop + 1) << "two exchanges after stop() carried a force";
    EXPECT_TRUE(it.exchanged(10));
    EXPECT_EQ(it.wire->pushes, after);
    ++resumes;
    EXPECT_TRUE(until([&] { return resumes == resumed; }));
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
  EXPECT_TRUE(until([&] {
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
  ASSERT_TRUE(until([&] {
    it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()});
    return it.device->read(it.reading) == DeviceStatus::Lost;
  }));
  EXPECT_EQ(it.reading.trouble, Trouble::Lost);
  EXPECT_EQ(it.device->write(Wrench{Vec3{1, 0, 0}, Vec3::Zero()}), DeviceStatus::Lost);
  // three that failed and the zero at the end, and one or two that had begun before
  ASSERT_TRUE(until([&] { return it.wire->destroyed_after >= 0; }));
  EXPECT_LE(it.wire->exchanges, from + 5);
  EXPECT_EQ(it.wire->force, 0.0);
  it.wire->says = DeviceStatus::Ok;
  EXPECT_EQ(it.device->read(it.reading), DeviceStatus::Lost);
  it.device->resume();
  EXPECT_EQ(it.device->write(Wrench{}), DeviceStatus::Lost);
}

TEST(Threaded, TwoThatFailAreForgivenByOneThatDoesNot) {
  std::atomic<int> n{0};
  auto wire = std::make_shared<ConnectionWatch>();
  wire->during = [&, raw = wire.get()](const Wrench&) {
    raw->says = ++n % 3 == 0 ? DeviceStatus::Ok : DeviceStatus::Stale;
  };
  const auto device =
      haptics::threaded(std::make_unique<FakeTransport>(wire), haptics::DeviceRating{}, 0ms);
  ASSERT_TRUE(until([&] { return wire->exchanges > 60; }));
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
  ASSERT_TRUE(until([&] { return it.wire->destroyed_after >= 0; }));
  EXPECT_LE(it.wire->exchanges, from + 3);
}

TEST(Threaded, AReadingThatGrowsOldIsStaleAndStands) {
  Threaded it{20ms};
  it.wire->x = 0.125;
  ASSERT_TRUE(until([&] {
    it.device->read(it.reading);
    return it.reading.X_BD.translation().x() == 0.125;
  }));
  it.wire->says = kHang;
  ASSERT_TRUE(it.reads(DeviceStatus::Stale));
  EXPECT_EQ(it.reading.X_BD.translation().x(), 0.125);
  it.wire->says = DeviceStatus::Ok;
  EXPECT_TRUE(until([&] {
    const DeviceStatus status = it.device->read(it.reading);
    return status == DeviceStatus::Ok || status == DeviceStatus::Lost;
  }));
}

TEST(Threaded, WhoseReadingsNeverAgeIsNotStale) {
  Threaded it{0ms};
  ASSERT_TRUE(it.reads(DeviceStatus::Ok));
  it.wire->says = kHang;
  ASSERT_TRUE(until([&] { return it.wire->hangs.load(); }));
  EXPECT_NE(it.device->read(it.reading), DeviceStatus::Stale);
  it.wire->says = DeviceStatus::Ok;
}

TEST(Threaded, AnExchangeThatHangsIsLostAndClosingDoesNotHang) {
  auto wire = std::make_shared<ConnectionWatch>();
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
  ASSERT_TRUE(until([&] { return wire->destroyed_after >= 0; }));
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
    std::shared_ptr<ConnectionWatch> wire;
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

TEST(Threaded, IsNotInStepUnlessItsTransportIs) {
  Threaded it;
  EXPECT_FALSE(it.device->inStep());
  EXPECT_EQ(it.device->write(Wrench{}), DeviceStatus::Ok);
}

}  // namespace
