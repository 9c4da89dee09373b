// SPDX-License-Identifier: BSD-3-Clause
// What is written as NRRD is read alike.
#include <gtest/gtest.h>

#include <cstring>

#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;
using testing::differing;
using testing::Workshop;

/// 5 x 4 x 3 voxels, each different from all others.
std::string rampToWrite() {
  std::string bytes;
  for (std::int16_t v = 0; v < 60; ++v) bytes.append(reinterpret_cast<const char*>(&v), 2);
  return bytes;
}

TEST(NrrdWriter, WhatIsWrittenIsReadAlike) {
  Workshop workshop;
  haptics::Grid grid;
  grid.dims = {5, 4, 3};
  grid.spacing = Vec3(0.337891e-3, 0.451171875e-3, 1.0 / 3000.0);
  grid.origin = Vec3(-0.1061234567, 0.2, 9.87654321);
  grid.direction = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  grid.direction.col(2) *= -1.0;
  for (const bool known : {true, false}) {
    auto voxels = haptics::allocateVoxels(60, ScalarType::Int16);
    ASSERT_TRUE(voxels);
    std::memcpy(voxels->get(), rampToWrite().data(), 120);
    const auto v =
        haptics::makeVolume(grid, ScalarType::Int16, *voxels,
                            {.unit = "HU", .modality = "CT", .orientation_known = known});
    ASSERT_TRUE(v) << sentence(v.error());
    const fs::path path = workshop.folder() / "out.nrrd";
    ASSERT_TRUE(writeNrrd(*v, path));
    const auto back = readVolume(path);
    ASSERT_TRUE(back) << sentence(back.error());
    EXPECT_EQ(differing(*v, *back), 0);
    EXPECT_EQ(back->type, v->type);
    EXPECT_EQ(back->unit, "HU");
    EXPECT_EQ(back->modality, "CT");
    EXPECT_EQ(back->orientation_known, known);
    EXPECT_LT((back->grid.spacing - grid.spacing).norm() / grid.spacing.norm(), 1e-12);
    EXPECT_LT((back->grid.origin - grid.origin).norm() / grid.origin.norm(), 1e-12);
    EXPECT_LT((back->grid.direction - grid.direction).norm(), 1e-12);
    // nothing but the volume is left behind
    EXPECT_EQ(std::distance(fs::directory_iterator(workshop.folder()), fs::directory_iterator()),
              1);
  }
  EXPECT_FALSE(writeNrrd(*readVolume(workshop.folder() / "out.nrrd"), "/no/such/folder/out.nrrd"));
}

TEST(NrrdWriter, SpacingsReadBackToTheLastBit) {
  Workshop workshop;
  haptics::Grid grid;
  grid.dims = {1, 1, 1};
  auto voxels = haptics::allocateVoxels(1, ScalarType::Float32);
  ASSERT_TRUE(voxels);
  for (const double mm : {0.337891, 0.451171875, 0.1, 0.3, 2.5, 1.0 / 3.0, 0.703125}) {
    grid.spacing = Vec3::Constant(mm * 1e-3);
    const auto v = haptics::makeVolume(grid, ScalarType::Float32, *voxels);
    ASSERT_TRUE(v && writeNrrd(*v, workshop.folder() / "s.nrrd"));
    EXPECT_EQ(readVolume(workshop.folder() / "s.nrrd")->grid.spacing.x(), mm * 1e-3) << mm;
  }
}

}  // namespace
}  // namespace datasets
