// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/wooden_haptics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using haptics::kWoodenRest;
using haptics::Mat3;
using haptics::Vec3;
using haptics::woodenArm;
using Counts = haptics::BoardCounts;

constexpr double kBody[] = {1.0 / 16.0, 1.0 / 12.0, 1.0 / 12.0};  // turns of a body, of a motor

/// Counts of these angles of the bodies, deg.
Counts countsAt(double a, double b, double c) {
  const double angles[] = {a, b, c};
  Counts counts{};
  for (std::size_t i = 0; i < 3; ++i)
    counts[i] = static_cast<std::int16_t>(std::lround(angles[i] / 360.0 / kBody[i] * 2000.0));
  return counts;
}

Counts anyCounts(std::mt19937& random) {
  std::uniform_real_distribution<double> turn{-90, 90}, upper{-60, 120}, fore{-30, 150};
  return countsAt(turn(random), upper(random), fore(random));
}

Vec3 placeAt(const Counts& counts) { return woodenArm(counts)->X_BD.translation(); }

TEST(WoodenArm, RestsWithItsUpperArmUprightAndItsForearmLevel) {
  EXPECT_EQ(kWoodenRest, countsAt(0, 0, 90));
  const auto rest = woodenArm(kWoodenRest);
  ASSERT_TRUE(rest);
  // 245 mm out of the axis and 285 up, the middle of the workspace at 220 and 80
  EXPECT_LT((rest->X_BD.translation() - Vec3{0.0, 0.205, 0.025}).norm(), 1e-12);
  EXPECT_EQ(rest->X_BD.linear(), Mat3::Identity());
}

TEST(WoodenArm, StandsWhereADrawingPutsIt) {
  // the upper arm level, the forearm hanging: a right angle at the elbow
  EXPECT_LT((placeAt(countsAt(0, 90, 0)) - Vec3{0.0, -0.245, 0.205 - 0.22}).norm(), 1e-12);
  // both stretched to the user, and turned to the right
  EXPECT_LT((placeAt(countsAt(0, 90, 90)) - Vec3{0.0, 0.0, 0.45 - 0.22}).norm(), 1e-12);
  EXPECT_LT((placeAt(countsAt(90, 90, 90)) - Vec3{0.45, 0.0, -0.22}).norm(), 1e-12);
  // motor c alone turns the forearm, about the elbow
  std::mt19937 random{5};
  for (int trial = 0; trial < 1'000; ++trial) {
    Counts counts = anyCounts(random);
    counts[0] = 0;
    const double b = counts[1] * 2.0 * std::numbers::pi / 2000.0 / 12.0;
    const Vec3 elbow{0.0, 0.205 * std::cos(b), 0.205 * std::sin(b) - 0.22};
    ASSERT_NEAR((placeAt(counts) - elbow).norm(), 0.245, 1e-12);
  }
}

TEST(WoodenArm, ItsJacobianIsItsDerivative) {
  std::mt19937 random{7};
  double worst = 0.0;
  for (int trial = 0; trial < 5'000; ++trial) {
    const Counts counts = anyCounts(random);
    const auto arm = woodenArm(counts);
    for (std::size_t i = 0; i < 3; ++i) {
      // Richardson's of two central differences, over whole counts
      const auto difference = [&](int step) {
        Counts more = counts, less = counts;
        more[i] = static_cast<std::int16_t>(more[i] + step);
        less[i] = static_cast<std::int16_t>(less[i] - step);
        const double angle = 2.0 * step * (2.0 * std::numbers::pi / 2000.0) * kBody[i];
        return Vec3{(placeAt(more) - placeAt(less)) / angle};
      };
      const Vec3 slope = (4.0 * difference(1) - difference(2)) / 3.0;
      worst = std::max(worst, (slope - arm->J_B.col(static_cast<Eigen::Index>(i))).norm());
    }
  }
  EXPECT_LT(worst, 1e-11);
}

// Virtual work: what the motors do on a count is what the force does on the handle.
TEST(WoodenArm, MotorsDoTheWorkOfTheForce) {
  std::mt19937 random{11};
  std::normal_distribution<double> normal;
  double worst = 0.0;
  for (int trial = 0; trial < 5'000; ++trial) {
    const Counts counts = anyCounts(random);
    const Vec3 force{normal(random), normal(random), normal(random)};
    const Vec3 currents =
        haptics::currentsFor(haptics::woodenHaptics(), force, woodenArm(counts)->J_B);
    for (std::size_t i = 0; i < 3; ++i) {
      Counts more = counts, less = counts;
      ++more[i];
      --less[i];
      const double motor_work =
          currents[static_cast<Eigen::Index>(i)] * 0.0603 * (2.0 * std::numbers::pi / 2000.0) * 2.0;
      worst = std::max(worst, std::abs(motor_work - force.dot(placeAt(more) - placeAt(less))));
    }
  }
  EXPECT_LT(worst, 1e-10);  // J, of some 1e-4
}

TEST(WoodenArm, ItsCountsAreAsFineAsItsRatingSays) {
  const double rated = haptics::findRating("woodenhaptics")->resolution;
  double widest = 0.0;
  std::mt19937 random{13};
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 5'000; ++trial) {
    const Counts counts = anyCounts(random);
    if (placeAt(counts).norm() > haptics::findRating("woodenhaptics")->workspace) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      Counts next = counts;
      ++next[i];
      widest = std::max(widest, (placeAt(next) - placeAt(counts)).norm());
    }
  }
  EXPECT_NEAR(widest, rated, 0.1 * rated);
}

TEST(WoodenArm, ReachesItsWorkspace) {
  std::mt19937 random{17};
  std::normal_distribution<double> normal;
  const double radius = haptics::findRating("woodenhaptics")->workspace;
  for (int point = 0; point < 500; ++point) {
    const Vec3 direction = Vec3{normal(random), normal(random), normal(random)}.normalized();
    // by the triangle of shoulder, elbow and handle
    const Vec3 p = direction * radius + Vec3{0.0, 0.0, 0.22};
    const double out = std::hypot(p.x(), p.z()), far = std::hypot(out, p.y());
    ASSERT_LT(far, 0.205 + 0.245);
    ASSERT_GT(far, 0.245 - 0.205);
    const double at_shoulder =
        std::acos((0.205 * 0.205 + far * far - 0.245 * 0.245) / (2 * 0.205 * far));
    const double at_elbow =
        std::acos((0.205 * 0.205 + 0.245 * 0.245 - far * far) / (2 * 0.205 * 0.245));
    const double upper = std::atan2(out, p.y()) - at_shoulder;  // from upright
    const double deg = 180.0 / std::numbers::pi;
    const Counts counts =
        countsAt(std::atan2(p.x(), p.z()) * deg, upper * deg, (at_elbow - upper) * deg);
    EXPECT_LT((placeAt(counts) - direction * radius).norm(), 0.1e-3);
  }
}

TEST(WoodenArm, AGimbalThatTurnsIsAnotherArms) {
  for (std::size_t i = 3; i < 6; ++i)
    for (const std::int16_t count : {-32768, -101, -100, 0, 100, 101, 32767}) {
      Counts counts = kWoodenRest;
      counts[i] = count;
      EXPECT_EQ(woodenArm(counts).has_value(), std::abs(count) <= 100) << count;
    }
}

}  // namespace
