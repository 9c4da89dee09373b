// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/wall.h"

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

#include "app/study/page/plot.h"
#include "haptics/coupling/passivity.h"

namespace study::stability {
namespace {

using haptics::Grip;
using haptics::Linkage;
using haptics::Pose;
using haptics::Twist;
using haptics::Vec3;
using haptics::Wrench;

constexpr double kWindow = 0.2;  // s

/// Position and speed of the free device after a period, and what a held force adds: the
/// exponential of its differential equation.
struct Sampled {
  Eigen::Matrix2d A;
  Eigen::Vector2d B;
};
Sampled sampled(const Wall& wall) {
  const double m = wall.device.mass + wall.hand.mass;
  const double b = wall.device.damping + wall.hand.damping;
  Eigen::Matrix3d rate = Eigen::Matrix3d::Zero();
  rate(0, 1) = 1.0;
  rate(1, 0) = -wall.hand.stiffness / m;
  rate(1, 1) = -b / m;
  rate(1, 2) = 1.0 / m;
  const Eigen::Matrix3d power = (rate * wall.period).exp();
  return {power.topLeftCorner<2, 2>(), power.topRightCorner<2, 1>()};
}

/// The greatest growth of the linear loop in a period.
double spectralRadius(const Wall& wall, const Sampled& free, double stiffness) {
  // state: position, speed, position a period ago, forces under way (the oldest acts next)
  const int delay = wall.device.linkage.delay, n = 3 + delay;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::RowVectorXd force = Eigen::RowVectorXd::Zero(n);
  force(0) = -stiffness - wall.damping / wall.period;
  force(2) = wall.damping / wall.period;
  A.topLeftCorner<2, 2>() = free.A;
  A(2, 0) = 1.0;
  if (delay == 0) {
    A.topRows<2>() += free.B * force;
  } else {
    A.block<2, 1>(0, 3) = free.B;
    for (int k = 3; k + 1 < n; ++k) A(k, k + 1) = 1.0;
    A.row(n - 1) = force;
  }
  return A.eigenvalues().cwiseAbs().maxCoeff();
}

/// Between a fifth and ten times of the theory, to 0.5 %.
template <class Holds>
Limit limitAbout(const Wall& wall, Holds&& holds) {
  return stiffestThatHolds(0.2 * wall.theory(), 10.0 * wall.theory(), 1.05, 1.005, holds);
}

}  // namespace

double Wall::theory() const {
  return 2.0 * totalDamping() / (period * (1.0 + 2.0 * device.linkage.delay));
}

void Shaking::add(double time, double place, double speed) {
  lost_ = lost_ || !(std::abs(place) < 1.0 && speed < 1e3);
  if (time >= 0.25 * kPressTime && time < 0.5 * kPressTime) early_ += speed * speed;
  if (time >= 0.75 * kPressTime) late_ += speed * speed;
  if (time >= kPressTime - kWindow) {
    lowest_ = std::min(lowest_, place);
    highest_ = std::max(highest_, place);
  }
}

Pressed pressOn(const Wall& wall, double stiffness,
                const std::function<void(double, double)>& each) {
  Linkage linkage = wall.device.linkage;
  Grip grip = wall.device.heldBy(wall.hand, 0.03);
  grip.velocity.linear.z() = -kArrival;
  const double depth = kPressForce * (1.0 / wall.hand.stiffness + 1.0 / stiffness);
  const Pose X_WH = haptics::poseOf({0.0, 0.0, -depth}, haptics::Quat::Identity());

  haptics::PassivityController controller{wall.controller, grip.gyration, linkage.torque};
  haptics::PassivityObserver observer;
  Wrench held;
  Shaking shaking;
  Pose X_WD = linkage.read(grip.X_WD);
  const int ticks = int(std::lround(kPressTime / wall.period));
  for (int n = 0; n < ticks; ++n) {
    const double time = n * wall.period;
    const Pose X_WH_before = grip.X_WD, X_WD_before = X_WD;
    if (n > 0) grip.advance(X_WH, held, wall.period);
    observer.add(held, haptics::motionBetween(X_WH_before, grip.X_WD));
    X_WD = linkage.read(grip.X_WD);
    const Twist motion = haptics::motionBetween(X_WD_before, X_WD);

    Wrench wrench;
    const double z = X_WD.translation().z();
    if (z < 0.0) wrench.force.z() = -stiffness * z;
    wrench = haptics::damped(wrench, motion, wall.period, wall.damping, grip.gyration);
    if (wall.controller > 0.0) wrench = controller.pass(wrench, motion, wall.period);
    held = linkage.carry(wrench, grip.X_WD);

    const double place = grip.X_WD.translation().z();
    if (each) each(time, -place);
    const double speed = grip.velocity.linear.norm();
    shaking.add(time, place, speed);
    if (shaking.isLost()) return {true, std::abs(place), observer.energy()};
  }
  return {shaking.isFed(linkage.encoder), shaking.amplitude(), observer.energy()};
}

std::string toWords(const Limit& limit) {
  return (limit.found ? "" : "over ") + shortly(limit.stiffness);
}

Limit measuredLimit(const Wall& wall) {
  return limitAbout(wall, [&](double stiffness) { return !pressOn(wall, stiffness).fed; });
}

double linearLimit(const Wall& wall) {
  const Sampled free = sampled(wall);
  const auto holds = [&](double stiffness) { return spectralRadius(wall, free, stiffness) < 1.0; };
  return limitAbout(wall, holds).stiffness;
}

}  // namespace study::stability
