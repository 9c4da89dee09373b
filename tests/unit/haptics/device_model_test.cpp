// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/device_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "haptics/simulation/allowed_stiffness.h"
#include "haptics/tool/point_shell.h"

namespace {

using haptics::DeviceModel;
using haptics::Grip;
using haptics::Linkage;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;
using haptics::Wrench;

constexpr double kStep = 1e-3;  // s

Pose at(const Vec3& p, const Quat& q = Quat::Identity()) { return haptics::poseOf(p, q); }

TEST(DeviceModel, AFreeMassComesToRestAsItsDampingSays) {
  Grip grip;
  grip.stiffness = 0.0;
  grip.velocity = {{0.1, 0.0, 0.0}, {0.0, 2.0, 0.0}};
  for (int n = 0; n < 30; ++n) grip.advance(Pose::Identity(), {}, kStep);
  // v = v0 exp(-b t / m), x = v0 m / b (1 - exp(-b t / m)); the same in rotation
  const double left = std::exp(-grip.damping * 0.03 / grip.mass);
  const double gone = grip.mass / grip.damping * (1.0 - left);
  // the damper is implicit, to first order: (b dt / m)^2 / 2 of what there is, each of 300 steps
  EXPECT_NEAR(grip.velocity.linear.x(), 0.1 * left, 0.012 * 0.1 * left);
  EXPECT_NEAR(grip.velocity.angular.y(), 2.0 * left, 0.012 * 2.0 * left);
  EXPECT_NEAR(grip.X_WD.translation().x(), 0.1 * gone, 0.005 * 0.1 * gone);
  EXPECT_NEAR(Eigen::AngleAxisd{grip.X_WD.linear()}.angle(), 2.0 * gone, 0.005 * 2.0 * gone);
}

TEST(DeviceModel, AHeldForceMovesAFreeMassByHalfAccelerationTimesTimeSquared) {
  Grip grip;
  grip.stiffness = grip.damping = 0.0;
  grip.advance(Pose::Identity(), {{1.0, 0.0, 0.0}, Vec3::Zero()}, kStep);
  // to rounding: a first-order step would be off by a tenth
  EXPECT_NEAR(grip.X_WD.translation().x(), 0.5 / grip.mass * kStep * kStep, 1e-18);
}

TEST(DeviceModel, DryFrictionStopsAMassAfterItsMomentumOverTheForceAndHoldsItThere) {
  Grip grip;
  grip.stiffness = grip.damping = 0.0;
  grip.coulomb = 0.5;
  grip.velocity.linear = {0.06, 0.0, 0.08};             // 0.1 m/s
  const double stops = grip.mass * 0.1 / grip.coulomb;  // s: 20 ms
  int ticks = 0;
  while (!grip.velocity.linear.isZero(0.0) && ticks < 100) {
    grip.advance(Pose::Identity(), {}, kStep);
    ++ticks;
  }
  EXPECT_NEAR(ticks * kStep, stops, kStep);
  EXPECT_NEAR(grip.X_WD.translation().norm(), 0.5 * 0.1 * stops, 1e-5);  // m
  // a force below it moves nothing, one above does
  const Vec3 rest = grip.X_WD.translation();
  grip.advance(Pose::Identity(), {{0.49, 0.0, 0.0}, Vec3::Zero()}, kStep);
  EXPECT_EQ(grip.X_WD.translation(), rest);
  grip.advance(Pose::Identity(), {{0.51, 0.0, 0.0}, Vec3::Zero()}, kStep);
  EXPECT_NE(grip.X_WD.translation(), rest);
  grip.velocity.angular = {0.0, 1.0, 0.0};
  for (int n = 0; n < 100; ++n) grip.advance(Pose::Identity(), {}, kStep);
  EXPECT_TRUE(grip.velocity.angular.isZero(0.0));
}

TEST(Linkage, ReadsPositionsAndAnglesInWholeSteps) {
  Linkage linkage;
  linkage.encoder = 55e-6;
  linkage.angle_encoder = 0.5e-3;
  int steps = 0;
  Vec3 last = Vec3::Zero();
  for (int n = 0; n <= 1000; ++n) {
    const Vec3 p{1e-6 * n, -2e-6 * n, 0.0};
    const Pose X = linkage.read(at(p, Quat{Eigen::AngleAxisd{3e-5 * n, Vec3::UnitZ()}}));
    EXPECT_LE((X.translation() - p).cwiseAbs().maxCoeff(), 0.5 * 55e-6 + 1e-12);
    const Vec3 count = X.translation() / 55e-6;
    EXPECT_LT((count - count.array().round().matrix()).norm(), 1e-9);
    const double turn = Eigen::AngleAxisd{X.linear()}.angle() / 0.5e-3;
    EXPECT_NEAR(turn, std::round(turn), 1e-4);
    EXPECT_NEAR(turn, 3e-5 * n / 0.5e-3, 0.5 + 1e-4);
    steps += X.translation() != last;
    last = X.translation();
  }
  EXPECT_GE(steps, 1000 / 55 + 2000 / 55 - 2);
  EXPECT_LE(steps, 1000 / 55 + 2000 / 55 + 3);
}

TEST(Linkage, CarriesAWrenchSoManyTicksLate) {
  for (int delay = 0; delay <= Linkage::kLongestDelay; ++delay) {
    Linkage linkage;
    linkage.delay = delay;
    for (int n = 1; n <= 20; ++n) {
      const Wrench arriving =
          linkage.carry({{double(n), 0, 0}, {0, double(n), 0}}, Pose::Identity());
      EXPECT_EQ(arriving.force.x(), std::max(0, n - delay)) << delay;
      EXPECT_EQ(arriving.torque.y(), std::max(0, n - delay)) << delay;
    }
  }
}

TEST(Linkage, OfTwoWrenchesInATickEachActsForItsShare) {
  Linkage linkage;
  linkage.delay = 1.25;
  for (int n = 1; n <= 20; ++n) {
    const Wrench arriving = linkage.carry({{double(n), 0, 0}, {0, double(n), 0}}, Pose::Identity());
    const double expected = 0.75 * std::max(0, n - 1) + 0.25 * std::max(0, n - 2);
    EXPECT_DOUBLE_EQ(arriving.force.x(), expected);
    EXPECT_DOUBLE_EQ(arriving.torque.y(), expected);
  }
}

TEST(Linkage, AnArmTurnsTheToolAboutTheHandleAndItsForceTurnsTheHandleIfThereAreMotors) {
  Linkage linkage;
  linkage.arm = {0.0, 0.0, -0.2};
  const Pose X_WH = at({0.1, 0.2, 0.3}, Quat{Eigen::AngleAxisd{M_PI / 2.0, Vec3::UnitX()}});
  const Pose X_WD = linkage.read(X_WH);
  EXPECT_LT((X_WD.translation() - Vec3{0.1, 0.4, 0.3}).norm(), 1e-12);
  EXPECT_LT((linkage.handleAt(X_WD).translation() - X_WH.translation()).norm(), 1e-12);
  const Wrench sent{{0.0, 0.0, 2.0}, {0.0, 0.0, 0.5}};
  const Wrench with = linkage.carry(sent, X_WH);
  EXPECT_LT((with.torque - Vec3{0.4, 0.0, 0.5}).norm(), 1e-12);  // 0.2 m times 2 N, and its own
  linkage.torque = false;
  const Wrench without = linkage.carry(sent, X_WH);
  EXPECT_EQ(without.torque, Vec3::Zero());
  EXPECT_EQ(without.force, sent.force);
}

TEST(DeviceModel, EveryRatedDeviceHasOneAndOneHasAnArm) {
  std::set<std::string> names;
  for (const DeviceModel& model : haptics::deviceModels()) {
    names.insert(model.name);
    EXPECT_GT(model.mass, 0.0);
    EXPECT_GT(model.rating.damping, 0.0);
    EXPECT_GT(model.linkage.encoder, 0.0);
    EXPECT_EQ(model.linkage.torque, model.rating.torque > 0.0);
  }
  for (const haptics::DeviceRating& rating : haptics::deviceRatings())
    EXPECT_EQ(names.contains(std::string{rating.id}), rating.actuated > 0) << rating.id;
  EXPECT_EQ(names.size(), haptics::deviceRatings().size());  // less the SpaceMouse, and the arm
  const auto arm = haptics::findDeviceModel("omni-arm-200");
  ASSERT_TRUE(arm);
  EXPECT_DOUBLE_EQ(arm->linkage.arm.norm(), 0.2);
  EXPECT_FALSE(arm->linkage.torque);
  EXPECT_FALSE(haptics::findDeviceModel("nothing"));
}

// 2 b / T is 10 kN/m at 1 kHz with the 5 N·s/m of any device and a hand
TEST(AllowedStiffness, IsTheRatingAndAtMostSomeOfTheSampledSpringsLimit) {
  const haptics::PointShell round;
  const haptics::DeviceRating falcon = *haptics::findRating("falcon"),
                              omega = *haptics::findRating("omega.6");
  const auto allowed = [&](const haptics::DeviceRating& rating, double period, int delay) {
    return haptics::allowedStiffness(rating, round, {period, period * delay});
  };
  EXPECT_DOUBLE_EQ(allowed(falcon, 1e-3, 0), 3000.0);
  EXPECT_DOUBLE_EQ(allowed(falcon, 1e-3, 1), 1500.0);
  EXPECT_DOUBLE_EQ(allowed(falcon, 1e-3, 4), 500.0);
  EXPECT_DOUBLE_EQ(allowed(omega, 1e-3, 0), 4500.0);
  EXPECT_DOUBLE_EQ(allowed(omega, 0.25e-3, 4), 2000.0);
  for (const haptics::DeviceRating& rating : haptics::deviceRatings())
    for (const double period : {1e-3, 0.25e-3})
      for (const int delay : {0, 1, 2, 4}) {
        EXPECT_LE(allowed(rating, period, delay), rating.stiffness);
        EXPECT_LE(allowed(rating, period, delay), 4.5 / (period * (1 + 2 * delay)) + 1e-9);
      }
}

TEST(AllowedStiffness, FallsWithALongToolWhereThereAreTorqueMotorsAndWithTheArmWhereThereAreNone) {
  const haptics::PointShell round;
  haptics::PointShell rod;
  rod.inertia = Vec3{1.0, 1.0, 0.1}.asDiagonal();  // 0.7 of the mean across it
  const haptics::DeviceRating lambda = *haptics::findRating("lambda.7"),
                              omega = *haptics::findRating("omega.6");
  EXPECT_DOUBLE_EQ(haptics::allowedStiffness(lambda, rod, {}), 0.7 * 4500.0);
  EXPECT_DOUBLE_EQ(haptics::allowedStiffness(omega, rod, {}), 4500.0);
  EXPECT_DOUBLE_EQ(haptics::allowedStiffness(lambda, round, {}, 0.2), 4500.0);
  const double short_arm = haptics::allowedStiffness(omega, round, {}, 0.1),
               long_arm = haptics::allowedStiffness(omega, round, {}, 0.2);
  EXPECT_LT(short_arm, 100.0);
  EXPECT_DOUBLE_EQ(long_arm, 0.25 * short_arm);
  // the grip of the simulated hands: 8 N·s/m, and never a force that comes late
  EXPECT_DOUBLE_EQ(haptics::allowedStiffness(Grip{}, round, 1e-3), 7200.0);
  EXPECT_DOUBLE_EQ(haptics::allowedStiffness(Grip{}, rod, 1e-3), 5040.0);
}

// a contact at the far end of the tool turns the handle, and no motor holds against it
TEST(AllowedStiffness, FallsWithTheReachOfATool) {
  const auto rod = [](double reach) {
    std::vector<Vec3> points;
    for (int n = -50; n <= 50; ++n) points.push_back({0.0, 0.0, reach * n / 50});
    return haptics::makeShell(points).value();
  };
  const auto allowed = [&](const char* id, double reach) {
    return haptics::allowedStiffness(*haptics::findRating(id), rod(reach), {});
  };
  // 0.9 N·m/rad are missing: K r² I / (I + r²), where a rod has I = r²/3
  const double inertia = 0.01 * 0.34;
  EXPECT_NEAR(allowed("omega.6", 0.1), 0.9 * (inertia + 0.01) / (inertia * 0.01), 1.0);
  EXPECT_NEAR(allowed("omega.6", 0.2), 0.25 * allowed("omega.6", 0.1), 0.5);
  EXPECT_DOUBLE_EQ(allowed("omega.6", 0.02), 4500.0);
  EXPECT_DOUBLE_EQ(allowed("omni", 0.05), 700.0);  // as rated
  // a handle that does not turn, and one whose motors hold against it
  EXPECT_DOUBLE_EQ(allowed("omega.3", 0.2), 4500.0);
  EXPECT_GT(allowed("lambda.7", 0.2), 2500.0);
}

}  // namespace
