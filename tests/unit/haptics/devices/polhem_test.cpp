// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/polhem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using haptics::kPolhemRest;
using haptics::Mat3;
using haptics::PolhemAngles;
using haptics::Pose;
using haptics::Vec3;
using Counts = haptics::BoardCounts;

constexpr Counts kPolhemWork{2000, -6000, 14000, 40, -60, 120};  // in the midst of the workspace

/// Angles all over what the arm may do, and more.
PolhemAngles anyAngles(std::mt19937& random) {
  std::uniform_real_distribution<double> turn{-2.2, 2.2}, upper{0.3, 2.4}, crank{1.5, 4.6};
  return {turn(random), upper(random), crank(random), turn(random), turn(random), turn(random)};
}

// The lengths of the header's drawing, once more: the linkage is checked by what its bars are.
TEST(PolhemArm, EveryBarHasItsLength) {
  std::mt19937 random{17};
  int arms = 0;
  const int trials = 20'000;
  for (int trial = 0; trial < trials; ++trial) {
    const PolhemAngles angles = anyAngles(random);
    const auto arm = haptics::polhemArm(angles);
    if (!arm) continue;
    ++arms;
    // back from B into the plane of the arm: r out, z up
    const Vec3 p = arm->X_BD.translation();
    const double forward = p.z() + 0.2045, right = p.x(), z = p.y() + 0.0325;
    const double r = forward * std::cos(angles[0]) + right * std::sin(angles[0]);
    ASSERT_NEAR(-forward * std::sin(angles[0]) + right * std::cos(angles[0]), 0.0, 1e-12);
    const Eigen::Vector2d E{0.017 + 0.165 * std::cos(angles[1]), 0.165 * std::sin(angles[1])};
    const Eigen::Vector2d K{-0.017 + 0.025 * std::cos(angles[2]), 0.025 * std::sin(angles[2])};
    const Eigen::Vector2d G{r, z};
    ASSERT_NEAR((G - E).norm(), 0.1308, 1e-12);
    const Eigen::Vector2d C = E - (G - E) * (0.034 / 0.1308);
    ASSERT_NEAR((C - K).norm(), 0.190, 1e-12);
    const Eigen::Vector2d EK = K - E, EC = C - E;
    ASSERT_LT(EK.x() * EC.y() - EK.y() * EC.x(), 0.0);  // clockwise
  }
  EXPECT_GT(arms, trials / 2);
  EXPECT_LT(arms, trials);
}

TEST(PolhemArm, IsWhereItsMakersSayItRests) {
  // by the law of cosines in three triangles, as a drawing has it, for the rest pose alone
  const PolhemAngles angles = haptics::polhemAngles(kPolhemRest);
  EXPECT_NEAR(angles[0], 2.1023, 1e-3);
  EXPECT_NEAR(angles[1], 2.1782, 1e-3);
  EXPECT_NEAR(angles[2], 4.1621, 1e-3);
  const auto arm = haptics::polhemArm(angles);
  ASSERT_TRUE(arm);
  const double r = 0.0357, up = 0.0695;
  const Vec3 expected{r * std::sin(2.1023), up - 0.0325, r * std::cos(2.1023) - 0.2045};
  EXPECT_LT((arm->X_BD.translation() - expected).norm(), 5e-4);
}

TEST(PolhemArm, ItsJacobianIsItsDerivative) {
  std::mt19937 random{23};
  double worst = 0.0;
  int arms = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const PolhemAngles angles = anyAngles(random);
    const auto arm = haptics::polhemArm(angles);
    // beside a dead point differences of any step are no derivative
    if (!arm || arm->J_B.norm() > 0.5) continue;
    ++arms;
    for (std::size_t i = 0; i < 3; ++i) {
      // Richardson's of two central differences
      const auto difference = [&](double h) -> std::optional<Vec3> {
        PolhemAngles more = angles, less = angles;
        more[i] += h;
        less[i] -= h;
        const auto there = haptics::polhemArm(more), back = haptics::polhemArm(less);
        if (!there || !back) return std::nullopt;
        return (there->X_BD.translation() - back->X_BD.translation()) / (2.0 * h);
      };
      const auto coarse = difference(2e-4), fine = difference(1e-4);
      if (!coarse || !fine) continue;
      const Vec3 slope = (4.0 * *fine - *coarse) / 3.0;
      worst = std::max(worst, (slope - arm->J_B.col(static_cast<Eigen::Index>(i))).norm());
    }
  }
  EXPECT_GT(arms, 8'000);
  EXPECT_LT(worst, 1e-9);
  RecordProperty("worst", std::to_string(worst * 1e12));
}

// Virtual work: what the motors do on their counts is what the force does on the handle.
TEST(PolhemArm, MotorsDoTheWorkOfTheForce) {
  std::mt19937 random{29};
  std::normal_distribution<double> normal;
  const std::array<double, 3> torque_constant{0.0603, 0.0538, 0.0538};
  double worst = 0.0;
  int arms = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    Counts counts{};
    for (std::size_t i = 0; i < 3; ++i)
      counts[i] = static_cast<std::int16_t>(kPolhemWork[i] +
                                            std::uniform_int_distribution{-3000, 3000}(random));
    const PolhemAngles angles = haptics::polhemAngles(counts);
    const auto arm = haptics::polhemArm(angles);
    if (!arm || arm->J_B.norm() > 3.0) continue;
    ++arms;
    const Vec3 force{normal(random), normal(random), normal(random)};
    const Vec3 currents = haptics::currentsFor(haptics::polhem(), force, arm->J_B);
    // a motor's turn by one count, as the angle that its body makes of it
    for (std::size_t i = 0; i < 3; ++i) {
      Counts next = counts;
      ++next[i];
      const double dq = haptics::polhemAngles(next)[i] - angles[i];
      const double motor_work = currents[static_cast<Eigen::Index>(i)] * torque_constant[i] *
                                (2.0 * std::numbers::pi / 4096.0);
      const double handle_work = force.dot(arm->J_B.col(static_cast<Eigen::Index>(i)) * dq);
      worst = std::max(worst, std::abs(motor_work - handle_work));
    }
  }
  EXPECT_GT(arms, 10'000);
  EXPECT_LT(worst, 1e-12);  // J, of some 1e-4
}

TEST(PolhemArm, TurnsRightLiftsAndReachesOut) {
  const PolhemAngles angles = haptics::polhemAngles(kPolhemWork);
  const auto arm = haptics::polhemArm(angles);
  ASSERT_TRUE(arm);
  PolhemAngles level = angles;
  level[0] = 0.0;
  const Mat3 J = haptics::polhemArm(level)->J_B;
  EXPECT_GT(J(0, 0), 0.1);           // a: to the right
  EXPECT_NEAR(J(1, 0), 0.0, 1e-12);  // and neither up
  EXPECT_NEAR(J(2, 0), 0.0, 1e-12);  // nor out
  EXPECT_NEAR(J(0, 1), 0.0, 1e-12);  // b and c: in the plane
  EXPECT_NEAR(J(0, 2), 0.0, 1e-12);
}

TEST(PolhemArm, ReachesItsWorkspace) {
  // by Newton's method from the midst of it to points in a ball of two thirds of its radius
  std::mt19937 random{31};
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  int reached = 0;
  const int points = 500;
  for (int point = 0; point < points; ++point) {
    const Vec3 direction = Vec3{normal(random), normal(random), normal(random)}.normalized();
    const Vec3 target = direction * (0.10 * std::cbrt(unit(random)));
    PolhemAngles angles = haptics::polhemAngles(kPolhemWork);
    for (int i = 0; i < 100; ++i) {
      const auto arm = haptics::polhemArm(angles);
      if (!arm) break;
      const Vec3 away = target - arm->X_BD.translation();
      if (away.norm() < 1e-9) {
        ++reached;
        break;
      }
      const Vec3 step = arm->J_B.partialPivLu().solve(away) * 0.5;
      for (std::size_t k = 0; k < 3; ++k) angles[k] += step[static_cast<Eigen::Index>(k)];
    }
  }
  EXPECT_GT(reached, points * 9 / 10);
  RecordProperty("reached", reached);
}

TEST(PolhemArm, TheGimbalTurnsTheHandle) {
  PolhemAngles angles = haptics::polhemAngles(kPolhemWork);
  angles[0] = angles[3] = angles[4] = angles[5] = 0.0;
  const Mat3 straight = haptics::polhemArm(angles)->X_BD.linear();
  // the stylus, D's z, lies along the forearm, in the plane of the arm
  EXPECT_NEAR(straight(0, 2), 0.0, 1e-12);
  EXPECT_NEAR((straight * straight.transpose() - Mat3::Identity()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(straight.determinant(), 1.0, 1e-12);
  for (const std::size_t axis : {3u, 4u, 5u}) {
    PolhemAngles turned = angles;
    turned[axis] = 0.3;
    const Mat3 R_DD = straight.transpose() * haptics::polhemArm(turned)->X_BD.linear();
    const Eigen::AngleAxisd turn{R_DD};
    EXPECT_NEAR(turn.angle(), 0.3, 1e-9);
    const Vec3 about = axis == 4 ? Vec3::UnitX() : Vec3::UnitZ();
    EXPECT_NEAR((turn.axis() - about).norm(), 0.0, 1e-9) << axis;
    EXPECT_EQ(haptics::polhemArm(turned)->X_BD.translation(),
              haptics::polhemArm(angles)->X_BD.translation());
  }
}

TEST(PolhemArm, AnyCountsAreAnArmOrNone) {
  std::mt19937 random{37};
  int none = 0;
  for (int trial = 0; trial < 100'000; ++trial) {
    Counts counts{};
    for (std::int16_t& count : counts) count = static_cast<std::int16_t>(random());
    const auto arm = haptics::polhemArm(haptics::polhemAngles(counts));
    none += !arm;
    if (!arm) continue;
    ASSERT_TRUE(arm->X_BD.matrix().allFinite());
    ASSERT_TRUE(arm->J_B.allFinite());
    ASSERT_LT(arm->J_B.norm(), 50.0);
  }
  EXPECT_GT(none, 0);
  EXPECT_FALSE(haptics::polhemArm({std::nan(""), 1.5, 3.0, 0, 0, 0})
                   .value_or(haptics::ArmState{Pose::Identity(), Mat3::Constant(std::nan(""))})
                   .J_B.allFinite());
}

}  // namespace
