// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/core/volume.h"

#include <gtest/gtest.h>

#include <cstring>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::allocateVoxels;
using haptics::Grid;
using haptics::makeVolume;
using haptics::ScalarType;
using haptics::Vec3;

std::string reasonOf(const Grid& grid) {
  auto voxels = allocateVoxels(27, ScalarType::UInt8).value();
  const auto volume = makeVolume(grid, ScalarType::UInt8, voxels);
  return volume ? "" : volume.error().reason;
}

TEST(Volume, RefusesAGridThatIsNone) {
  const Grid good = datasets::centredGrid(3, 1e-3);
  EXPECT_EQ(reasonOf(good), "");
  for (int axis = 0; axis < 3; ++axis) {
    for (const std::int64_t n : {0, -1}) {
      Grid grid = good;
      grid.dims[static_cast<std::size_t>(axis)] = n;
      EXPECT_EQ(reasonOf(grid), "bad-header");
    }
    for (const double spacing : {0.0, -1e-3, double(NAN), double(INFINITY)}) {
      Grid grid = good;
      grid.spacing[axis] = spacing;
      EXPECT_EQ(reasonOf(grid), "bad-header");
    }
    Grid grid = good;
    grid.origin[axis] = NAN;
    EXPECT_EQ(reasonOf(grid), "bad-header");
    grid = good;
    grid.direction(axis, 0) = NAN;
    EXPECT_EQ(reasonOf(grid), "bad-header");
    grid = good;
    grid.direction.col(axis) *= 1.001;  // not a unit direction
    EXPECT_EQ(reasonOf(grid), "sheared");
    grid = good;
    grid.direction.col(axis) =
        (good.direction.col(axis) + 2e-3 * good.direction.col((axis + 1) % 3)).normalized();
    EXPECT_EQ(reasonOf(grid), "sheared");
    grid = good;
    grid.direction.col(axis) *= -1.0;  // left-handed is allowed
    EXPECT_EQ(reasonOf(grid), "");
  }
}

TEST(Volume, MakesWhatIsNotFiniteBackgroundAndCountsIt) {
  const Grid grid = datasets::centredGrid(3, 1e-3);
  auto voxels = allocateVoxels(27, ScalarType::Float32).value();
  auto* v = static_cast<float*>(voxels.get());
  for (int n = 0; n < 27; ++n) v[n] = static_cast<float>(n - 5);
  v[0] = NAN;
  v[13] = INFINITY;
  v[26] = -INFINITY;
  const auto volume = makeVolume(grid, ScalarType::Float32, voxels).value();
  EXPECT_EQ(volume.replaced, 3);
  EXPECT_EQ(volume.least, -4.0);
  EXPECT_EQ(volume.greatest, 20.0);
  const auto* w = static_cast<const float*>(volume.voxels.get());
  for (const int n : {0, 13, 26}) EXPECT_EQ(w[n], -4.0F);
  EXPECT_EQ(w[1], -4.0F);
  EXPECT_EQ(w[25], 20.0F);
}

TEST(Volume, RefusesOneWithoutAFiniteVoxel) {
  auto voxels = allocateVoxels(27, ScalarType::Float32).value();
  for (int n = 0; n < 27; ++n) static_cast<float*>(voxels.get())[n] = NAN;
  const auto volume = makeVolume(datasets::centredGrid(3, 1e-3), ScalarType::Float32, voxels);
  ASSERT_FALSE(volume);
  EXPECT_EQ(volume.error().reason, "no-pixels");
}

TEST(Volume, FindsTheRangeOfEveryType) {
  Random random{81};
  for (const ScalarType type : made::kTypes) {
    SCOPED_TRACE(haptics::nameOf(type));
    const auto volume = made::randomVolume(datasets::centredGrid(7, 1e-3), type, random);
    double least = INFINITY, greatest = -INFINITY;
    haptics::visitVoxels(type, volume.voxels.get(), [&](const auto* v) {
      for (int n = 0; n < 343; ++n) {
        least = std::min(least, double(v[n]));
        greatest = std::max(greatest, double(v[n]));
      }
    });
    EXPECT_EQ(volume.least, least);
    EXPECT_EQ(volume.greatest, greatest);
    EXPECT_EQ(volume.replaced, 0);
  }
}

TEST(Volume, VoxelsAreFollowedByReadablePadding) {
  auto voxels = allocateVoxels(5, ScalarType::Int16).value();
  // the address sanitizer watches this
  char sum = 0;
  for (std::size_t n = 0; n < 5 * 2 + haptics::kVoxelPadding; ++n)
    sum = static_cast<char>(sum + static_cast<const char*>(voxels.get())[n]);
  EXPECT_EQ(sum, 0);
}

TEST(Volume, RefusesMoreMemoryThanThereIs) {
  for (const std::int64_t count : {std::int64_t{0}, std::int64_t{-5}, std::int64_t{1} << 62,
                                   std::numeric_limits<std::int64_t>::max()})
    EXPECT_FALSE(allocateVoxels(count, ScalarType::Float32)) << count;
}

TEST(Grid, IndexAndWorldAreEachOthersInverseInAnyFrame) {
  Random random{82};
  for (int k = 0; k < 30; ++k) {
    const Grid grid = made::oddGrid(k, {20, 30, 40}, random);
    const Vec3 u = random.box(50.0);
    EXPECT_LT((grid.indexOf(grid.worldOf(u)) - u).norm(), 1e-10);
    const Vec3 step = grid.worldOf(u + Vec3::UnitY()) - grid.worldOf(u);
    EXPECT_NEAR(step.norm(), grid.spacing.y(), 1e-15);
    EXPECT_NEAR(step.normalized().dot(grid.direction.col(1)), 1.0, 1e-12);
  }
}

}  // namespace
