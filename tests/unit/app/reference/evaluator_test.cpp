// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/evaluator.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using haptics::Mat3;
using haptics::Pose;
using haptics::Vec3;

/// 12 x 10 x 8 voxels of int16, unequal sides, turned and left-handed, far from the origin.
template <class F>
haptics::Volume turned(F&& f) {
  haptics::Grid grid;
  grid.dims = {12, 10, 8};
  grid.spacing = {1e-3, 2e-3, 3e-3};
  grid.origin = {0.3, -0.2, 1.7};
  grid.direction = Eigen::AngleAxisd{0.9, Vec3{1, -2, 0.5}.normalized()}.toRotationMatrix();
  grid.direction.col(0) *= -1.0;
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16).value();
  auto* out = static_cast<std::int16_t*>(voxels.get());
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 12; ++i) *out++ = static_cast<std::int16_t>(f(i, j, k));
  return haptics::makeVolume(grid, haptics::ScalarType::Int16, voxels).value();
}

/// Where a continuous index lies.
Vec3 at(const haptics::Volume& volume, double i, double j, double k) {
  return volume.grid.origin + volume.grid.direction * Vec3{1e-3 * i, 2e-3 * j, 3e-3 * k};
}

// one product of each kind: i, jk and ijk are reproduced exactly by trilinear weights
int product(int i, int j, int k) { return 7 * i + 11 * j * k + 3 * i * j * k; }

TEST(Evaluator, ReproducesATrilinearFunctionAndItsSlope) {
  const auto volume = turned(product);
  const double i = 4.25, j = 6.5, k = 3.125;
  EXPECT_NEAR(evaluator::fieldAt(volume, at(volume, i, j, k)), 7 * i + 11 * j * k + 3 * i * j * k,
              1e-9);
  const Vec3 slope{(7 + 3 * j * k) / 1e-3, (11 * k + 3 * i * k) / 2e-3,
                   (11 * j + 3 * i * j) / 3e-3};
  EXPECT_NEAR(evaluator::slopeAt(volume, at(volume, i, j, k)), slope.norm(), 1e-9 * slope.norm());
}

TEST(Evaluator, FallsToTheLeastVoxelBeyondTheGrid) {
  const auto volume = turned([](int i, int, int) { return i == 0 ? -40 : 100; });
  EXPECT_NEAR(evaluator::fieldAt(volume, at(volume, 11.0, 4, 4)), 100.0, 1e-9);
  EXPECT_NEAR(evaluator::fieldAt(volume, at(volume, 11.5, 4, 4)), 30.0, 1e-9);
  EXPECT_NEAR(evaluator::fieldAt(volume, at(volume, 12.0, 4, 4)), -40.0, 1e-9);
  EXPECT_EQ(evaluator::fieldAt(volume, Vec3::Constant(1e6)), -40.0);
}

TEST(Evaluator, MeasuresDepthAlongTheSlopeAndOnAPlateauByDistance) {
  const auto ramp = turned([](int i, int, int) { return 100 * i; });  // 1e5 per metre
  EXPECT_EQ(evaluator::penetrationAt_mm(ramp, 500.0, at(ramp, 4.99, 4, 4)), 0.0);
  EXPECT_NEAR(evaluator::penetrationAt_mm(ramp, 500.0, at(ramp, 7.5, 4, 4)), 2.5, 1e-9);

  // the plane i = 2 is the nearest that is out; the rim of the grid is further away
  const auto block = turned([](int i, int, int) { return i < 3 ? 0 : 1000; });
  EXPECT_NEAR(evaluator::penetrationAt_mm(block, 500.0, at(block, 5.3, 4.2, 4.1)),
              std::hypot(3.3, 0.4, 0.3), 1e-9);
  // fewer voxels to the one below, and a longer way
  const auto corner = turned([](int i, int, int k) { return i < 1 || k < 2 ? 0 : 1000; });
  EXPECT_NEAR(evaluator::penetrationAt_mm(corner, 500.0, at(corner, 5.3, 4.2, 4.1)),
              std::hypot(5.3, 0.4, 0.3), 1e-9);
}

TEST(Evaluator, FindsTheOnePointOfAShellThatIsInside) {
  const auto ramp = turned([](int i, int, int) { return 100 * i; });
  Pose X_WP = haptics::poseOf(at(ramp, 4, 4, 4), haptics::Quat{0.3, 0.5, -0.1, 0.7});
  const Vec3 up_P = X_WP.linear().transpose() * ramp.grid.direction.col(0);
  const std::vector<Vec3> shell = {-2e-3 * up_P, 0.5e-3 * up_P, Vec3::Zero()};
  EXPECT_EQ(evaluator::penetration_mm(ramp, 500.0, shell, X_WP), 0.0);
  EXPECT_TRUE(evaluator::isLegal(ramp, 500.0, shell, X_WP));
  X_WP.translation() += 0.7e-3 * ramp.grid.direction.col(0);
  EXPECT_NEAR(evaluator::penetration_mm(ramp, 500.0, shell, X_WP), 0.2, 1e-9);
  EXPECT_FALSE(evaluator::isLegal(ramp, 500.0, shell, X_WP));
}

}  // namespace
