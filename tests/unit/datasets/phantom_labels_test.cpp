// SPDX-License-Identifier: BSD-3-Clause
// Label maps of phantoms, and label maps that are written.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <atomic>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "datasets/labels/label_file.h"
#include "datasets/labels/label_writer.h"
#include "datasets/labels/phantom_labels.h"
#include "datasets/phantoms/sampling.h"
#include "datasets/phantoms/structures.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/support/turned_scan.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using haptics::Grid;
using haptics::Mat3;
using haptics::Vec3;
using testing::Workshop;

/// About W's origin, its axes turned.
Grid turnedGrid(const Mat3& axes, std::int64_t ni, std::int64_t nj, std::int64_t nk,
                const Vec3& spacing_mm) {
  Grid grid = centredGrid(ni, nj, nk, 1e-3 * spacing_mm);
  grid.origin = axes * grid.origin;
  grid.direction = axes;
  return grid;
}

haptics::Volume scanOver(const Grid& grid) {
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::UInt8).value();
  return haptics::makeVolume(grid, haptics::ScalarType::UInt8, std::move(voxels)).value();
}

TEST(PhantomLabels, AreTheSignsOfTheDistances) {
  const Mat3 oblique = Eigen::AngleAxisd{0.6, Vec3{0.3, -0.8, 0.5}.normalized()}.matrix();
  for (const auto& [phantom, grid] :
       {std::pair{"mastoid", turnedGrid(Mat3::Identity(), 75, 76, 77, Vec3::Constant(0.62))},
        {"mastoid", turnedGrid(oblique, 61, 67, 59, {0.9, 0.7, 1.1})},
        {"demo", turnedGrid(oblique, 61, 67, 59, {3.1, 3.7, 4.1})}}) {
    const auto map = phantomLabels(phantom, grid);
    ASSERT_TRUE(map) << sentence(map.error());
    const auto structures = phantomStructures(phantom);
    ASSERT_EQ(map->structures().size(), structures.size());
    std::vector<std::int64_t> counted(structures.size());
    std::int64_t voxel = 0, overlapping = 0;
    for (std::int64_t k = 0; k < grid.dims[2]; ++k)
      for (std::int64_t j = 0; j < grid.dims[1]; ++j)
        for (std::int64_t i = 0; i < grid.dims[0]; ++i, ++voxel) {
          std::vector<std::uint8_t> expected;
          for (std::size_t n = 0; n < structures.size(); ++n)
            if (structures[n].distance(grid.worldOf({double(i), double(j), double(k)})) <= 0.0) {
              expected.push_back(std::uint8_t(n));
              ++counted[n];
            }
          ASSERT_EQ(map->structuresOf(map->codes()[voxel]), expected) << i << ' ' << j << ' ' << k;
          overlapping += expected.size() > 1;
        }
    EXPECT_GT(overlapping, 5) << phantom;
    for (std::size_t n = 0; n < structures.size(); ++n) {
      EXPECT_EQ(map->structures()[n].name, structures[n].name);
      EXPECT_EQ(map->structures()[n].colour, structures[n].colour);
      EXPECT_EQ(map->structures()[n].voxels, counted[n]);
      EXPECT_GT(counted[n], 0) << structures[n].name;
    }
  }
}

TEST(PhantomLabels, OfAPhantomWithoutStructuresAreNone) {
  const auto map = phantomLabels("sphere", centredGrid(8, 1e-3));
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->structures().empty());
  const std::atomic<bool> cancel = true;
  const auto none = phantomLabels("mastoid", centredGrid(8, 1e-3), &cancel);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, haptics::Error::Kind::Cancelled);
}

/// Written and read again, over the same voxels.
void expectReadAlike(const LabelMap& map, const Workshop& workshop) {
  const auto path = workshop.folder() / "labels.seg.nrrd";
  const auto written = writeLabels(map, path);
  ASSERT_TRUE(written) << sentence(written.error());
  const auto back = readLabels(path, scanOver(map.grid()));
  ASSERT_TRUE(back) << sentence(back.error());
  ASSERT_EQ(back->structures().size(), map.structures().size());
  for (std::size_t n = 0; n < map.structures().size(); ++n) {
    EXPECT_EQ(back->structures()[n].name, map.structures()[n].name);
    EXPECT_EQ(back->structures()[n].colour, map.structures()[n].colour);
    EXPECT_EQ(back->structures()[n].voxels, map.structures()[n].voxels);
  }
  for (std::int64_t n = 0; n < map.grid().voxelCount(); ++n)
    ASSERT_EQ(back->structuresOf(back->codes()[n]), map.structuresOf(map.codes()[n])) << n;
  // and not a voxel beside its place, as another reader sees it where nothing says what it is
  std::ifstream file{path, std::ios::binary};
  std::string bytes{std::istreambuf_iterator<char>{file}, {}};
  for (std::size_t at = 0; (at = bytes.find("\nSegment", at)) != std::string::npos;)
    bytes.replace(at, 8, "\nUnknown");
  const auto volume = readVolume(workshop.write("volume.nrrd", bytes), {.series = 0});
  ASSERT_TRUE(volume) << sentence(volume.error());
  EXPECT_LT((volume->grid.origin - map.grid().origin).norm(), 1e-12);
  EXPECT_LT((volume->grid.direction - map.grid().direction).norm(), 1e-12);
  EXPECT_LT((volume->grid.spacing - map.grid().spacing).norm(), 1e-12);
}

TEST(LabelWriter, WhatIsWrittenInEveryOrientationIsReadAlike) {
  int files = 0;
  for (const Mat3& axes : turned::orientations()) {
    Workshop workshop;
    const auto map = phantomLabels("mastoid", turnedGrid(axes, 41, 37, 29, {1.1, 1.3, 1.7}));
    ASSERT_TRUE(map);
    ASSERT_NO_FATAL_FAILURE(expectReadAlike(*map, workshop)) << axes;
    ++files;
  }
  EXPECT_EQ(files, 48);
}

TEST(LabelWriter, KeepsAnyNameAndAnyNumberOfStructures) {
  const Workshop workshop;
  for (const int overlapping : {0, 3}) {
    auto map = LabelMap::over(centredGrid(9, 1e-3)).value();
    for (int n = 0; n < 255; ++n)
      map.add({.name = n == 0   ? "back\\slash := n\\n"
                       : n == 1 ? "\xC3\xA4: N. VII"
                       : n == 2 ? ""
                                : std::to_string(n),
               .colour = {n / 255.0, 1.0 / 3.0, 1.0}});
    // the last: none; sets of several need codes of their own
    for (int n = 0; n < 254 - overlapping; ++n) ASSERT_TRUE(map.mark(2 * n, std::uint8_t(n)));
    for (int n = 0; n < overlapping; ++n) {
      ASSERT_TRUE(map.mark(700, std::uint8_t(n)));
      ASSERT_TRUE(map.mark(701, std::uint8_t(n)));
      ASSERT_TRUE(map.mark(701, std::uint8_t(n)));  // once more is nothing
    }
    ASSERT_NO_FATAL_FAILURE(expectReadAlike(map, workshop));
    // a layer for each
    const auto layers = survey(workshop.folder() / "volume.nrrd");
    ASSERT_TRUE(layers) << sentence(layers.error());
    EXPECT_EQ(layers->series.size(), overlapping == 0 ? 1U : 3U);
  }
  // the labels, and the volume that the test made of them
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(workshop.folder()), {}), 2);
  const auto map = phantomLabels("mastoid", centredGrid(8, 5e-3)).value();
  EXPECT_FALSE(writeLabels(map, workshop.folder() / "none" / "labels.seg.nrrd"));
  const std::atomic<bool> cancel = true;
  EXPECT_FALSE(writeLabels(map, workshop.folder() / "new.seg.nrrd", {.cancel = &cancel}));
  EXPECT_FALSE(std::filesystem::exists(workshop.folder() / "new.seg.nrrd"));
}

}  // namespace
}  // namespace datasets
