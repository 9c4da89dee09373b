// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/falcon_kinematics.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace {

using haptics::Mat3;
using haptics::Vec3;
using haptics::falcon::LegAngles;
using haptics::falcon::legsAt;
using haptics::falcon::positionOf;
using haptics::falcon::torquesFor;
using haptics::falcon::velocityJacobian;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kPitch = 0.005;  // m, of the grid of places

/// Places all over the workspace that its maker names, four inches wide and as deep.
std::vector<Vec3> workspace() {
  std::vector<Vec3> places;
  for (double z = -0.045; z < 0.0451; z += kPitch)
    for (double x = -0.05; x < 0.0501; x += kPitch)
      for (double y = -0.05; y < 0.0501; y += kPitch)
        if (std::hypot(x, y) <= 0.0501 && legsAt({x, y, z})) places.push_back({x, y, z});
  return places;
}

/// By central differences of the fourth order.
Mat3 numericJacobian(const Vec3& p) {
  constexpr double h = 1e-5;
  const auto theta1 = [&](const Vec3& step) { return legsAt(p + step)->theta1; };
  Mat3 J;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step = h * Vec3::Unit(axis);
    J.col(axis) =
        (8.0 * (theta1(step) - theta1(-step)) - (theta1(2.0 * step) - theta1(-2.0 * step))) /
        (12.0 * h);
  }
  return J;
}

bool hasRoom(const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (!legsAt(p + 1e-4 * Vec3::Unit(axis)) || !legsAt(p - 1e-4 * Vec3::Unit(axis))) return false;
  return true;
}

TEST(FalconKinematics, ReachesNearlyAllOfTheWorkspace) {
  const auto places = workspace();
  std::size_t all = 0;
  for (double z = -0.045; z < 0.0451; z += kPitch)
    for (double x = -0.05; x < 0.0501; x += kPitch)
      for (double y = -0.05; y < 0.0501; y += kPitch) all += std::hypot(x, y) <= 0.0501;
  std::cout << places.size() << " of " << all << " places are reached\n";
  EXPECT_GT(double(places.size()), 0.97 * double(all));
  EXPECT_FALSE(legsAt({0.0, 0.0, 0.08}));
  EXPECT_FALSE(legsAt({0.2, 0.0, 0.0}));
  EXPECT_FALSE(legsAt({0.0, 0.0, -0.2}));
  EXPECT_FALSE(legsAt({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}));
}

// the chain of each leg, walked along its joints, ends at the grip
TEST(FalconKinematics, TheLegsOfTheInverseCloseAtTheGrip) {
  constexpr std::array<double, 3> kAzimuths{105.0, -15.0, -135.0};
  double worst = 0.0;
  for (const Vec3& p : workspace()) {
    const LegAngles legs = *legsAt(p);
    for (int i = 0; i < 3; ++i) {
      const double rods = 0.1025 * std::sin(legs.theta3[i]) + 0.0225;
      const double u =
          0.060 * std::cos(legs.theta1[i]) - 0.01443 + rods * std::cos(legs.theta2[i]) + 0.040;
      const double v = 0.1025 * std::cos(legs.theta3[i]) + 0.025 - 0.02309;
      const double w = 0.060 * std::sin(legs.theta1[i]) + rods * std::sin(legs.theta2[i]);
      const double azimuth = kAzimuths[std::size_t(i)] * kDegree;
      const Vec3 end{u * std::cos(azimuth) - v * std::sin(azimuth),
                     u * std::sin(azimuth) + v * std::cos(azimuth), w - 0.125};
      worst = std::max(worst, (end - p).norm());
    }
  }
  EXPECT_LT(worst, 1e-12);
}

TEST(FalconKinematics, TheGripComesForwardAndOutwardAsTheArmsRise) {
  // straight out: all arms alike, and the further the higher
  double last = -1e9;
  for (double z = -0.045; z < 0.0451; z += kPitch) {
    const Vec3 theta1 = legsAt({0.0, 0.0, z})->theta1;
    EXPECT_NEAR(theta1[0], theta1[1], 1e-12);
    EXPECT_NEAR(theta1[0], theta1[2], 1e-12);
    EXPECT_GT(theta1[0], last);
    last = theta1[0];
  }
}

TEST(FalconKinematics, ForwardIsTheInverseOfInverse) {
  double worst = 0.0;
  int lost = 0;
  const auto places = workspace();
  for (const Vec3& p : places) {
    const Vec3 theta1 = legsAt(p)->theta1;
    for (const Vec3& start : {Vec3{0.0, 0.0, 0.0}, Vec3{p + Vec3{0.01, -0.01, 0.01}},
                              Vec3{-0.03, 0.03, -0.04}, Vec3{1.0, 1.0, 1.0}}) {
      const auto back = positionOf(theta1, start);
      lost += !back;
      if (back) worst = std::max(worst, (*back - p).norm());
    }
  }
  std::cout << places.size() << " places, " << lost << " lost, worst " << worst << " m\n";
  EXPECT_EQ(lost, 0);
  EXPECT_LT(worst, 1e-9);
}

TEST(FalconKinematics, SaysWhichAnglesNoGripCanHave) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(positionOf({nan, 0.5, 0.5}, Vec3::Zero()));
  EXPECT_FALSE(positionOf({1e300, 0.5, 0.5}, Vec3::Zero()));
  EXPECT_FALSE(positionOf({3.0, -3.0, 0.0}, Vec3::Zero()));
  EXPECT_FALSE(positionOf({20.0, 20.0, 20.0}, Vec3::Zero()));
  EXPECT_FALSE(positionOf(Vec3::Constant(100.0 * kDegree), Vec3::Zero()));
  EXPECT_TRUE(positionOf(Vec3::Constant(35.0 * kDegree), {nan, nan, nan}));
  // any angles: an answer is a place whose legs stand so
  std::mt19937 random{7};
  std::uniform_real_distribution<double> angle{-4.0, 4.0};
  int found = 0;
  for (int n = 0; n < 20'000; ++n) {
    const Vec3 theta1{angle(random), angle(random), angle(random)};
    const auto p = positionOf(theta1, Vec3::Zero());
    if (!p) continue;
    ++found;
    EXPECT_LT((legsAt(*p)->theta1 - theta1).norm(), 1e-9);
    EXPECT_LT(p->norm(), 0.1);
  }
  EXPECT_GT(found, 100);
}

TEST(FalconKinematics, JacobianIsTheDerivativeOfTheInverse) {
  double worst = 0.0, least_of_other = 1e9;
  int compared = 0, told_apart = 0;
  for (const Vec3& p : workspace()) {
    if (!hasRoom(p)) continue;
    const LegAngles legs = *legsAt(p);
    const Mat3 J = velocityJacobian(legs), numeric = numericJacobian(p);
    // at the brink of the reach the derivative itself grows without bound
    if (numeric.norm() > 150.0) continue;
    ++compared;
    worst = std::max(worst, (J - numeric).norm() / numeric.norm());
    // with sin^2 theta2 in the z column
    Mat3 other = J;
    for (int i = 0; i < 3; ++i) other(i, 2) *= std::sin(legs.theta2[i]) / std::sin(legs.theta3[i]);
    const double wrong = (other - numeric).norm() / numeric.norm();
    least_of_other = std::min(least_of_other, wrong);
    told_apart += wrong > 1e-3;
  }
  std::cout << compared << " places, worst " << worst << "; with sin^2 at least " << least_of_other
            << '\n';
  EXPECT_GT(compared, 4000);
  EXPECT_LT(worst, 1e-6);
  EXPECT_GT(told_apart, compared * 95 / 100);
}

TEST(FalconKinematics, TorquesDoTheWorkOfTheForce) {
  std::mt19937 random{3};
  std::normal_distribution<double> normal;
  double worst = 0.0;
  int compared = 0;
  for (const Vec3& p : workspace()) {
    if (!hasRoom(p) || numericJacobian(p).norm() > 150.0) continue;
    const Vec3 force{normal(random), normal(random), normal(random)};
    const Vec3 dx = 3e-7 * Vec3{normal(random), normal(random), normal(random)};
    const Vec3 torques = torquesFor(*legsAt(p), force);
    const Vec3 turned = legsAt(p + 0.5 * dx)->theta1 - legsAt(p - 0.5 * dx)->theta1;
    worst =
        std::max(worst, std::abs(torques.dot(turned) - force.dot(dx)) / (force.norm() * dx.norm()));
    ++compared;
  }
  std::cout << compared << " places, worst " << worst << '\n';
  EXPECT_GT(compared, 4000);
  EXPECT_LT(worst, 1e-6);
}

TEST(FalconKinematics, TorquesAreLimitedAndKeepTheForcesDirection) {
  std::mt19937 random{5};
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> across{-0.08, 0.08}, along{-0.07, 0.07};
  int limited = 0, refused = 0;
  double worst = 0.0;
  for (int n = 0; n < 50'000; ++n) {
    const auto legs = legsAt({across(random), across(random), along(random)});
    if (!legs) continue;
    const Vec3 force = 20.0 * Vec3{normal(random), normal(random), normal(random)};
    const Vec3 torques = torquesFor(*legs, force);
    ASSERT_TRUE(torques.allFinite());
    ASSERT_LE(torques.norm(), haptics::falcon::kMostTorque * (1.0 + 1e-12));
    if (torques.isZero(0.0)) {
      ++refused;
      continue;
    }
    // what the hand feels: along the force, never more than it
    const Vec3 felt = velocityJacobian(*legs).transpose() * torques;
    worst = std::max(worst, (felt.normalized() - force.normalized()).norm());
    EXPECT_LE(felt.norm(), force.norm() * (1.0 + 1e-9));
    limited += felt.norm() < 0.999 * force.norm();
  }
  std::cout << limited << " limited, " << refused << " refused, worst direction " << worst << '\n';
  EXPECT_GT(limited, 1000);
  EXPECT_GT(refused, 10);
  EXPECT_LT(refused, 2500);
  EXPECT_LT(worst, 1e-9);
}

TEST(FalconKinematics, DoubtIsZero) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LegAngles legs = *legsAt(Vec3::Zero());
  EXPECT_FALSE(torquesFor(legs, {0.0, 0.0, 1.0}).isZero(0.0));
  EXPECT_TRUE(torquesFor(legs, {nan, 0.0, 1.0}).isZero(0.0));
  EXPECT_TRUE(torquesFor(legs, {0.0, std::numeric_limits<double>::infinity(), 1.0}).isZero(0.0));
  EXPECT_TRUE(torquesFor(legs, Vec3::Constant(1e308)).isZero(0.0));
  EXPECT_TRUE(torquesFor({}, {0.0, 0.0, 1.0}).isZero(0.0));
  EXPECT_TRUE(torquesFor({{nan, nan, nan}, {}, {}}, {0.0, 0.0, 1.0}).isZero(0.0));
  // arms and rods of one leg in line
  LegAngles stretched = legs;
  stretched.theta2[1] = stretched.theta1[1] + 1e-9;
  EXPECT_TRUE(torquesFor(stretched, {0.0, 0.0, 1.0}).isZero(0.0));
}

TEST(FalconKinematics, CountsAreAngles) {
  EXPECT_NEAR(haptics::falcon::angleOf(0), 35.0 * kDegree, 1e-15);
  EXPECT_NEAR(haptics::falcon::angleOf(1000), 71.4347 * kDegree, 1e-5);
  EXPECT_NEAR(haptics::falcon::angleOf(-1000), -1.4347 * kDegree, 1e-5);
}

}  // namespace
