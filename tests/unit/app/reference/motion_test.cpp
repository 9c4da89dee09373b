// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/motion.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using reference::Pose;
using reference::Quat;
using reference::Twist;
using reference::Vec3;

class Generator {
 public:
  double number(double size) { return size * std::uniform_real_distribution{-1.0, 1.0}(random_); }
  Vec3 vector(double size) { return {number(size), number(size), number(size)}; }
  Pose pose() {
    return haptics::poseOf(vector(0.1), Quat{number(1), number(1), number(1), number(1)});
  }

 private:
  std::mt19937 random_{5};
};

TEST(ReferenceMotion, LeadsFromTheProxyToTheDevice) {
  Generator make;
  for (int trial = 0; trial < 1000; ++trial) {
    const Pose X_WP = make.pose(), X_WD = make.pose();
    const Twist motion = reference::unconstrainedMotion(X_WP, X_WD);
    EXPECT_LE(motion.angular.norm(), M_PI + 1e-12);
    EXPECT_TRUE(reference::moved(X_WP, motion, 1.0).isApprox(X_WD, 1e-12));
  }
}

// a small turn keeps all its digits: atan2 of the half angle, no arc cosine
TEST(ReferenceMotion, KeepsTinyTurns) {
  const Pose X_WD = haptics::poseOf(Vec3::Zero(), Quat{1.0, 0.5e-9, 0.0, 0.0});
  const Twist motion = reference::unconstrainedMotion(Pose::Identity(), X_WD);
  EXPECT_NEAR(motion.angular.x(), 1e-9, 1e-20);
  EXPECT_EQ(reference::unconstrainedMotion(X_WD, X_WD).angular.norm(), 0.0);
}

// (2): the centre goes along a line while the tool turns about it, which is no screw
TEST(ReferenceMotion, TakesTheCentreAlongALine) {
  const Twist motion{.linear = {0.01, 0.0, 0.0}, .angular = {0.0, 0.0, M_PI / 2}};
  const Pose half = reference::moved(Pose::Identity(), motion, 0.5);
  EXPECT_TRUE(half.translation().isApprox(Vec3{0.005, 0.0, 0.0}));
  const Vec3 turned = half.linear() * Vec3::UnitX();
  EXPECT_NEAR(turned.x(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(turned.y(), std::sqrt(0.5), 1e-15);
}

TEST(ReferenceMotion, IsNotAtAllMadeAtTimeZero) {
  Generator make;
  const Pose X_WP = make.pose();
  EXPECT_EQ(reference::moved(X_WP, {Vec3::Ones(), Vec3::Ones()}, 0.0).matrix(), X_WP.matrix());
}

TEST(ReferenceMotion, BoundsThePathOfEveryPoint) {
  Generator make;
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 r_P = make.vector(0.05);
    const Twist motion{make.vector(0.01), make.vector(1.0)};
    double length = 0.0;
    Vec3 before = r_P;
    for (int step = 1; step <= 200; ++step) {
      const Vec3 now = reference::moved(Pose::Identity(), motion, step / 200.0) * r_P;
      length += (now - before).norm();
      before = now;
    }
    EXPECT_LE(length, reference::pathBound(motion, r_P.norm()) * (1 + 1e-12));
  }
}

}  // namespace
