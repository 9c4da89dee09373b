// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/solid.h"

#include <gtest/gtest.h>

#include "tests/unit/app/reference/volumes.h"

namespace {

using haptics::Mat3;
using reference::Choices;
using reference::Solid;
using reference::Vec3;
using reference_test::sampled;

TEST(ReferenceSolid, IsExactOnALinearFieldHoweverTheGridLies) {
  // unequal sides, turned and left-handed axes
  Mat3 direction = Eigen::AngleAxisd{0.7, Vec3{1, 2, 3}.normalized()}.toRotationMatrix();
  direction.col(2) *= -1.0;
  const Vec3 slope{300.0, -200.0, 500.0};
  const auto volume = sampled(
      20, {1e-3, 2e-3, 3e-3}, [&](const Vec3& p) { return slope.dot(p) + 7.0; }, direction);
  const Solid solid{volume, 7.0, {}};
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1e-3, 2e-3, -1.7e-3}, Vec3{-4e-3, 0.3e-3, 5e-3}}) {
    EXPECT_NEAR(solid.value(p), slope.dot(p) + 7.0, 1e-5);  // floats of about 10
    EXPECT_TRUE(solid.gradient(p).isApprox(slope, 1e-4));
    EXPECT_TRUE(solid.normal(p).isApprox(-slope.normalized(), 1e-4));
    EXPECT_NEAR(solid.gap(p), -slope.dot(p) / slope.norm(), 1e-7);
  }
}

// (1) as printed has no division: with sides 1 : 4 its normal leans towards the long side
TEST(ReferenceSolid, TakesThePapersUndividedGradientAsASwitch) {
  const auto volume = sampled(20, {1e-3, 1e-3, 4e-3}, [](const Vec3& p) { return p.x() + p.z(); });
  Choices undivided;
  undivided.divided_gradient = false;
  const Vec3 printed = Solid{volume, 0.0, undivided}.normal(Vec3::Zero());
  EXPECT_NEAR(printed.z() / printed.x(), 4.0, 1e-4);
  const Vec3 divided = Solid{volume, 0.0, {}}.normal(Vec3::Zero());
  EXPECT_NEAR(divided.z() / divided.x(), 1.0, 1e-4);
}

TEST(ReferenceSolid, FallsToTheBackgroundWithinOneVoxelOfTheGrid) {
  const auto volume = sampled(4, Vec3::Constant(1e-3), [](const Vec3& p) {
    return p.norm() < 1e-3 ? -5.0 : 100.0;  // the least voxel is in the middle
  });
  const Solid solid{volume, 50.0, {}};
  const double edge = 1.5e-3;  // centre of the last voxel
  EXPECT_DOUBLE_EQ(solid.value({edge, edge, edge}), 100.0);
  EXPECT_NEAR(solid.value({edge + 0.5e-3, edge, edge}), 47.5, 1e-9);
  EXPECT_EQ(solid.value({edge + 1.0e-3, edge, edge}), -5.0);
  EXPECT_EQ(solid.value({1e3, 0, 0}), -5.0);
  EXPECT_EQ(solid.value({0, 0, -1e30}), -5.0);
}

TEST(ReferenceSolid, CallsTheIsovalueItselfInsideUnlessThePapersWordIsTaken) {
  const auto volume =
      sampled(4, Vec3::Constant(1e-3), [](const Vec3& p) { return p.x() > 0 ? 1000.0 : 0.0; });
  const Vec3 on_the_plateau{1.2e-3, 0, 0};
  EXPECT_TRUE(Solid(volume, 1000.0, {}).inside(on_the_plateau));
  Choices strict;
  strict.inside_includes_equal = false;
  EXPECT_FALSE(Solid(volume, 1000.0, strict).inside(on_the_plateau));
}

TEST(ReferenceSolid, CountsEveryLookUp) {
  const Solid solid{reference_test::halfSpace(8, 1e-3), 0.0, {}};
  solid.value(Vec3::Zero());
  EXPECT_EQ(solid.samples(), 1);
  solid.gradient(Vec3::Zero());
  EXPECT_EQ(solid.samples(), 7);
}

}  // namespace
