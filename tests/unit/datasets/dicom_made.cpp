// SPDX-License-Identifier: BSD-3-Clause
// DICOM files made here, for what no scan at hand has.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "datasets/readers/volume_reader.h"
#include "tests/unit/datasets/dicom_bytes.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using testing::DicomSlice;
using testing::voxelAt;
using testing::Workshop;

std::string reasonFor(const fs::path& path) {
  const auto volume = readVolume(path);
  return volume ? "" : volume.error().reason;
}

/// Slices of one voxel, each its own image, at these heights; their value is their number.
void writeSlices(const Workshop& workshop, const std::vector<double>& heights_mm) {
  for (std::size_t k = 0; k < heights_mm.size(); ++k) {
    DicomSlice slice;
    slice.instance += "." + std::to_string(k + 1);
    slice.position_mm = {0, 0, heights_mm[k]};
    slice.pixels = {std::int16_t(k)};
    workshop.write(std::to_string(k), bytesOf(slice));
  }
}

TEST(DicomReader, ACopyOfASliceIsLeftOutAndSaid) {
  Workshop workshop;
  writeSlices(workshop, {0, 1, 2, 3});
  fs::copy_file(workshop.folder() / "2", workshop.folder() / "copy");
  const auto v = readVolume(workshop.folder());
  ASSERT_TRUE(v) << v.error().what;
  EXPECT_EQ(v->grid.dims[2], 4);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(voxelAt(*v, 0, 0, k), k);
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said);
  EXPECT_EQ(said->series.at(0).verdict, Verdict::Sound);
  EXPECT_EQ(said->series.at(0).reasons, std::vector<std::string>{"duplicate"});
  EXPECT_NE(said->series.at(0).message.find("1 other copy"), std::string::npos);
  // of a copy that is cut off the other is taken, whichever comes first
  fs::resize_file(workshop.folder() / "2", fs::file_size(workshop.folder() / "2") - 1);
  EXPECT_EQ(reasonFor(workshop.folder()), "");
}

TEST(DicomReader, TwoImagesAtOnePlaceAreNoStack) {
  Workshop workshop;
  writeSlices(workshop, {0, 1, 1});
  EXPECT_EQ(reasonFor(workshop.folder()), "duplicate");
  // but a file that is named stands for itself
  const auto v = readVolume(workshop.folder() / "2");
  ASSERT_TRUE(v) << v.error().what;
  EXPECT_EQ(voxelAt(*v, 0, 0, 1), 2.0);
}

TEST(DicomReader, PaddingCountsAsAir) {
  Workshop workshop;
  for (int k = 0; k < 2; ++k) {
    DicomSlice slice;
    slice.instance += "." + std::to_string(k + 1);
    slice.position_mm = {0, 0, double(k)};
    slice.columns = 3;
    slice.rows = 2;
    slice.intercept = -24.0;
    slice.pixels = {-1000, -2000, 50, -1990, 300, -2001};
    // a single value in one slice, a range in the other
    slice.padding =
        k == 0 ? std::vector<std::int16_t>{-2000} : std::vector<std::int16_t>{-2000, -1990};
    workshop.write(std::to_string(k), bytesOf(slice));
  }
  const auto v = readVolume(workshop.folder());
  ASSERT_TRUE(v) << v.error().what;
  EXPECT_EQ(v->padded, 3);
  EXPECT_EQ(v->unit, "HU");
  // -2001 is no padding: what is left is the least, and so the air
  const std::vector<double> first{-1024, -2025, 26, -2014, 276, -2025},
      second{-1024, -2025, 26, -2025, 276, -2025};
  for (int n = 0; n < 6; ++n) {
    EXPECT_EQ(voxelAt(*v, n % 3, n / 3, 0), first[std::size_t(n)]) << n;
    EXPECT_EQ(voxelAt(*v, n % 3, n / 3, 1), second[std::size_t(n)]) << n;
  }
}

TEST(DicomReader, PaddingThatTheVoxelsCannotHoldIsNoVoxel) {
  Workshop workshop;
  DicomSlice slice;
  slice.columns = 2;
  slice.intercept = 10.0;
  slice.pixels = {-10, 32757};
  slice.padding = {32760};  // beyond int16 once it is rescaled, and its end is a voxel
  const auto v = readVolume(workshop.write("a", bytesOf(slice)));
  ASSERT_TRUE(v) << v.error().what;
  EXPECT_EQ(v->padded, 0);
  EXPECT_EQ(voxelAt(*v, 1, 0, 0), 32767.0);
  // where all is padding nothing is known to be air
  slice.series += ".2";
  slice.pixels = {7, 7};
  slice.padding = {7};
  const auto all = readVolume(workshop.write("b", bytesOf(slice)));
  ASSERT_TRUE(all) << all.error().what;
  EXPECT_EQ(all->padded, 0);
  EXPECT_EQ(voxelAt(*all, 1, 0, 0), 17.0);
}

}  // namespace
}  // namespace datasets
