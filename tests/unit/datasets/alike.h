// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "haptics/core/volume.h"

namespace datasets::testing {

inline void expectAlike(const haptics::Volume& a, const haptics::Volume& b) {
  ASSERT_EQ(a.grid.dims, b.grid.dims);
  constexpr double kExact_mm = 1e-9;
  EXPECT_LT(1e3 * (a.grid.spacing - b.grid.spacing).cwiseAbs().maxCoeff(), kExact_mm);
  EXPECT_LT(1e3 * (a.grid.origin - b.grid.origin).cwiseAbs().maxCoeff(), kExact_mm);
  // as far as the last voxel
  const haptics::Vec3 end(double(a.grid.dims[0] - 1), double(a.grid.dims[1] - 1),
                          double(a.grid.dims[2] - 1));
  EXPECT_LT(1e3 * (a.grid.worldOf(end) - b.grid.worldOf(end)).cwiseAbs().maxCoeff(), kExact_mm);
  EXPECT_LT((a.grid.direction - b.grid.direction).cwiseAbs().maxCoeff(), 1e-12);
  ASSERT_EQ(a.type, b.type);
  EXPECT_EQ(a.least, b.least);
  EXPECT_EQ(a.greatest, b.greatest);
  EXPECT_EQ(a.unit, b.unit);
  EXPECT_EQ(a.modality, b.modality);
  EXPECT_EQ(a.orientation_known, b.orientation_known);
  const auto bytes = static_cast<std::size_t>(a.grid.voxelCount()) * haptics::sizeOf(a.type);
  EXPECT_EQ(std::memcmp(a.voxels.get(), b.voxels.get(), bytes), 0) << "voxels differ";
}

}  // namespace datasets::testing
