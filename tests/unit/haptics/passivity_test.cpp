// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/coupling/passivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/simulation/grip.h"

namespace {

using haptics::Grip;
using haptics::PassivityController;
using haptics::PassivityObserver;
using haptics::Pose;
using haptics::Quat;
using haptics::Twist;
using haptics::Vec3;
using haptics::Wrench;

constexpr double T = 1e-3;  // s

// a spring of K, sampled and held, that is pressed to `depth` and let go at a steady speed: on the
// way in it lags by being too weak, on the way out by being too strong, each time by K v T / 2 in
// the mean, so that it gives K v T depth
TEST(PassivityObserver, FindsWhatASampledSpringGenerates) {
  const double K = 1000.0, v = 0.05, depth = 5e-3;
  PassivityObserver observer;
  Wrench held;
  const int ticks = int(std::lround(depth / (v * T)));
  double x = 0.0;
  for (int n = 0; n < 2 * ticks; ++n) {
    const double next = n < ticks ? (n + 1) * v * T : (2 * ticks - n - 1) * v * T;
    observer.add(held, {{0, 0, -(next - x)}, Vec3::Zero()});
    x = next;
    held.force = {0, 0, K * x};
  }
  EXPECT_NEAR(observer.energy(), K * v * T * depth, 1e-9);
  EXPECT_GT(observer.energy(), 2e-4);  // J
}

TEST(PassivityObserver, FindsWhatADamperTakes) {
  const double b = 3.0;
  PassivityObserver observer;
  double taken = 0.0;
  for (int n = 0; n < 1000; ++n) {
    const Vec3 v{0.1 * std::sin(0.02 * n), 0.0, 0.05}, w{0.0, 2.0 * std::cos(0.03 * n), 0.0};
    observer.add({-b * v, -1e-3 * b * w}, {v * T, w * T});
    taken += b * (v.squaredNorm() + 1e-3 * w.squaredNorm()) * T;
  }
  EXPECT_NEAR(observer.energy(), -taken, 1e-9 * taken);
  observer.add({Vec3::Constant(NAN), Vec3::Zero()}, {Vec3::Ones(), Vec3::Zero()});
  EXPECT_NEAR(observer.energy(), -taken, 1e-9 * taken);
}

TEST(MotionBetween, LeadsFromOnePoseToTheOther) {
  const Pose from = haptics::poseOf({1, 2, 3}, Quat{Eigen::AngleAxisd{0.7, Vec3::UnitX()}});
  const Vec3 axis = Vec3{1, -2, 0.5}.normalized();
  const Pose to =
      haptics::poseOf({1.5, 2, 2}, Quat{Eigen::AngleAxisd{0.3, axis}} * Quat{from.linear()});
  const Twist motion = haptics::motionBetween(from, to);
  EXPECT_LT((motion.linear - Vec3{0.5, 0, -1}).norm(), 1e-12);
  EXPECT_LT((motion.angular - 0.3 * axis).norm(), 1e-12);
}

/// How much a mass on a spring that lags three periods shakes after two seconds, for its first
/// push: in translation [m], and in rotation [rad].
std::pair<double, double> shaking(double most_damping, bool torque) {
  Grip grip;
  grip.mass = 0.2;
  grip.damping = 1.0;
  grip.stiffness = 0.0;
  grip.velocity = {{0.02, 0.0, 0.01}, {0.0, 0.5, 0.0}};
  const double K = 2000.0, turn_K = K * grip.gyration * grip.gyration;
  PassivityController controller{most_damping, grip.gyration, torque};
  Wrench late[3] = {}, held;
  double far = 0.0, turned = 0.0;
  for (int n = 0; n < 600; ++n) {
    const Pose before = grip.X_WD;
    grip.advance(Pose::Identity(), held, T);
    const Eigen::AngleAxisd turn{grip.X_WD.linear()};
    const Wrench wanted{-K * grip.X_WD.translation(), -turn_K * turn.angle() * turn.axis()};
    // the spring's lag is part of the environment, before the controller
    Wrench wrench = late[n % 3];
    late[n % 3] = wanted;
    const Twist motion = haptics::motionBetween(before, grip.X_WD);
    if (most_damping > 0.0) wrench = controller.pass(wrench, motion, T);
    held = wrench;
    if (!torque) held.torque.setZero();
    if (n >= 400) {
      far = std::max(far, grip.X_WD.translation().norm());
      turned = std::max(turned, turn.angle());
    }
  }
  return {far, turned};
}

TEST(PassivityController, TakesBackWhatASpringThatLagsGives) {
  const auto [far, turned] = shaking(0.0, true);
  EXPECT_GT(far, 5e-3);  // it grows from 0.2 mm
  EXPECT_GT(turned, 0.1);
  const auto [far_with, turned_with] = shaking(30.0, true);
  EXPECT_LT(far_with, 2e-3);
  EXPECT_LT(turned_with, 0.05);
}

TEST(PassivityController, LeavesAloneWhatIsPassiveAndUsesNoTorqueThatItHasNot) {
  PassivityController controller{30.0, 0.03, false};
  const Wrench wanted{{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}};
  const Twist against{{-1e-4, -1e-4, -1e-4}, {0.0, 0.0, -1e-2}};
  EXPECT_EQ(controller.pass(wanted, {}, T).force, wanted.force);
  EXPECT_EQ(controller.pass(wanted, against, T).force, wanted.force);
  EXPECT_LT(controller.observer().energy(), 0.0);
  // now it gives, more than it took: damped against the motion, by no more than 30 N·s/m
  const Twist along{{1e-3, 1e-3, 1e-3}, {0.0, 0.0, 1e-2}};
  const Wrench sent = controller.pass(wanted, along, T);
  EXPECT_GT(controller.observer().energy(), 0.0);
  EXPECT_LT(sent.force.dot(along.linear), wanted.force.dot(along.linear));
  EXPECT_LE((sent.force - wanted.force).norm(), 30.0 * along.linear.norm() / T + 1e-9);
  EXPECT_EQ(sent.torque, wanted.torque);
  // the torque that no motor makes is not counted: 6e-3 - 6e-4 J
  EXPECT_NEAR(controller.observer().energy(), 5.4e-3, 1e-9);
}

TEST(Damped, ActsAgainstMotionAndOnlyWhileSomethingIsFelt) {
  const Twist motion{{1e-4, 0, 0}, {0, 1e-3, 0}};
  EXPECT_TRUE(haptics::damped({}, motion, T, 5.0, 0.03).force.isZero(0.0));
  const Wrench wrench = haptics::damped({{0, 0, 1}, Vec3::Zero()}, motion, T, 5.0, 0.1);
  EXPECT_NEAR(wrench.force.x(), -0.5, 1e-12);          // N: 5 N·s/m times 0.1 m/s
  EXPECT_NEAR(wrench.torque.y(), -5.0 * 0.01, 1e-12);  // N·m: 5 times 0.01 m² times 1 rad/s
  EXPECT_EQ(wrench.force.z(), 1.0);
}

}  // namespace
