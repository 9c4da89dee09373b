// SPDX-License-Identifier: BSD-3-Clause
// Thumbnails follow the convention of the views, however a file turns its axes: each is held to
// what the patient's places say.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "datasets/readers/volume_reader.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/sentence.h"
#include "tests/support/turned_scan.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using haptics::Mat3;
using haptics::Vec3;
using testing::DicomSlice;
using testing::Workshop;

constexpr int kZoom = 3;  // pixels of a thumbnail for a voxel: odd, so that no pixel is between two

/// Of a voxel that is counted along L, P and S: no way to turn the box gives the same again.
std::int16_t grainAt(const std::array<int, 3>& count) {
  const auto [l, p, s] = count;
  return static_cast<std::int16_t>(
      (7 * l + 31 * p + 101 * s + 13 * l * p + 17 * p * s + 29 * l * s) % 251);
}
std::int16_t grain(const Vec3& p_mm) {
  const Vec3 count = (p_mm - turned::kFirst_mm) / turned::kStep_mm;
  return grainAt({static_cast<int>(std::lround(count.x())),
                  static_cast<int>(std::lround(count.y())),
                  static_cast<int>(std::lround(count.z()))});
}

/// What the convention says of a plane: which of L, P and S the picture's columns and rows follow,
/// and whether its rows run against it.
struct Wanted {
  AnatomicalPlane plane;
  int across, down;
  bool against;
};
Wanted wantedOf(int through) {
  if (through == 2) return {AnatomicalPlane::Axial, 0, 1, false};   // R at the left, A above
  if (through == 1) return {AnatomicalPlane::Coronal, 0, 2, true};  // R at the left, S above
  return {AnatomicalPlane::Sagittal, 1, 2, true};                   // A at the left, S above
}

/// Length of the longer side of the thumbnail of this plane [px].
int longestOf(const Wanted& wanted) {
  return kZoom * std::max(turned::kSize[std::size_t(wanted.across)],
                          turned::kSize[std::size_t(wanted.down)]);
}

/// The thumbnail of the plane through the middle of the patient's axis.
Thumbnail expectedThrough(int through) {
  const Wanted wanted = wantedOf(through);
  const int columns = turned::kSize[std::size_t(wanted.across)];
  const int rows = turned::kSize[std::size_t(wanted.down)];
  std::vector<double> values;
  for (int y = 0; y < kZoom * rows; ++y)
    for (int x = 0; x < kZoom * columns; ++x) {
      std::array<int, 3> count{};
      count[std::size_t(through)] = turned::kSize[std::size_t(through)] / 2;
      count[std::size_t(wanted.across)] = x / kZoom;
      count[std::size_t(wanted.down)] = wanted.against ? rows - 1 - y / kZoom : y / kZoom;
      values.push_back(grainAt(count));
    }
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  const double black = sorted[sorted.size() / 50];
  const double white = sorted[sorted.size() - 1 - sorted.size() / 50];
  Thumbnail small{kZoom * columns, kZoom * rows, {}, wanted.plane};
  for (const double v : values)
    small.grey.push_back(std::uint8_t(255.0 * std::clamp((v - black) / (white - black), 0.0, 1.0)));
  return small;
}

void expectSame(const haptics::Expected<Thumbnail>& seen, const Thumbnail& expected) {
  ASSERT_TRUE(seen) << sentence(seen.error());
  EXPECT_EQ(seen->plane, expected.plane);
  EXPECT_EQ(seen->width, expected.width);
  EXPECT_EQ(seen->height, expected.height);
  EXPECT_EQ(seen->grey, expected.grey);
}

std::string caseOf(const char* what, const Mat3& axes) {
  std::ostringstream name;
  name << what << "\n" << axes;
  return name.str();
}

TEST(Thumbnails, OfVolumesFollowTheConventionHoweverTheFileTurnsItsAxes) {
  const Workshop workshop;
  int pictures = 0;
  // in the patient's axes, and in a patient who lies askew: then by the nearest axes
  const Mat3 askew = Eigen::AngleAxisd(0.35, Vec3(1.0, 2.0, -1.5).normalized()).toRotationMatrix();
  for (const Mat3& axes : turned::orientations()) {
    const haptics::Grid grid = turned::gridAlong(axes);
    const auto voxels = turned::voxelsOf(grid, grain);
    haptics::Grid oblique = grid;
    oblique.direction = askew * axes;
    const int through = turned::patientAxisOf(axes, 2);
    const Thumbnail expected = expectedThrough(through);
    for (const auto& [what, bytes] :
         {std::pair{"LPS", turned::nrrdOf(grid, voxels)},
          std::pair{"RAS", turned::nrrdOf(grid, voxels, "right-anterior-superior", {-1, -1, 1})},
          std::pair{"oblique", turned::nrrdOf(oblique, voxels)}}) {
      SCOPED_TRACE(caseOf(what, axes));
      const auto found = survey(workshop.write("scan.nrrd", bytes));
      ASSERT_TRUE(found) << sentence(found.error());
      expectSame(thumbnailOf(found->series.front(), longestOf(wantedOf(through))), expected);
      ++pictures;
    }
  }
  EXPECT_EQ(pictures, 144);
}

// the third axis of a series runs along row x column: half of all orientations
TEST(Thumbnails, OfSeriesFollowTheConventionHoweverTheirSlicesLie) {
  int pictures = 0;
  for (const Mat3& axes : turned::orientations()) {
    if (axes.determinant() < 0.0) continue;
    SCOPED_TRACE(caseOf("DICOM", axes));
    const haptics::Grid grid = turned::gridAlong(axes);
    const auto voxels = turned::voxelsOf(grid, grain);
    const auto pixels = static_cast<std::ptrdiff_t>(grid.dims[0] * grid.dims[1]);
    const Workshop workshop;
    for (int k = 0; k < grid.dims[2]; ++k) {
      DicomSlice slice;
      slice.instance += "." + std::to_string(k + 1);
      slice.position_mm = 1e3 * grid.worldOf({0.0, 0.0, double(k)});
      slice.along_row = axes.col(0);
      slice.along_column = axes.col(1);
      slice.row_step_mm = slice.column_step_mm = turned::kStep_mm;
      slice.columns = int(grid.dims[0]);
      slice.rows = int(grid.dims[1]);
      slice.pixels.assign(voxels.begin() + k * pixels, voxels.begin() + (k + 1) * pixels);
      workshop.write(std::to_string(k), bytesOf(slice));
    }
    const auto found = survey(workshop.folder());
    ASSERT_TRUE(found) << sentence(found.error());
    ASSERT_EQ(found->series.size(), 1U);
    const int through = turned::patientAxisOf(axes, 2);
    expectSame(thumbnailOf(found->series.front(), longestOf(wantedOf(through))),
               expectedThrough(through));
    ++pictures;
  }
  EXPECT_EQ(pictures, 24);
}

TEST(Thumbnails, OfAFileThatDoesNotSayHowItLiesAreAsItIsStored) {
  const Workshop workshop;
  const haptics::Grid grid = turned::gridAlong(Mat3::Identity());
  const auto voxels = turned::voxelsOf(grid, grain);
  const auto found = survey(workshop.write("scan.nrrd", turned::nrrdOf(grid, voxels, "")));
  ASSERT_TRUE(found) << sentence(found.error());
  const auto small = thumbnailOf(found->series.front(), longestOf(wantedOf(2)));
  ASSERT_TRUE(small) << sentence(small.error());
  EXPECT_FALSE(small->plane);
  EXPECT_EQ(small->grey, expectedThrough(2).grey);
}

}  // namespace
}  // namespace datasets
