// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "datasets/phantoms/making.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/solver/unconstrained_motion.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::Mat3;
using haptics::Pose;
using haptics::Quat;
using haptics::saturated;
using haptics::Vec3;
using haptics::VirtualCoupling;
using haptics::Wrench;
using made::at;

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

}  // namespace
