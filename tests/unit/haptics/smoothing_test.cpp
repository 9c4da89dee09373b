// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/smoothing.h"

#include <gtest/gtest.h>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/support/made.h"

namespace {

using haptics::ScalarType;
using haptics::smoothingEffect;
using haptics::SmoothingEffect;

/// Slabs of `thick` voxels of 1000 every 12, across i.
haptics::Volume slabs(int thick, std::int64_t n) {
  return datasets::filled(
      datasets::centredGrid(n, 1e-3), ScalarType::Int16,
      [&](auto i, auto, auto) { return i % 12 >= 4 && i % 12 < 4 + thick ? 1000.0 : 0.0; });
}

// a voxel alone keeps 4/6 of its height, and gives a neighbour 1/6
TEST(SmoothingEffect, OfASlabOfOneVoxelIsAllAboveTwoThirdsAndNothingBelow) {
  EXPECT_EQ(smoothingEffect(slabs(1, 48), 700.0).erased, 1.0);
  EXPECT_EQ(smoothingEffect(slabs(1, 48), 600.0).erased, 0.0);
  EXPECT_EQ(smoothingEffect(slabs(1, 48), 600.0).gained, 0.0);
  EXPECT_EQ(smoothingEffect(slabs(1, 48), 100.0).gained, 2.0);
}

TEST(SmoothingEffect, OfAThickSlabIsNothingAtHalfItsHeight) {
  const SmoothingEffect effect = smoothingEffect(slabs(6, 48), 500.0);
  EXPECT_EQ(effect.erased, 0.0);
  EXPECT_EQ(effect.gained, 0.0);
}

TEST(SmoothingEffect, OfALargeVolumeIsNearlyThatOfAllItsVoxels) {
  // a slab of three loses its outer two voxels above 5/6
  const SmoothingEffect effect = smoothingEffect(slabs(3, 132), 900.0);
  EXPECT_NEAR(effect.erased, 2.0 / 3.0, 0.02);
  EXPECT_EQ(effect.gained, 0.0);
}

TEST(SmoothingEffect, OfNothingIsNothing) {
  EXPECT_EQ(smoothingEffect(slabs(1, 24), 2000.0).erased, 0.0);
}

}  // namespace
