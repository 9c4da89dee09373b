// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <limits>
#include <thread>

#include "datasets/edits/edit_history.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/proxy/cutting.h"
#include "haptics/session.h"
#include "tests/scenario/fake_device.h"
#include "tests/scenario/trial.h"
#include "tests/support/made.h"

// What may go wrong between a real device and a hand, each done on purpose with the hand pressed
// on a ball at full force.

namespace {

using haptics::DeviceStatus;
using haptics::ForceReason;
using haptics::ForceState;
using haptics::ForceTransition;
using haptics::Handling;
using haptics::Mat3;
using haptics::Pose;
using haptics::Quat;
using haptics::Settings;
using haptics::Snapshot;
using haptics::Trouble;
using haptics::Vec3;
using haptics::Watchdog;
using haptics::Wrench;
using made::at;

bool isZero(const Wrench& wrench) {
  return (wrench.force.array() == 0.0).all() && (wrench.torque.array() == 0.0).all();
}

/// A real device's loop, a tick a call, with the clock in the test's hand. Its base is turned
/// against the world, and the tool moves three times as far as the hand.
struct Held {
  static constexpr double kScale = 3.0;
  const Mat3 R_WB = Quat{Eigen::AngleAxisd{0.7, Vec3(1, 2, -1).normalized()}}.toRotationMatrix();

  explicit Held(haptics::ServoRate at = {})
      : rate{at}, stage{stageOf("sphere", ballTool(200, 3e-3))} {
    settings.isovalue = stage.isovalue;
    settings.stiffness = 1000.0;
    settings.position_scale = kScale;
    auto made = std::make_unique<FakeDevice>(X_B);
    device = made.get();
    loop = std::make_unique<haptics::ServoLoop>(std::move(made), settings, kAbove, 0.0, rate);
    handling.R_WB = R_WB;
    loop->handling.publish(handling);
    loop->scenes.offer(std::make_unique<haptics::Engagement>(stage.scene, kAbove));
  }
  const Wrench& step() { return step(rate.period_ns()); }
  const Wrench& step(std::int64_t pause_ns) {
    now += pause_ns;
    loop->step(1e-9 * double(now), now);
    return device->writes.back();
  }
  void steps(int n) {
    for (int i = 0; i < n; ++i) step();
  }
  int ticksIn(double seconds) const { return int(std::lround(seconds / rate.period())); }
  /// The hand moves by this much of the world in so many ticks.
  void move(const Vec3& by_W, int ticks) {
    for (int n = 0; n < ticks; ++n) {
      device->X_BD.translation() += R_WB.transpose() * by_W / kScale / ticks;
      step();
    }
  }
  /// Armed, and pressed 2 mm into the ball's top.
  void press() {
    step();
    loop->armed = true;
    move({0, 0, -0.009}, ticksIn(0.06));
    steps(ticksIn(1.2));
    ASSERT_EQ(snapshot().force_state, ForceState::On);
    ASSERT_GT(device->writes.back().force.norm(), 1.5);
  }
  Snapshot snapshot() {
    loop->snapshots.take(taken);
    return taken;
  }
  std::vector<ForceTransition> transitions() {
    std::vector<ForceTransition> all;
    ForceTransition one;
    while (loop->transitions.try_dequeue(one)) all.push_back(one);
    return all;
  }
  /// From here on the force is zero, ticks long, whatever the device says, until it is armed; then
  /// it comes from zero.
  void expectLatched(ForceReason why) {
    EXPECT_EQ(snapshot().force_state, ForceState::Fault);
    EXPECT_EQ(snapshot().reason, why);
    EXPECT_FALSE(loop->armed);
    for (int n = 0; n < 2000; ++n) ASSERT_TRUE(isZero(step()));
    EXPECT_EQ(snapshot().force_state, ForceState::Fault);
    device->status = DeviceStatus::Ok;
    for (int n = 0; n < 100; ++n) ASSERT_TRUE(isZero(step()));
    EXPECT_EQ(snapshot().force_state, ForceState::Fault);
  }
  void expectRampsWhenArmed() {
    loop->armed = true;
    for (int n = 1; n <= 1000; ++n)
      ASSERT_LE(step().force.norm(), 8.0 * n * 1e-3 + 1e-9) << "tick " << n;
  }

  const haptics::ServoRate rate;
  const Pose kAbove = at(0, 0, 0.030);
  const Pose X_B = at(Vec3(0.4, -0.2, 0.1), Quat{Eigen::AngleAxisd{0.3, Vec3::UnitY()}});
  Stage stage;
  Settings settings;
  Handling handling;
  FakeDevice* device = nullptr;
  std::unique_ptr<haptics::ServoLoop> loop;
  Snapshot taken;
  std::int64_t now = 1'000'000'000;
};

TEST(Hazards, NoForceBeforeTheUserArms) {
  Held held;
  held.step();
  held.move({0, 0, -0.009}, 60);
  for (int n = 0; n < 3000; ++n) ASSERT_TRUE(isZero(held.step()));
  EXPECT_EQ(held.snapshot().force_state, ForceState::Ready);
  EXPECT_GT(held.snapshot().coupling_W.force.norm(), 1.5);  // the tool is held, the hand is not
  held.expectRampsWhenArmed();
}

TEST(Hazards, TheForceActsAgainstTheHandsOwnWay) {
  Held held;
  ASSERT_NO_FATAL_FAILURE(held.press());
  const Snapshot snapshot = held.snapshot();
  const Wrench sent = held.device->writes.back();
  EXPECT_LT((held.R_WB * sent.force - snapshot.felt_W.force).norm(), 1e-12);
  EXPECT_LT((held.R_WB * sent.torque - snapshot.felt_W.torque).norm(), 1e-12);
  // 1000 N/m at 2 mm: what the tool pulls, felt along the way that the hand came
  EXPECT_NEAR(sent.force.norm(), 2.0, 0.2);
  const Vec3 way_B = held.R_WB.transpose() * Vec3(0, 0, -1);
  EXPECT_LT(sent.force.normalized().dot(way_B), -0.99);
}

TEST(Hazards, UnpluggedUnderForceIsZeroInThatTickAndLatched) {
  for (const bool write : {false, true}) {
    Held held;
    ASSERT_NO_FATAL_FAILURE(held.press());
    held.device->status = DeviceStatus::Lost;
    if (write) held.device->status_of_read = DeviceStatus::Ok;  // the pose still came
    held.step();
    EXPECT_TRUE(held.device->stopped);
    EXPECT_TRUE(isZero(held.step()));
    EXPECT_FALSE(held.loop->armed);
    held.device->status_of_read.reset();
    held.step();
    held.expectLatched(ForceReason::Lost);
    // gone for good: arming does not help, opening it anew does
    for (int n = 0; n < 2000; ++n) {
      held.loop->armed = true;
      ASSERT_TRUE(isZero(held.step()));
    }
    EXPECT_EQ(held.snapshot().force_state, ForceState::Fault);
    EXPECT_TRUE(held.device->stopped);
  }
}

TEST(Hazards, ThreeReadingsWithNothingNewAreZeroAndTwoAreNot) {
  Held held;
  ASSERT_NO_FATAL_FAILURE(held.press());
  held.device->status = DeviceStatus::Stale;
  EXPECT_GT(held.step().force.norm(), 1.5);
  EXPECT_GT(held.step().force.norm(), 1.5);
  for (int n = 0; n < 50; ++n) ASSERT_TRUE(isZero(held.step()));
  EXPECT_EQ(held.snapshot().reason, ForceReason::Stale);
  held.device->status = DeviceStatus::Ok;
  for (int n = 1; n <= 1000; ++n) ASSERT_LE(held.step().force.norm(), 8.0 * n * 1e-3 + 1e-9);
  EXPECT_GT(held.step().force.norm(), 1.5);
}

// what were counted in ticks would be over four times as soon at 4 kHz
class EveryRate : public testing::TestWithParam<haptics::ServoRate> {
 protected:
  /// s until a force is felt again, from now on; what comes may not come faster than the ramp.
  static double untilFelt(Held& held) {
    int n = 0, zero = 0;
    for (; n < held.ticksIn(1.1); ++n) {
      const double force = held.step().force.norm();
      if (force == 0.0) zero = n + 1;
      EXPECT_LE(force, 8.0 * (n - zero + 2) * held.rate.period() + 1e-9) << n;
    }
    EXPECT_EQ(held.snapshot().force_state, ForceState::On);
    return zero * held.rate.period();
  }
};

TEST_P(EveryRate, ReadingsWithNothingNewAreZeroAfterTwoMilliseconds) {
  Held held{GetParam()};
  ASSERT_NO_FATAL_FAILURE(held.press());
  held.device->status = DeviceStatus::Stale;
  for (int n = 0; n < held.ticksIn(0.0015); ++n) ASSERT_GT(held.step().force.norm(), 1.5) << n;
  held.steps(1);
  EXPECT_TRUE(isZero(held.step()));
  EXPECT_EQ(held.snapshot().reason, ForceReason::Stale);
  held.device->status = DeviceStatus::Ok;
  EXPECT_LE(untilFelt(held), held.rate.period());
}

TEST_P(EveryRate, ADeviceIsLetGoOfAtTheSameSpeed) {
  Held held{GetParam()};
  ASSERT_NO_FATAL_FAILURE(held.press());
  const auto pushed = [&](double speed, double seconds) {
    double least = INFINITY;
    for (int n = 0; n < held.ticksIn(seconds); ++n) {
      held.device->X_BD.translation() +=
          held.R_WB.transpose() * Vec3(0, 0, -speed * held.rate.period());
      least = std::min(least, held.step().force.norm());
    }
    return least;
  };
  EXPECT_GT(pushed(1.4, 0.005), 1.5);
  EXPECT_GT(pushed(-1.4, 0.005), 1.5);
  EXPECT_EQ(pushed(1.6, 0.002), 0.0);
  EXPECT_EQ(held.snapshot().reason, ForceReason::TooFast);
  EXPECT_NEAR(untilFelt(held), haptics::MotionGuard::kCalm, 0.0015);
}

TEST_P(EveryRate, TheClutchFadesAsLong) {
  Held held{GetParam()};
  ASSERT_NO_FATAL_FAILURE(held.press());
  held.handling.clutch = true;
  held.loop->handling.publish(held.handling);
  int n = 0;
  while (!isZero(held.step())) ASSERT_LT(++n, held.ticksIn(0.1));
  EXPECT_NEAR(n * held.rate.period(), haptics::Safety::kFade, 0.0015);
}

TEST_P(EveryRate, AGapIsFiveMilliseconds) {
  Held held{GetParam()};
  ASSERT_NO_FATAL_FAILURE(held.press());
  EXPECT_FALSE(isZero(held.step(4'900'000)));
  EXPECT_TRUE(isZero(held.step(5'100'000)));
  EXPECT_EQ(held.snapshot().reason, ForceReason::Gap);
  EXPECT_LE(untilFelt(held), 2 * held.rate.period());
}

TEST_P(EveryRate, TheSearchForAWayOutTakesAsLong) {
  // inside wherever it is, but beyond the grid
  const auto scene = made::scene(
      datasets::sampledFloat(datasets::centredGrid(60, 1e-3), [](const Vec3&) { return 1000.0; }),
      ballTool(20, 1e-3));
  haptics::Proxy proxy{*scene, at(0, 0, 0)};
  int n = 0;
  for (bool outside = false; !outside; ++n) {
    ASSERT_LT(n, 1000);
    haptics::Budget budget = haptics::Budget::counted(50);  // or it is found sooner
    haptics::tick(*scene, 500.0, {}, at(0, 0, 0), proxy, budget, GetParam().period());
    outside = !proxy.recovery.active;
  }
  EXPECT_NEAR(n * GetParam().period(), 0.018, 0.0011);
}
INSTANTIATE_TEST_SUITE_P(Hazards, EveryRate, testing::ValuesIn(haptics::kServoRates),
                         [](const auto& with) { return std::to_string(with.param.hz) + "Hz"; });

TEST(Hazards, AnEncoderThatJumpsIsAFault) {
  for (const bool turn : {false, true}) {
    Held held;
    ASSERT_NO_FATAL_FAILURE(held.press());
    const Pose before = held.device->X_BD;
    if (turn)
      held.device->X_BD.linear() =
          before.linear() * Eigen::AngleAxisd{0.3, Vec3::UnitX()}.toRotationMatrix();
    else
      held.device->X_BD.translation().x() += 0.011;  // in one tick: 11 m/s
    EXPECT_TRUE(isZero(held.step()));
    held.expectLatched(ForceReason::Jump);
    held.device->X_BD = before;
    EXPECT_TRUE(isZero(held.step()));  // back is a jump too
    held.step();
    held.expectRampsWhenArmed();
  }
}

TEST(Hazards, ADeviceThatRunsAwayIsLetGoOf) {
  Held held;
  ASSERT_NO_FATAL_FAILURE(held.press());
  for (int n = 0; n < 20; ++n) {
    held.device->X_BD.translation() += held.R_WB.transpose() * Vec3(0, 0, -0.0016);  // 1.6 m/s
    ASSERT_TRUE(isZero(held.step())) << n;
  }
  EXPECT_EQ(held.snapshot().reason, ForceReason::TooFast);
  // calm for 50 ms before anything is felt
  for (int n = 0; n < 49; ++n) ASSERT_TRUE(isZero(held.step())) << n;
  for (int n = 1; n <= 1000; ++n) ASSERT_LE(held.step().force.norm(), 8.0 * n * 1e-3 + 1e-9);
  EXPECT_EQ(held.snapshot().force_state, ForceState::Ramping);
}

TEST(Hazards, NotHomedIsOffAndItsPosesAreNotFollowed) {
  Held held;
  ASSERT_NO_FATAL_FAILURE(held.press());
  const Pose X_WD = held.snapshot().X_WD;
  held.device->status = DeviceStatus::NotReady;
  held.device->X_BD.translation().x() += 0.5;
  for (int n = 0; n < 50; ++n) ASSERT_TRUE(isZero(held.step()));
  EXPECT_EQ(held.snapshot().force_state, ForceState::Off);
  EXPECT_EQ(held.snapshot().reason, ForceReason::NotHomed);
  EXPECT_EQ(held.snapshot().X_WD.translation(), X_WD.translation());
  // homed again, elsewhere: the tool stays, and the user is asked
  held.device->status = DeviceStatus::Ok;
  for (int n = 0; n < 2000; ++n) ASSERT_TRUE(isZero(held.step()));
  EXPECT_EQ(held.snapshot().force_state, ForceState::Ready);
  EXPECT_LT((held.snapshot().X_WD.translation() - X_WD.translation()).norm(), 1e-12);
  held.expectRampsWhenArmed();
}

TEST(Hazards, AGapIsZeroAndANewRampAndThreeOfThemAreAFault) {
  Held held;
  ASSERT_NO_FATAL_FAILURE(held.press());
  for (int gap = 0; gap < 2; ++gap) {
    EXPECT_TRUE(isZero(held.step(5'100'000)));
    EXPECT_EQ(held.snapshot().reason, ForceReason::Gap);
    for (int n = 1; n <= 1000; ++n) ASSERT_LE(held.step().force.norm(), 8.0 * n * 1e-3 + 1e-9);
    held.steps(10);
    EXPECT_EQ(held.snapshot().force_state, ForceState::On);  // by itself
  }
  EXPECT_TRUE(isZero(held.step(5'100'000)));
  held.expectLatched(ForceReason::Stalled);
  held.expectRampsWhenArmed();
  // what is longer ago than ten seconds counts no more
  held.steps(9'000);
  EXPECT_TRUE(isZero(held.step(5'100'000)));
  EXPECT_NE(held.snapshot().force_state, ForceState::Fault);
}

TEST(Hazards, GapsBeforeItIsArmedAreNoFault) {
  Held held;
  held.step();
  for (int n = 0; n < 10; ++n) EXPECT_TRUE(isZero(held.step(6'000'000)));
  EXPECT_EQ(held.snapshot().force_state, ForceState::Ready);
}

TEST(Hazards, ALateTickIsNoGap) {
  Held held;
  ASSERT_NO_FATAL_FAILURE(held.press());
  EXPECT_GT(held.step(4'900'000).force.norm(), 1.5);
}

TEST(Watchdog, StopsADeviceWhoseServoThreadHangsAndLetsItGoOnAfterwards) {
  FakeDevice device{at(0, 0, 0)};
  Watchdog watchdog{device};
  const std::int64_t ms = 1'000'000;
  watchdog.look(500 * ms);  // nothing has begun: nothing hangs
  EXPECT_FALSE(device.stopped);
  EXPECT_FALSE(watchdog.beat(1000 * ms).gap);
  watchdog.look(1004 * ms);
  EXPECT_FALSE(device.stopped);
  watchdog.look(1006 * ms);
  EXPECT_TRUE(device.stopped);
  watchdog.look(1007 * ms);
  EXPECT_TRUE(watchdog.beat(1008 * ms).gap);
  EXPECT_FALSE(device.stopped);
  EXPECT_FALSE(watchdog.beat(1009 * ms).gap);
  // a stop between two beats that were in time: it had looked at the older
  EXPECT_FALSE(watchdog.beat(1013 * ms).gap);
  watchdog.look(1019 * ms);
  const Watchdog::Beat second = watchdog.beat(1019 * ms);
  EXPECT_TRUE(second.gap);
  EXPECT_FALSE(second.stalled);
  watchdog.look(1030 * ms);
  EXPECT_TRUE(watchdog.beat(1030 * ms).stalled);
}

TEST(Watchdog, CountsAGapOnceThoughItsStopCameLate) {
  FakeDevice device{at(0, 0, 0)};
  Watchdog watchdog{device};
  const std::int64_t ms = 1'000'000;
  watchdog.beat(1000 * ms);
  for (int gap = 1; gap <= 2; ++gap) {
    const std::int64_t then = (1000 + 100 * gap) * ms;
    watchdog.beat(then - 10 * ms);  // a gap of its own, told by the beat
    watchdog.look(then);            // and the stop for it, late
    EXPECT_TRUE(watchdog.beat(then + ms).gap);
    EXPECT_FALSE(device.stopped);
  }
}

// the whole of it, with threads: a read that hangs
TEST(Watchdog, ZeroReachesADeviceWhoseReadHangs) {
  const Stage stage = stageOf("sphere", ballTool(50, 3e-3));
  auto made = std::make_unique<FakeDevice>(at(0, 0, 0.03));
  FakeDevice* device = made.get();
  haptics::ServoLoop loop{std::move(made), Settings{.isovalue = stage.isovalue}, at(0, 0, 0.03)};
  loop.scenes.offer(std::make_unique<haptics::Engagement>(stage.scene, at(0, 0, 0.03)));
  loop.start();
  while (loop.boundary.load() < 50) std::this_thread::sleep_for(std::chrono::milliseconds{1});
  device->hang = true;
  while (!device->stopped) std::this_thread::sleep_for(std::chrono::milliseconds{1});
  const std::uint64_t ticks = loop.boundary.load();
  device->hang = false;
  while (loop.boundary.load() < ticks + 20)
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  EXPECT_FALSE(device->stopped);  // it goes on by itself
}

TEST(Hazards, ClutchedTheToolStaysTheForceFadesAndNothingJumps) {
  for (const bool key : {true, false}) {
    Held held;
    held.handling.clutch_button = 2;
    held.loop->handling.publish(held.handling);
    ASSERT_NO_FATAL_FAILURE(held.press());
    const Pose X_WD = held.snapshot().X_WD;
    held.handling.clutch = key;
    held.loop->handling.publish(held.handling);
    held.device->buttons = key ? 0U : 4U;
    double last = 8.0;
    for (int n = 0; n < 60; ++n) {
      held.device->X_BD.translation().x() += 2e-4;
      held.device->X_BD.linear() =
          held.device->X_BD.linear() * Eigen::AngleAxisd{0.01, Vec3::UnitZ()}.toRotationMatrix();
      const double force = held.step().force.norm();
      EXPECT_LE(force, last);
      last = force;
      EXPECT_TRUE(held.snapshot().clutched);
      EXPECT_TRUE(held.snapshot().X_WD.isApprox(X_WD, 0.0));
    }
    EXPECT_EQ(last, 0.0);
    held.handling.clutch = false;
    held.loop->handling.publish(held.handling);
    held.device->buttons = 0;
    held.step();
    EXPECT_LT((held.snapshot().X_WD.matrix() - X_WD.matrix()).cwiseAbs().maxCoeff(), 1e-12);
    for (int n = 1; n <= 1000; ++n) ASSERT_LE(held.step().force.norm(), 8.0 * n * 1e-3 + 1e-9);
    // and follows from there, by as much as the hand moves
    held.move({0.001, 0.002, 0.003}, 20);
    EXPECT_LT((held.snapshot().X_WD.translation() - X_WD.translation() - Vec3(0.001, 0.002, 0.003))
                  .norm(),
              1e-12);
  }
}

TEST_P(EveryRate, TheCameraAndTheScaleTurnTheMappingWithoutAJump) {
  Held held{GetParam()};
  ASSERT_NO_FATAL_FAILURE(held.press());
  Pose X_WD = held.snapshot().X_WD;
  Vec3 last = held.device->writes.back().force;
  for (int n = 0; n < 100; ++n) {
    held.handling.R_WB = Eigen::AngleAxisd{0.03 * n, Vec3::UnitY()}.toRotationMatrix();
    held.loop->handling.publish(held.handling);
    held.settings.position_scale = 1.0 + 0.02 * n;
    held.loop->settings.publish(held.settings);
    held.step();
    EXPECT_LT((held.snapshot().X_WD.matrix() - X_WD.matrix()).cwiseAbs().maxCoeff(), 1e-11);
    // and what the hand feels turns slowly: 2 rad/s
    const Vec3 force = held.device->writes.back().force;
    EXPECT_LT((force - last).norm(), 2.1 * held.rate.period() * force.norm() + 1e-6);
    last = force;
  }
  // until it has come round, and nothing of the hand's own way is lost meanwhile
  held.move({0.003, 0, 0}, 30);
  EXPECT_GT((held.snapshot().X_WD.translation() - X_WD.translation()).norm(), 0.002);
  X_WD = held.snapshot().X_WD;
  // what is no rotation is not taken
  held.handling.R_WB = 2.0 * Mat3::Identity();
  held.loop->handling.publish(held.handling);
  held.step();
  EXPECT_LT((held.snapshot().X_WD.matrix() - X_WD.matrix()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Hazards, HoldToRunLetsGoWhenNobodyHolds) {
  Held held;
  held.handling.hold_to_run = true;
  held.handling.hold_button = 0;
  held.loop->handling.publish(held.handling);
  held.device->buttons = 1;
  ASSERT_NO_FATAL_FAILURE(held.press());
  held.device->buttons = 0;
  double last = 8.0;
  for (int n = 1; n <= 50; ++n) {
    const double force = held.step().force.norm();
    EXPECT_LE(force, last);
    last = force;
  }
  EXPECT_NEAR(last, 0.0, 1e-9);
  for (int n = 0; n < 500; ++n) ASSERT_TRUE(isZero(held.step()));
  EXPECT_EQ(held.snapshot().reason, ForceReason::NotHeld);
  held.handling.held = true;  // the key does as well
  for (int n = 1; n <= 1001; ++n) {
    held.loop->handling.publish(held.handling);  // as the window does at each picture
    ASSERT_LE(held.step().force.norm(), 8.0 * n * 1e-3 + 1e-9);
  }
  EXPECT_GT(held.step().force.norm(), 1.5);
  // and a window that hangs with the key down holds nothing
  for (int n = 0; n < 300; ++n) held.step();
  EXPECT_TRUE(isZero(held.step()));
  EXPECT_EQ(held.snapshot().reason, ForceReason::NotHeld);
}

TEST(Hazards, AnotherSceneComesToTheHandWithTheForceFromZero) {
  Held held;
  ASSERT_NO_FATAL_FAILURE(held.press());
  const Stage other = stageOf("halfspace", ballTool(100, 2e-3));
  const Pose start = at(0.01, 0, 0.02);
  held.loop->scenes.offer(std::make_unique<haptics::Engagement>(other.scene, start));
  EXPECT_LE(held.step().force.norm(), 8.0 * 1e-3 + 1e-9);
  EXPECT_LT((held.snapshot().X_WD.translation() - start.translation()).norm(), 1e-12);
}

TEST(Hazards, EveryTransitionIsAnEvent) {
  Held held;
  ASSERT_NO_FATAL_FAILURE(held.press());
  held.loop->armed = false;
  held.step();
  const std::vector<ForceTransition> all = held.transitions();
  std::vector<ForceState> path{ForceState::Off};
  for (const ForceTransition& one : all) {
    EXPECT_EQ(one.from, path.back());
    EXPECT_GT(one.time, 0.0);
    path.push_back(one.to);
  }
  EXPECT_EQ(path, (std::vector{ForceState::Off, ForceState::Ready, ForceState::Armed,
                               ForceState::Ramping, ForceState::On, ForceState::Ready}));
}

TEST(Hazards, WhatIsWrongWithTheDeviceIsInTheSnapshot) {
  Held held;
  held.device->status = DeviceStatus::NotReady;
  held.device->trouble = Trouble::NotHomed;
  held.step();
  EXPECT_EQ(held.snapshot().trouble, Trouble::NotHomed);
}

/// The same hand with a tool that cuts, and the key of its burr.
struct HeldBurr : Held {
  HeldBurr() {
    loop->recording = &ring;
    offer(kAbove);
  }
  ~HeldBurr() { loop->recording = nullptr; }
  void offer(const Pose& X_WP) {
    haptics::CutLaw law;
    law.burr.radius = 3e-3;
    auto made =
        std::make_unique<haptics::Cutting>(haptics::CarvedScene::of(*stage.scene).value(), law);
    cutting = made.get();
    loop->scenes.offer(std::make_unique<haptics::Engagement>(std::move(made), X_WP));
  }
  void key(bool down) { loop->cut_until = down ? std::numeric_limits<std::int64_t>::max() : 0; }
  /// Whether it turned in the last tick.
  bool turns() {
    haptics::Step last;
    for (haptics::Step step; ring.take(step);) last = step;
    return (last.flags & haptics::StepFlags::kCut) != 0;
  }
  void releaseAndHold() {
    key(false);
    steps(2);
    key(true);
    steps(20);
  }

  haptics::StepRing ring{0};
  haptics::Cutting* cutting = nullptr;
};

TEST(Hazards, NoCutIsLostWhereARecordingLosesSteps) {
  HeldBurr held;
  held.press();
  held.releaseAndHold();
  std::vector<haptics::BurrCut> cuts;
  std::uint64_t steps = 0;
  const auto take = [&] {
    for (haptics::Step step; held.ring.take(step); ++steps)
      if (step.cut) cuts.push_back(*step.cut);
  };
  const auto stepsUnrecorded = [&](int n) {  // the window takes the cuts
    for (; n > 0; n -= 1000) {
      held.steps(std::min(n, 1000));
      for (haptics::BurrCut cut; held.loop->cuts.try_dequeue(cut);) {
      }
    }
  };
  take();
  EXPECT_TRUE(held.snapshot().cuts);
  stepsUnrecorded(3 * static_cast<int>(held.ring.capacity()));
  EXPECT_FALSE(held.snapshot().cuts);
  take();
  held.steps(100);
  EXPECT_TRUE(held.snapshot().cuts);
  held.key(false);
  held.steps(200);
  take();
  EXPECT_LT(steps, held.ring.numbered());
  held.cutting->settle();  // on a slow machine the last cut is under way yet
  const auto made = datasets::edited(held.stage.scene->volume,
                                     std::vector<datasets::Edit>{datasets::Stroke{cuts}});
  ASSERT_TRUE(made);
  const haptics::Volume& left = *held.cutting->scene()->volume;
  EXPECT_EQ(std::memcmp((*made)->voxels.get(), left.voxels.get(),
                        std::size_t(left.grid.voxelCount()) * haptics::sizeOf(left.type)),
            0);
}

TEST(Hazards, ABurrTurnsOnlyWhileItsKeyIsHeldAndWasReleasedBefore) {
  HeldBurr held;
  // held since before the start
  held.key(true);
  held.press();
  EXPECT_FALSE(held.turns());
  EXPECT_EQ(held.cutting->removed().voxels, 0);
  held.releaseAndHold();
  EXPECT_TRUE(held.turns());
  held.steps(200);
  const double removed = held.cutting->removed().volume;
  EXPECT_GT(removed, 1e-10);
  // a window that hangs says it no more
  held.loop->cut_until = held.now + 20'000'000;
  held.steps(10);
  EXPECT_TRUE(held.turns());
  held.steps(10);
  EXPECT_FALSE(held.turns());
  held.steps(200);  // what is left of the cut under way is done
  const double then = held.cutting->removed().volume;
  held.steps(200);
  EXPECT_EQ(held.cutting->removed().volume, then);

  // what ends it, each until the key was released
  const auto ends = [&](const char* what, const std::function<void()>& happens) {
    SCOPED_TRACE(what);
    held.releaseAndHold();
    EXPECT_TRUE(held.turns());
    happens();
    held.steps(50);
    EXPECT_FALSE(held.turns());
    held.loop->armed = true;
    held.steps(held.ticksIn(1.2));
    EXPECT_FALSE(held.turns());
    held.releaseAndHold();
    EXPECT_TRUE(held.turns());
  };
  ends("disarmed", [&] {
    held.loop->armed = false;
    held.steps(held.ticksIn(0.2));
    held.key(false);
    held.steps(2);
    held.key(true);
    held.steps(2);
    EXPECT_FALSE(held.turns());
    held.key(false);
  });
  ends("force off", [&] {
    held.loop->armed = false;
    held.steps(5);
  });
  ends("clutch", [&] {
    held.handling.clutch = true;
    held.loop->handling.publish(held.handling);
    held.steps(50);
    held.handling.clutch = false;
    held.loop->handling.publish(held.handling);
  });
  ends("gap", [&] { held.step(6'000'000); });
  ends("not ready", [&] {
    // right after a cut was begun: it is told once
    haptics::Step last;
    for (int n = 0; n < 1000 && !last.cut; ++n) {
      held.steps(1);
      while (held.ring.take(last)) {
      }
    }
    EXPECT_TRUE(last.cut);
    held.device->status = DeviceStatus::NotReady;
    held.steps(3);
    while (held.ring.take(last)) EXPECT_FALSE(last.cut);
    held.device->status = DeviceStatus::Ok;
  });
  ends("silent", [&] {
    held.device->status = DeviceStatus::Stale;
    held.steps(4);
    held.device->status = DeviceStatus::Ok;
  });
  ends("a question", [&] {
    held.loop->cut_rests = true;
    held.steps(2);
    EXPECT_FALSE(held.turns());
    held.releaseAndHold();
    EXPECT_FALSE(held.turns());
    held.loop->cut_rests = false;
  });
  ends("a gap while the window hangs", [&] {
    held.loop->cut_until = held.now;
    held.step(6'000'000);
    held.steps(20);
    held.key(true);
  });
  ends("another scene", [&] { held.offer(held.snapshot().X_WP); });
  // a button of the device does the same
  held.key(false);
  held.handling.cut_button = 3;
  held.loop->handling.publish(held.handling);
  held.device->buttons = 1U << 3;
  held.steps(2);
  EXPECT_TRUE(held.turns());
  held.device->buttons = 1U << 2;
  held.steps(2);
  EXPECT_FALSE(held.turns());
  // a fault, whatever is held or released
  held.key(true);
  held.device->X_BD.translation().z() += 0.05;
  held.steps(2);
  EXPECT_EQ(held.snapshot().force_state, ForceState::Fault);
  held.releaseAndHold();
  EXPECT_FALSE(held.turns());
}

}  // namespace
