// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/coupling/safety.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/made.h"

// Every rule is broken here on purpose: what would hurt is asked for, and what comes out is zero,
// or within its limit.

namespace {

using haptics::Circumstances;
using haptics::ForceLimits;
using haptics::ForceReason;
using haptics::ForceState;
using haptics::ForceTransition;
using haptics::Safety;
using haptics::Vec3;
using haptics::Wrench;
using made::at;

constexpr double kSafetyPeriod = 1e-3;  // s
constexpr ForceLimits kLimits{.force = 10.0, .torque = 0.2, .ramp_time = 1.0, .slew_time = 0.02};
const Wrench kPress{{0, 0, 4}, {0.1, 0, 0}};
constexpr Circumstances kArmed{.armed = true, .ready = true};
constexpr Circumstances kReady{.armed = false, .ready = true};

Circumstances withheld(ForceReason reason) {
  return {.armed = true, .ready = true, .withheld = reason};
}
Circumstances fault(ForceReason reason, bool armed = true) {
  return {.armed = armed, .ready = true, .fault = reason};
}

bool isZero(const Wrench& wrench) {
  return (wrench.force.array() == 0.0).all() && (wrench.torque.array() == 0.0).all();
}

/// A gate whose tick is one call, and which keeps every transition.
struct Gate {
  explicit Gate(const ForceLimits& limits = kLimits) : safety{limits} {}
  Wrench pass(const Wrench& wanted, bool outside = true, const Circumstances& now = kArmed) {
    safety.begin(now);
    const Wrench sent = safety.pass(wanted, outside, kSafetyPeriod);
    for (const ForceTransition& transition : safety.transitions()) steps.push_back(transition);
    return sent;
  }
  Wrench pass(const Circumstances& now) { return pass(kPress, true, now); }
  void ticks(int n, const Circumstances& now = kArmed) {
    for (int i = 0; i < n; ++i) pass(now);
  }
  Safety safety;
  std::vector<ForceTransition> steps;
};

Gate onAlready(const ForceLimits& limits = kLimits) {
  Gate gate{limits};
  gate.ticks(1100);
  EXPECT_EQ(gate.safety.state(), ForceState::On);
  gate.steps.clear();
  return gate;
}

TEST(Safety, GoesFromOffToOnStepByStepAndTellsEachStep) {
  Gate gate;
  EXPECT_TRUE(isZero(gate.pass({.armed = true, .ready = false, .unready = ForceReason::NotHomed})));
  EXPECT_EQ(gate.safety.state(), ForceState::Off);
  EXPECT_EQ(gate.safety.reason(), ForceReason::NotHomed);
  EXPECT_TRUE(isZero(gate.pass(kReady)));
  EXPECT_EQ(gate.safety.state(), ForceState::Ready);
  EXPECT_TRUE(isZero(gate.pass(withheld(ForceReason::NotHeld))));
  EXPECT_EQ(gate.safety.state(), ForceState::Armed);
  double last = 0.0;
  for (int n = 1; n <= 1000; ++n) {
    const Wrench sent = gate.pass(kArmed);
    ASSERT_EQ(gate.safety.state(), n < 999 ? ForceState::Ramping : gate.safety.state());
    EXPECT_NEAR(sent.force.z(), 4.0 * n * 1e-3, 1e-9);
    EXPECT_NEAR(sent.torque.x(), 0.1 * n * 1e-3, 1e-9);
    EXPECT_GE(sent.force.z(), last);
    last = sent.force.z();
  }
  gate.pass(kArmed);
  EXPECT_EQ(gate.pass(kArmed).force, kPress.force);
  const ForceState states[] = {ForceState::Off, ForceState::Ready, ForceState::Armed,
                               ForceState::Ramping, ForceState::On};
  ASSERT_EQ(gate.steps.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(gate.steps[i].from, states[i]);
    EXPECT_EQ(gate.steps[i].to, states[i + 1]);
  }
  EXPECT_EQ(gate.steps[1].reason, ForceReason::User);
}

TEST(Safety, StoppingIsZeroInTheVeryNextTickFromEveryState) {
  for (const int ticks : {1, 300, 1100})
    for (const bool outside : {true, false}) {
      Gate gate;
      gate.ticks(ticks);
      gate.safety.settingMoved(false);
      gate.pass(kPress, outside);
      for (int n = 0; n < 5; ++n) EXPECT_TRUE(isZero(gate.pass(kPress, outside, kReady)));
      EXPECT_EQ(gate.safety.state(), ForceState::Ready);
      EXPECT_LE(gate.pass(kArmed).force.norm(), 4.0 * 1e-3 + 1e-12);  // and from zero again
    }
}

TEST(Safety, WithoutPosesOrASceneThereIsNothing) {
  Gate gate = onAlready();
  for (const ForceReason why :
       {ForceReason::NoReading, ForceReason::NotHomed, ForceReason::Scene}) {
    EXPECT_TRUE(isZero(gate.pass({.armed = true, .ready = false, .unready = why})));
    EXPECT_EQ(gate.safety.state(), ForceState::Off);
    EXPECT_EQ(gate.safety.reason(), why);
    EXPECT_LE(gate.pass(kArmed).force.norm(), 4.0 * 1e-3 + 1e-12);
    gate.ticks(1100);
  }
}

// doubt: zero at once, and a new ramp over its whole time
TEST(Safety, DoubtIsZeroAtOnceAndThenANewRamp) {
  for (const ForceReason why : {ForceReason::Gap, ForceReason::TooFast, ForceReason::Stale}) {
    Gate gate = onAlready();
    for (int n = 0; n < 5; ++n) EXPECT_TRUE(isZero(gate.pass(withheld(why))));
    EXPECT_EQ(gate.safety.state(), ForceState::Armed);
    EXPECT_EQ(gate.safety.reason(), why);
    for (int n = 1; n <= 1001; ++n)
      EXPECT_NEAR(gate.pass(kArmed).force.z(), 4.0 * std::min(1.0, n * 1e-3), 1e-9);
    ASSERT_EQ(gate.steps.size(), 3u);
    EXPECT_EQ(gate.steps[0].to, ForceState::Armed);
    EXPECT_EQ(gate.steps[0].reason, why);
  }
}

// the tool taken from the hand: gone in 50 ms, never rising meanwhile, and then a new ramp
TEST(Safety, ClutchAndHoldToRunFadeWithinFiftyMilliseconds) {
  for (const ForceReason why : {ForceReason::Clutched, ForceReason::NotHeld}) {
    Gate gate = onAlready();
    double last = 4.0;
    for (int n = 1; n <= 50; ++n) {
      const Wrench sent = gate.pass(withheld(why));
      EXPECT_LE(sent.force.z(), last);
      EXPECT_LE(last - sent.force.z(), 4.0 / 50 + 1e-12);
      last = sent.force.z();
    }
    EXPECT_NEAR(last, 0.0, 1e-12);
    EXPECT_TRUE(isZero(gate.pass(withheld(why))));
    EXPECT_NEAR(gate.pass(kArmed).force.z(), 4e-3, 1e-9);
  }
}

TEST(Safety, ShortlyLetGoStillFadesOutBeforeItRampsIn) {
  Gate gate = onAlready();
  gate.ticks(10, withheld(ForceReason::NotHeld));
  double last = 4.0;
  int ticks = 0;
  for (; last > 0.0 && ticks < 100; ++ticks) {
    const Wrench sent = gate.pass(kArmed);
    EXPECT_EQ(gate.safety.state(), ForceState::Armed);
    EXPECT_LT(sent.force.z(), last);
    last = sent.force.z();
  }
  EXPECT_EQ(ticks, 40);
  EXPECT_NEAR(gate.pass(kArmed).force.z(), 4e-3, 1e-9);
  EXPECT_EQ(gate.safety.state(), ForceState::Ramping);
}

// whatever is wished for while it fades: a proxy that is set down far away, a hand that sinks in
TEST(Safety, WhatFadesNeitherGrowsNorTurns) {
  for (const ForceReason why : {ForceReason::Clutched, ForceReason::NotHeld, ForceReason::None})
    for (const bool slewing : {false, true}) {
      Gate gate = onAlready();
      if (slewing) gate.safety.settingMoved(false);
      double last = 4.0;
      for (int n = 0; n < 60; ++n) {
        const bool outside = why != ForceReason::None || n >= 6;
        const Wrench sent =
            gate.pass({{-500, 20, 30}, {0, 9, 9}}, outside, n < 30 ? withheld(why) : kArmed);
        if (gate.safety.state() != ForceState::Armed) break;
        EXPECT_LE(sent.force.norm(), last + 1e-12);
        EXPECT_EQ(sent.force.x(), 0.0);
        last = sent.force.norm();
      }
    }
}

TEST(Safety, AFaultIsZeroAndLatchedUntilTheUserHasLetGoAndArmsAgain) {
  for (const ForceReason why : {ForceReason::Lost, ForceReason::Jump, ForceReason::Stalled})
    for (const Circumstances& before : {kArmed, kReady, withheld(ForceReason::Gap)}) {
      Gate gate;
      gate.ticks(1100, before);
      EXPECT_TRUE(isZero(gate.pass(fault(why))));
      EXPECT_EQ(gate.safety.state(), ForceState::Fault);
      EXPECT_EQ(gate.safety.reason(), why);
      // whatever the device says now: the user has not seen it yet
      for (int n = 0; n < 2000; ++n) ASSERT_TRUE(isZero(gate.pass(kArmed)));
      EXPECT_EQ(gate.safety.state(), ForceState::Fault);
      for (int n = 0; n < 10; ++n) ASSERT_TRUE(isZero(gate.pass(kReady)));
      EXPECT_EQ(gate.safety.state(), ForceState::Fault);
      EXPECT_NEAR(gate.pass(kArmed).force.z(), 4e-3, 1e-9);
      EXPECT_EQ(gate.safety.state(), ForceState::Ramping);
      // and one that is still there latches again
      EXPECT_TRUE(isZero(gate.pass(fault(why))));
      EXPECT_EQ(gate.safety.state(), ForceState::Fault);
    }
}

TEST(Safety, KeepsNormsWithinTheRatingsAndTheirDirection) {
  Gate gate = onAlready();
  const Wrench sent = gate.pass({{300, 400, 0}, {0, 3, 4}});
  EXPECT_NEAR(sent.force.norm(), 10.0, 1e-12);
  EXPECT_NEAR(sent.torque.norm(), 0.2, 1e-12);
  EXPECT_NEAR(sent.force.normalized().dot(Vec3(0.6, 0.8, 0)), 1.0, 1e-12);
}

TEST(Safety, NeverRisesFasterThanItsRiseTime) {
  ForceLimits limits = kLimits;
  limits.rise_time = 0.01;  // 1 N a tick
  limits.ramp_time = 0.0;
  Gate gate{limits};
  Wrench last;
  for (int n = 0; n < 400; ++n) {
    const double side = n % 40 < 20 ? 1.0 : -1.0;
    const Wrench sent = gate.pass({{side * 9, 0, 0}, {0, side * 0.15, 0}});
    EXPECT_LE((sent.force - last.force).norm(), 1.0 + 1e-12) << n;
    EXPECT_LE((sent.torque - last.torque).norm(), 0.02 + 1e-12) << n;
    last = sent;
  }
  EXPECT_EQ(last.force.x(), -9.0);
  // zero is not held back
  EXPECT_TRUE(isZero(gate.pass(kReady)));
}

// 10 N on motors that stand 4: full for a while, then the limit goes down to 4 and stays there
TEST(Safety, SparesMotorsThatGetWarm) {
  ForceLimits limits{.force = 10.0, .continuous_force = 4.0};
  Gate gate{limits};
  const Wrench hard{{0, 0, 50}, Vec3::Zero()};
  double sum = 0.0;
  int full = 0;
  Wrench sent;
  const int minute = 60'000;
  for (int n = 0; n < 10 * minute; ++n) {
    sent = gate.pass(hard);
    full += sent.force.z() > 9.999;
    if (n >= 9 * minute) sum += sent.force.squaredNorm();
  }
  // heat rises as 6.25 (1 - exp(-t / 20 s)), and reaches 0.8 after 2.7 s
  EXPECT_NEAR(full * kSafetyPeriod, 20.0 * -std::log(1.0 - 0.8 / 6.25), 0.01);
  EXPECT_NEAR(std::sqrt(sum / minute), 4.0, 0.05);
  // at rest they cool down again
  for (int n = 0; n < 3 * minute; ++n) gate.pass(kReady);
  EXPECT_NEAR(gate.pass(hard).force.z(), 10.0, 1e-9);
}

TEST(Safety, SlewsAfterTheIsovalueMovedUntilTheForceHasCaughtUp) {
  Gate gate = onAlready();
  gate.safety.settingMoved(false);
  const Wrench other{{0, 9, 0}, {0, 0, -0.19}};
  Wrench last = kPress;
  int ticks = 0;
  for (; (last.force - other.force).norm() > 0.0 && ticks < 200; ++ticks) {
    const Wrench sent = gate.pass(other);
    EXPECT_LE((sent.force - last.force).norm(), 10.0 / 20 + 1e-12);  // rating over 20 ms
    EXPECT_LE((sent.torque - last.torque).norm(), 0.2 / 20 + 1e-12);
    last = sent;
  }
  // |(0, 9, -4)| = 9.85 N at 0.5 N a tick; the torque, 0.215 N·m at 0.01, takes longer
  EXPECT_EQ(ticks, 20);
  for (int n = 0; n < 10; ++n) last = gate.pass(other);
  EXPECT_EQ(last.torque, other.torque);
  // caught up: what the hand does is not held back
  EXPECT_EQ(gate.pass(kPress).force, kPress.force);
}

TEST(Safety, FadesOutWhileTheProxyIsInsideAndRampsInAgain) {
  Gate gate = onAlready();
  gate.safety.settingMoved(false);
  Wrench last = kPress;
  for (int n = 0; n < 60; ++n) {
    const Wrench sent = gate.pass(kPress, false);
    EXPECT_EQ(gate.safety.state(), ForceState::Armed);
    EXPECT_EQ(gate.safety.reason(), ForceReason::Inside);
    EXPECT_LE((sent.force - last.force).norm(), 10.0 / 20 + 1e-12);
    last = sent;
  }
  EXPECT_TRUE(last.force.isZero());
  // the proxy is outside, elsewhere: the force comes back over the ramp
  const Wrench elsewhere{{8, 0, 0}, Vec3::Zero()};
  last = gate.pass(elsewhere);
  EXPECT_EQ(gate.safety.state(), ForceState::Ramping);
  for (int n = 0; n < 1200; ++n) {
    const Wrench sent = gate.pass(elsewhere);
    EXPECT_LE((sent.force - last.force).norm(), 8.0 * 1e-3 + 1e-9);
    last = sent;
  }
  EXPECT_EQ(last.force, elsewhere.force);
}

// a tick that the budget cut leaves the proxy where it was; it follows a few ticks later
TEST(Safety, StaysUnderTheSlewLimitWhenTheProxyFollowsOnlyTicksLater) {
  Gate gate = onAlready();
  gate.safety.settingMoved(false);
  Wrench last = kPress;
  for (int n = 0; n < 60; ++n) {
    const Wrench wanted = n < 8 ? kPress : Wrench{{0, 0, 0.1}, Vec3::Zero()};
    const Wrench sent = gate.pass(wanted);
    EXPECT_LE((sent.force - last.force).norm(), 10.0 / 20 + 1e-12) << "tick " << n;
    last = sent;
  }
  EXPECT_EQ(last.force.z(), 0.1);
}

// the proxy is found outside, far from where it was, before the force has faded
TEST(Safety, StaysUnderTheSlewLimitWhenTheProxyIsSetOutsideWhileItStillFades) {
  Gate gate = onAlready();
  gate.safety.settingMoved(false);
  Wrench last = kPress;
  for (int n = 0; n < 200; ++n) {
    const bool outside = n >= 5;
    const Wrench wanted = outside ? Wrench{{-300, 0, 0}, {0, 0, 5}} : kPress;
    const Wrench sent = gate.pass(wanted, outside);
    EXPECT_LE((sent.force - last.force).norm(), 10.0 / 20 + 1e-12) << "tick " << n;
    EXPECT_LE((sent.torque - last.torque).norm(), 0.2 / 20 + 1e-12) << "tick " << n;
    last = sent;
  }
}

TEST(Safety, ANewSceneRampsFromZeroUnlessTheForceIsOff) {
  Gate gate = onAlready();
  EXPECT_NEAR(gate.pass({.armed = true, .ready = true, .adopted = true}).force.z(), 4e-3, 1e-9);
  EXPECT_TRUE(isZero(gate.pass({.ready = true, .adopted = true})));
  EXPECT_EQ(gate.safety.state(), ForceState::Ready);
}

TEST(Safety, AnythingNotFiniteIsZeroAndThenANewRamp) {
  for (const bool slewing : {false, true}) {
    Gate gate = onAlready();
    if (slewing) gate.safety.settingMoved(false);
    for (int n = 0; n < 5; ++n) EXPECT_TRUE(isZero(gate.pass({{NAN, 0, 0}, Vec3::Zero()})));
    EXPECT_EQ(gate.safety.reason(), ForceReason::NotFinite);
    for (int n = 1; n <= 1001; ++n)
      EXPECT_NEAR(gate.pass(kPress).force.z(), 4.0 * std::min(1.0, n * 1e-3), 1e-9);
  }
  Gate off;
  EXPECT_TRUE(isZero(off.pass({{NAN, 0, 0}, Vec3::Zero()}, true, kReady)));
  EXPECT_EQ(off.safety.state(), ForceState::Ready);
}

TEST(Safety, WithoutLimitsPassesTheWrenchAsItIs) {
  Gate gate{{}};
  gate.safety.settingMoved(false);
  const Wrench large{{1e4, 0, 0}, {0, 1e3, 0}};
  EXPECT_EQ(gate.pass(large).force, large.force);
}

// a spring on a wall, sampled, on a mass with little damping: past its limit it shakes
struct Shaken {
  double stiffness, scale = 1.0;
  bool guarded = true;
  double period = kSafetyPeriod;
  double exchange = period;  // s between two readings: a link of its own pace
  double share = 1.0, last_swing = 0.0, most_swing = 0.0;

  void run(double seconds) {
    Gate gate{{.force = 20.0, .guard_passivity = guarded}};
    const double mass = 0.15, damping = 4.0;  // kg, N·s/m: a light grip
    double x = 0.005, v = 0.0;                // m: the hand comes to the wall at 0.2 m/s, and in
    Wrench sent;
    double read = x, read_at = 0.0;
    const int ticks = static_cast<int>(seconds / period);
    for (int n = 0; n < ticks; ++n) {
      for (int k = 0; k < 20; ++k) {
        const double dt = period / 20;
        const double hand = std::max(-0.004, 0.005 - 0.2 * period * n);
        v += dt / mass * (sent.force.z() - damping * v - 500.0 * (x - hand));
        x += dt * v;
      }
      // at the hand; in the volume it is scale times as far
      if (n * period >= read_at - 1e-9) {
        read = x;
        read_at += exchange;
      }
      const double wanted = read < 0.0 ? -gate.safety.stiffnessShare() * stiffness * read : 0.0;
      gate.safety.begin(kArmed);
      gate.safety.moved(at(0, 0, scale * read), scale, period);
      sent = gate.safety.pass({{0, 0, wanted}, Vec3::Zero()}, true, period);
      most_swing = std::max(most_swing, std::abs(v));
      if (n > ticks - int(0.5 / period)) last_swing = std::max(last_swing, std::abs(v));
    }
    share = gate.safety.stiffnessShare();
  }
};

// the limit is 2 b / T. What a hard tap shakes is a matter of the stiffness, whatever the rate
TEST(Safety, GuardsEveryRateAlike) {
  for (const double period : {0.5e-3, 0.25e-3}) {
    const double limit = 8.0 / period;
    for (const double stiffness : {500.0, 2000.0, 5300.0}) {
      Shaken still{stiffness, 1.0, true, period};
      still.run(3.0);
      EXPECT_EQ(still.share, 1.0) << stiffness;
      EXPECT_LT(still.last_swing, 1e-3) << stiffness;
    }
    for (const double share : {1.5, 2.0}) {
      Shaken shaking{share * limit, 1.0, true, period};
      shaking.run(3.0);
      EXPECT_LT(shaking.share * share, 1.0) << share;
      EXPECT_GT(shaking.share * share, 0.25) << share;
      EXPECT_LT(shaking.last_swing, 1e-3) << share;
      Shaken unguarded{share * limit, 1.0, false, period};
      unguarded.run(3.0);
      EXPECT_GT(unguarded.last_swing, 0.02) << share;
    }
  }
}

TEST(Safety, LowersTheStiffnessOfALoopThatShakesAndNotOfOneThatDoesNot) {
  // the sampled spring's limit is 2 b / T = 8,000 N/m
  for (const double stiffness : {500.0, 2000.0, 4000.0, 5300.0}) {
    Shaken still{stiffness};
    still.run(3.0);
    EXPECT_EQ(still.share, 1.0) << stiffness;
    EXPECT_LT(still.last_swing, 1e-3) << stiffness;
  }
  // a link that brings eight readings in ten ticks
  Shaken tapped{1000.0};
  tapped.exchange = 1.25e-3;
  tapped.run(3.0);
  EXPECT_EQ(tapped.share, 1.0);
  for (const double stiffness : {12'000.0, 16'000.0, 30'000.0})
    for (const double scale : {0.2, 1.0, 5.0}) {
      Shaken shaking{stiffness, scale};
      shaking.run(3.0);
      EXPECT_LT(shaking.share * stiffness, 8'000.0) << stiffness;
      EXPECT_GT(shaking.share * stiffness, 2'000.0) << stiffness;  // and no more than it must
      EXPECT_LT(shaking.last_swing, 1e-3) << stiffness;            // m/s: it has come to rest
      Shaken unguarded{stiffness, scale, false};
      unguarded.run(3.0);
      EXPECT_GT(unguarded.last_swing, 0.1) << stiffness;
    }
}

}  // namespace
