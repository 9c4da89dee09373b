// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/relay.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <limits>
#include <thread>

// The rules of what may be sent, without a device. Both sides are called in turn from one thread,
// except where what is tested is two of them at once.

namespace {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Relay;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Wrench;
using namespace std::chrono_literals;

const Wrench kPush{Vec3{1, 2, 3}, Vec3{0, 0.1, 0}};

bool isZero(const Wrench& wrench_B) {
  return wrench_B.force.isZero(0.0) && wrench_B.torque.isZero(0.0);
}

/// Whether what is written is due, at once: within the 5 ms that it counts, so several times where
/// the machine is busy.
bool passes(Relay& relay) {
  for (int n = 0; n < 1000; ++n) {
    relay.write(kPush);
    const Wrench due = relay.due();
    if (!isZero(due)) return due.force == kPush.force && due.torque == kPush.torque;
  }
  return false;
}
/// The same for what must never be due.
bool neverPasses(Relay& relay) {
  for (int n = 0; n < 100; ++n) {
    relay.write(kPush);
    if (!isZero(relay.due())) return false;
  }
  return true;
}

TEST(Relay, IsZeroWhileTheDeviceIsNotOk) {
  Relay relay{0ms, 0ms};
  EXPECT_TRUE(neverPasses(relay)) << "nothing has come yet";
  EXPECT_TRUE(relay.came(DeviceStatus::NotReady, {}));
  EXPECT_TRUE(neverPasses(relay));
  EXPECT_TRUE(relay.came(DeviceStatus::Ok, {}));
  EXPECT_TRUE(passes(relay));
  EXPECT_TRUE(relay.came(DeviceStatus::NotReady, {}));
  EXPECT_TRUE(neverPasses(relay));
  // one that brought nothing leaves it as it was
  EXPECT_TRUE(relay.came(DeviceStatus::Stale, {}));
  EXPECT_TRUE(neverPasses(relay));
  EXPECT_TRUE(relay.came(DeviceStatus::Ok, {}));
  EXPECT_TRUE(relay.came(DeviceStatus::Stale, {}));
  EXPECT_TRUE(passes(relay));
  EXPECT_FALSE(relay.came(DeviceStatus::Lost, {}));
  EXPECT_TRUE(neverPasses(relay));
}

TEST(Relay, TellsWhetherAForceIsAskedForThoughNoneIsDue) {
  Relay relay{0ms, 0ms};
  const auto asked = [&](const Wrench& wrench_B) {
    relay.write(wrench_B);
    relay.due();
    return relay.asked();
  };
  const auto comesToAsk = [&](const Wrench& wrench_B) {
    for (int n = 0; n < 1000; ++n)
      if (asked(wrench_B)) return true;
    return false;
  };
  for (const DeviceStatus status : {DeviceStatus::NotReady, DeviceStatus::Ok}) {
    relay.came(status, {});
    EXPECT_TRUE(comesToAsk(kPush));
    EXPECT_TRUE(comesToAsk(Wrench{.torque = {0, 0, 0.1}}));
    EXPECT_FALSE(asked(Wrench{}));
    EXPECT_FALSE(asked(Wrench{Vec3::Constant(std::numeric_limits<double>::quiet_NaN())}));
    EXPECT_TRUE(comesToAsk(kPush));
    relay.stop();
    EXPECT_FALSE(asked(kPush));
    relay.resume();
  }
}

TEST(Relay, ResumeTakesBackWhatWasWrittenBefore) {
  Relay relay{0ms, 0ms};
  relay.came(DeviceStatus::Ok, {});
  for (int round = 0; round < 100; ++round) {
    ASSERT_TRUE(passes(relay));
    relay.stop();
    ASSERT_TRUE(neverPasses(relay));
    // taken by due() before the resume(), and not
    relay.write(kPush);
    if (round % 2 == 0) relay.due();
    relay.resume();
    EXPECT_TRUE(isZero(relay.due()));
    EXPECT_TRUE(isZero(relay.due()));
  }
  EXPECT_TRUE(passes(relay));
}

TEST(Relay, ResumeWithoutAStopTakesNothingBack) {
  Relay relay{0ms, 0ms};
  relay.came(DeviceStatus::Ok, {});
  bool sent = false;
  for (int n = 0; n < 1000 && !sent; ++n) {
    relay.write(kPush);
    relay.resume();
    sent = !isZero(relay.due());
  }
  EXPECT_TRUE(sent);
}

/// Holds this thread to one of the processors that it may use, counted from 0. False: there are not
/// so many.
bool holdTo(int nth) {
  cpu_set_t may, one;
  CPU_ZERO(&may);
  CPU_ZERO(&one);
  sched_getaffinity(0, sizeof(may), &may);
  for (int n = 0; n < CPU_SETSIZE; ++n)
    if (CPU_ISSET(n, &may) && nth-- == 0) {
      CPU_SET(n, &one);
      return sched_setaffinity(0, sizeof(one), &one) == 0;
    }
  return false;
}

// Forces are written only while it is stopped, and the device's thread knows of the stop by then:
// so none may ever be due, however resume() falls between what due() looks at. Threads that share a
// processor never meet there.
TEST(Relay, ResumeTakesBackWhatDueIsJustLookingAt) {
  Relay relay{0ms, 0ms};
  std::atomic<bool> ending{false}, apart{false};
  std::atomic<long> looks{0}, forces{0};
  std::thread device{[&] {
    holdTo(0);
    relay.came(DeviceStatus::Ok, {});
    while (!ending) {
      forces += !isZero(relay.due());
      ++looks;
    }
  }};
  std::thread servo{[&] {
    apart = holdTo(1);
    // the look that is under way, and one that begins later
    const auto looksAgain = [&] {
      for (const long from = looks; looks < from + 2;)
        ;
    };
    for (int round = 0; apart && round < 20'000; ++round) {
      relay.stop();
      looksAgain();
      relay.write(kPush);
      relay.resume();
      looksAgain();
    }
    ending = true;
  }};
  servo.join();
  device.join();
  if (!apart) GTEST_SKIP() << "needs two processors";
  EXPECT_EQ(forces, 0);
}

TEST(Relay, OnceSilentForTooLongItIsLostWhateverComesLater) {
  Relay relay{0ms, 1ms};
  relay.came(DeviceStatus::Ok, {});
  std::this_thread::sleep_for(2ms);
  DeviceReading reading;
  ASSERT_EQ(relay.read(reading), DeviceStatus::Lost);
  EXPECT_EQ(reading.trouble, Trouble::Lost);
  // the device's thread lives on, and asks
  EXPECT_TRUE(relay.came(DeviceStatus::Ok, {}));
  EXPECT_TRUE(neverPasses(relay));
  reading.trouble = Trouble::None;
  EXPECT_EQ(relay.read(reading), DeviceStatus::Lost);
  EXPECT_EQ(reading.trouble, Trouble::Lost);
  EXPECT_EQ(relay.write(kPush), DeviceStatus::Lost);
}

TEST(Relay, AfterLostNothingCountsAnyMore) {
  Relay relay{0ms, 0ms};
  EXPECT_FALSE(relay.came(DeviceStatus::Lost, {.trouble = Trouble::MotorsHot}));
  EXPECT_FALSE(relay.came(DeviceStatus::Ok, {}));
  EXPECT_TRUE(neverPasses(relay));
  DeviceReading reading;
  EXPECT_EQ(relay.read(reading), DeviceStatus::Lost);
  EXPECT_EQ(reading.trouble, Trouble::MotorsHot);
}

TEST(Relay, LostComesInItsOwnWordsToWhoReadsMeanwhile) {
  for (int n = 0; n < 300; ++n) {
    Relay relay{0ms, 0ms};
    std::atomic<bool> reads{false};
    std::jthread device([&] {
      while (!reads) std::this_thread::yield();
      relay.came(DeviceStatus::Lost, {.trouble = Trouble::MotorsHot});
    });
    DeviceReading reading;
    while (relay.read(reading) != DeviceStatus::Lost) reads = true;
    ASSERT_EQ(reading.trouble, Trouble::MotorsHot) << n;
    ASSERT_EQ(relay.write(kPush), DeviceStatus::Lost) << n;
  }
}

}  // namespace
