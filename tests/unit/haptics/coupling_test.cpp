// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "app/study/made/made.h"
#include "haptics/coupling/safety.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/solver/unconstrained_motion.h"

namespace {

using haptics::ForceLimits;
using haptics::ForceState;
using haptics::Mat3;
using haptics::Pose;
using haptics::Quat;
using haptics::Safety;
using haptics::saturated;
using haptics::Vec3;
using haptics::VirtualCoupling;
using haptics::Wrench;
using made::at;
using made::Random;

constexpr double kPeriod = 1e-3;  // s
constexpr double kInf = std::numeric_limits<double>::infinity();

/// The wrench of a device at D with its proxy at P, the turn taken the short way.
Wrench pull(const VirtualCoupling& coupling, const Pose& P, const Pose& D, const Mat3& inertia) {
  return coupling.pull(P, D, -haptics::unwrappedTurn(P, D, Vec3::Zero()), inertia);
}

TEST(VirtualCoupling, PullsTheHandTowardsTheProxyOnAllSixAxes) {
  const Mat3 inertia = Vec3{1e-4, 2e-4, 3e-4}.asDiagonal();
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 unit = sign * Vec3::Unit(axis);
      const Wrench pushed = pull({500.0, 0.0}, at(2e-3 * unit), Pose::Identity(), inertia);
      EXPECT_TRUE(pushed.force.isApprox(1.0 * unit, 1e-12));  // 500 N/m · 2 mm
      EXPECT_TRUE(pushed.torque.isZero());
      const Pose turned = at(Vec3::Zero(), Quat{Eigen::AngleAxisd{0.1, unit}});
      const Wrench scalar = pull({500.0, 0.0}, turned, Pose::Identity(), inertia);
      EXPECT_TRUE(scalar.torque.isApprox(500.0 * inertia(axis, axis) * 0.1 * unit, 1e-12));
      EXPECT_TRUE(scalar.force.isZero());
      const Wrench own = pull({500.0, 2.0}, turned, Pose::Identity(), inertia);
      EXPECT_TRUE(own.torque.isApprox(0.2 * unit, 1e-12));  // 2 N·m/rad · 0.1 rad
    }
}

TEST(VirtualCoupling, IsExactlyNothingWhereProxyAndDeviceCoincide) {
  const Wrench none = pull({1e4, 10.0}, Pose::Identity(), Pose::Identity(), Mat3::Identity());
  EXPECT_TRUE((none.force.array() == 0.0).all());
  EXPECT_TRUE((none.torque.array() == 0.0).all());
}

TEST(VirtualCoupling, TorqueStopsGrowingAt150DegreesAndNeverFlips) {
  const Vec3 axis = Vec3{1, 2, -1}.normalized();
  double last = 0.0;
  for (int degree = 0; degree <= 700; ++degree) {
    const double angle = degree * M_PI / 180.0;
    const Wrench wrench =
        VirtualCoupling{500.0, 1.0}.pull(Pose::Identity(), Pose::Identity(), angle * axis, {});
    const double along = wrench.torque.dot(axis);
    EXPECT_NEAR(along, std::min(angle, 150.0 * M_PI / 180.0), 1e-12);
    EXPECT_NEAR((wrench.torque - along * axis).norm(), 0.0, 1e-12);
    EXPECT_GE(along, last - 1e-12);
    last = along;
  }
}

TEST(Saturated, ShortensForceAndTorqueEachToItsLimitAndKeepsTheDirection) {
  Random random{51};
  for (int n = 0; n < 500; ++n) {
    const Wrench wrench{random.box(10.0), random.box(1.0)};
    const Wrench out = saturated(wrench, 5.0, 0.3);
    EXPECT_LE(out.force.norm(), 5.0 * (1 + 1e-15));
    EXPECT_LE(out.torque.norm(), 0.3 * (1 + 1e-15));
    EXPECT_NEAR(out.force.normalized().dot(wrench.force.normalized()), 1.0, 1e-12);
    if (wrench.force.norm() <= 5.0) {
      EXPECT_EQ(out.force, wrench.force);
    }
    if (wrench.torque.norm() <= 0.3) {
      EXPECT_EQ(out.torque, wrench.torque);
    }
  }
  // no torque motors: no torque, and the force as it was
  const Wrench out = saturated({{1, 2, 2}, {0, 0, 1}}, 5.0, 0.0);
  EXPECT_EQ(out.force, Vec3(1, 2, 2));
  EXPECT_TRUE(out.torque.isZero());
}

TEST(Saturated, AnythingNotFiniteIsZero) {
  for (const double bad : {double(NAN), kInf, -kInf})
    for (int place = 0; place < 6; ++place) {
      Wrench wrench{{1, 1, 1}, {1, 1, 1}};
      (place < 3 ? wrench.force : wrench.torque)[place % 3] = bad;
      const Wrench out = saturated(wrench, 5.0, 5.0);
      EXPECT_TRUE(out.force.isZero());
      EXPECT_TRUE(out.torque.isZero());
    }
  EXPECT_TRUE(saturated({Vec3::Constant(1e300), Vec3::Zero()}, 5.0, 5.0).force.allFinite());
}

constexpr ForceLimits kLimits{.force = 10.0, .torque = 0.2, .ramp_time = 1.0, .slew_time = 0.02};
const Wrench kPress{{0, 0, 4}, {0.1, 0, 0}};

Safety onAlready(const ForceLimits& limits) {
  Safety safety{limits};
  safety.arm();
  for (int n = 0; n < 1100; ++n) safety.pass(kPress, true, kPeriod);
  EXPECT_EQ(safety.state(), ForceState::On);
  return safety;
}

TEST(Safety, IsOffUntilArmedAndRampsUpOverItsTime) {
  Safety safety{kLimits};
  EXPECT_TRUE(safety.pass(kPress, true, kPeriod).force.isZero());
  EXPECT_EQ(safety.state(), ForceState::Off);
  safety.arm();
  double last = 0.0;
  for (int n = 1; n <= 1000; ++n) {
    const Wrench sent = safety.pass(kPress, true, kPeriod);
    EXPECT_NEAR(sent.force.z(), 4.0 * n * 1e-3, 1e-9);
    EXPECT_NEAR(sent.torque.x(), 0.1 * n * 1e-3, 1e-9);
    EXPECT_GE(sent.force.z(), last);
    last = sent.force.z();
  }
  safety.pass(kPress, true, kPeriod);
  EXPECT_EQ(safety.state(), ForceState::On);
  EXPECT_EQ(safety.pass(kPress, true, kPeriod).force, kPress.force);
}

TEST(Safety, ArmingTwiceDoesNotStartTheRampAgain) {
  Safety safety{kLimits};
  safety.arm();
  for (int n = 0; n < 500; ++n) {
    safety.arm();
    safety.pass(kPress, true, kPeriod);
  }
  EXPECT_NEAR(safety.pass(kPress, true, kPeriod).force.z(), 4.0 * 0.501, 1e-9);
}

TEST(Safety, ForceOffIsZeroInTheVeryNextTickFromEveryState) {
  for (const int ticks : {1, 300, 1100})
    for (const bool outside : {true, false}) {
      Safety safety{kLimits};
      safety.arm();
      for (int n = 0; n < ticks; ++n) safety.pass(kPress, true, kPeriod);
      safety.settingMoved();
      safety.pass(kPress, outside, kPeriod);
      safety.forceOff();
      for (int n = 0; n < 5; ++n) {
        const Wrench sent = safety.pass(kPress, outside, kPeriod);
        EXPECT_TRUE((sent.force.array() == 0.0).all());
        EXPECT_TRUE((sent.torque.array() == 0.0).all());
      }
      safety.arm();
      EXPECT_LE(safety.pass(kPress, true, kPeriod).force.norm(), 4.0 * 1e-3 + 1e-12);
    }
}

TEST(Safety, KeepsNormsWithinTheRatings) {
  Safety safety = onAlready(kLimits);
  const Wrench sent = safety.pass({{300, 400, 0}, {0, 3, 4}}, true, kPeriod);
  EXPECT_NEAR(sent.force.norm(), 10.0, 1e-12);
  EXPECT_NEAR(sent.torque.norm(), 0.2, 1e-12);
}

TEST(Safety, SlewsAfterTheIsovalueMovedUntilTheForceHasCaughtUp) {
  Safety safety = onAlready(kLimits);
  safety.settingMoved();
  const Wrench other{{0, 9, 0}, {0, 0, -0.19}};
  Wrench last = kPress;
  int ticks = 0;
  for (; (last.force - other.force).norm() > 0.0 && ticks < 200; ++ticks) {
    const Wrench sent = safety.pass(other, true, kPeriod);
    EXPECT_LE((sent.force - last.force).norm(), 10.0 / 20 + 1e-12);  // rating over 20 ms
    EXPECT_LE((sent.torque - last.torque).norm(), 0.2 / 20 + 1e-12);
    last = sent;
  }
  // |(0, 9, -4)| = 9.85 N at 0.5 N a tick; the torque, 0.215 N·m at 0.01, takes longer
  EXPECT_EQ(ticks, 20);
  for (int n = 0; n < 10; ++n) last = safety.pass(other, true, kPeriod);
  EXPECT_EQ(last.torque, other.torque);
  // caught up: what the hand does is not held back
  EXPECT_EQ(safety.pass(kPress, true, kPeriod).force, kPress.force);
}

TEST(Safety, FadesOutWhileTheProxyIsInsideAndRampsInAgain) {
  Safety safety = onAlready(kLimits);
  safety.settingMoved();
  Wrench last = kPress;
  for (int n = 0; n < 60; ++n) {
    const Wrench sent = safety.pass(kPress, false, kPeriod);
    EXPECT_EQ(safety.state(), ForceState::Recovering);
    EXPECT_LE((sent.force - last.force).norm(), 10.0 / 20 + 1e-12);
    last = sent;
  }
  EXPECT_TRUE(last.force.isZero());
  // the proxy is outside, elsewhere: the force comes back over the ramp
  const Wrench elsewhere{{8, 0, 0}, Vec3::Zero()};
  safety.pass(elsewhere, true, kPeriod);
  EXPECT_EQ(safety.state(), ForceState::Ramping);
  for (int n = 0; n < 1200; ++n) {
    const Wrench sent = safety.pass(elsewhere, true, kPeriod);
    EXPECT_LE((sent.force - last.force).norm(), 8.0 * 1e-3 + 1e-9);
    last = sent;
  }
  EXPECT_EQ(last.force, elsewhere.force);
}

// a tick that the budget cut leaves the proxy where it was; it follows a few ticks later
TEST(Safety, StaysUnderTheSlewLimitWhenTheProxyFollowsOnlyTicksLater) {
  Safety safety = onAlready(kLimits);
  safety.settingMoved();
  Wrench last = kPress;
  for (int n = 0; n < 60; ++n) {
    const Wrench wanted = n < 8 ? kPress : Wrench{{0, 0, 0.1}, Vec3::Zero()};
    const Wrench sent = safety.pass(wanted, true, kPeriod);
    EXPECT_LE((sent.force - last.force).norm(), 10.0 / 20 + 1e-12) << "tick " << n;
    last = sent;
  }
  EXPECT_EQ(last.force.z(), 0.1);
}

// the proxy is found outside, far from where it was, before the force has faded
TEST(Safety, StaysUnderTheSlewLimitWhenTheProxyIsSetOutsideWhileItStillFades) {
  Safety safety = onAlready(kLimits);
  safety.settingMoved();
  Wrench last = kPress;
  for (int n = 0; n < 200; ++n) {
    const bool outside = n >= 5;
    const Wrench wanted = outside ? Wrench{{-300, 0, 0}, {0, 0, 5}} : kPress;
    const Wrench sent = safety.pass(wanted, outside, kPeriod);
    EXPECT_LE((sent.force - last.force).norm(), 10.0 / 20 + 1e-12) << "tick " << n;
    EXPECT_LE((sent.torque - last.torque).norm(), 0.2 / 20 + 1e-12) << "tick " << n;
    last = sent;
  }
}

TEST(Safety, ANewSceneRampsFromZeroUnlessTheForceIsOff) {
  Safety safety = onAlready(kLimits);
  safety.restart();
  EXPECT_NEAR(safety.pass(kPress, true, kPeriod).force.z(), 4e-3, 1e-9);
  safety.forceOff();
  safety.restart();
  EXPECT_EQ(safety.state(), ForceState::Off);
  EXPECT_TRUE(safety.pass(kPress, true, kPeriod).force.isZero());
}

TEST(Safety, AnythingNotFiniteIsZeroAndThenANewRamp) {
  for (const bool slewing : {false, true}) {
    Safety safety = onAlready(kLimits);
    if (slewing) safety.settingMoved();
    const Wrench bad{{NAN, 0, 0}, Vec3::Zero()};
    for (int n = 0; n < 5; ++n) {
      const Wrench sent = safety.pass(bad, true, kPeriod);
      EXPECT_TRUE((sent.force.array() == 0.0).all());
      EXPECT_TRUE((sent.torque.array() == 0.0).all());
    }
    for (int n = 1; n <= 1001; ++n)
      EXPECT_NEAR(safety.pass(kPress, true, kPeriod).force.z(), 4.0 * std::min(1.0, n * 1e-3),
                  1e-9);
  }
  Safety off{kLimits};
  EXPECT_TRUE(off.pass({{NAN, 0, 0}, Vec3::Zero()}, true, kPeriod).force.isZero(0.0));
  EXPECT_EQ(off.state(), ForceState::Off);
}

TEST(Safety, WithoutLimitsPassesTheWrenchAsItIs) {
  Safety safety{{}};
  safety.arm();
  safety.settingMoved();
  const Wrench large{{1e4, 0, 0}, {0, 1e3, 0}};
  EXPECT_EQ(safety.pass(large, true, kPeriod).force, large.force);
}

}  // namespace
