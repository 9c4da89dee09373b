// SPDX-License-Identifier: BSD-3-Clause
// The slices of a cohort's pages follow the convention of the window's, however a file turns its
// axes: each is held to what the patient's places say.
#include "app/study/cohort/slice_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "tests/support/turned_scan.h"

namespace {

using haptics::Mat3;
using haptics::Vec3;

constexpr int kPixels = 256;  // of a side
const Vec3 kSlopes{10.0, 25.0, 60.0};

/// Grows towards L, P and S, each at its own rate.
double rampAt(const Vec3& p_mm) { return kSlopes.dot(p_mm - turned::kFirst_mm); }

haptics::Volume rampAlong(const Mat3& axes) {
  const haptics::Grid grid = turned::gridAlong(axes);
  const auto values = turned::voxelsOf(
      grid, [](const Vec3& p_mm) { return static_cast<std::int16_t>(std::lround(rampAt(p_mm))); });
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16).value();
  std::memcpy(voxels.get(), values.data(), 2 * values.size());
  return haptics::makeVolume(grid, haptics::ScalarType::Int16, std::move(voxels)).value();
}

/// How a plane is shown: which of L, P and S the picture's columns and rows follow, and whether its
/// rows run against it.
struct Shown {
  const char* plane;
  int across, down;
  double down_sign;
};
constexpr Shown kShown[] = {
    {"axial", 0, 1, 1.0}, {"coronal", 0, 2, -1.0}, {"sagittal", 1, 2, -1.0}};

TEST(CohortSlices, FollowTheConventionHoweverTheFileTurnsItsAxes) {
  const Vec3 size = turned::kStep_mm *
                    (Vec3(turned::kSize[0], turned::kSize[1], turned::kSize[2]) - Vec3::Ones());
  const Vec3 middle = turned::kFirst_mm + 0.5 * size;
  const Vec3 place = middle + Vec3(1.0, -2.0, 3.0);
  int looked = 0;
  for (const Mat3& axes : turned::orientations()) {
    const haptics::Volume volume = rampAlong(axes);
    // a surface that is nowhere, which would be drawn over the values
    const auto pictures = cohort::slicesThrough(volume, 1e6, 1e-3 * place);
    for (std::size_t n = 0; n < 3; ++n) {
      const Shown& shown = kShown[n];
      ASSERT_EQ(pictures[n].plane, shown.plane);
      const std::string& bytes = pictures[n].bitmap;
      const std::size_t begin = bytes.size() - std::size_t{kPixels} * kPixels;
      for (int y = 3; y < kPixels; y += 25)
        for (int x = 3; x < kPixels; x += 25) {
          Vec3 p = place;
          p[shown.across] = middle[shown.across] + size.maxCoeff() * ((x + 0.5) / kPixels - 0.5);
          p[shown.down] =
              middle[shown.down] + shown.down_sign * size.maxCoeff() * ((y + 0.5) / kPixels - 0.5);
          if (((p - middle).cwiseAbs() - 0.5 * size).maxCoeff() > -0.5) continue;  // at the rim
          const double grey = 254.0 * (rampAt(p) - volume.least) / (volume.greatest - volume.least);
          const auto at = begin + static_cast<std::size_t>(y * kPixels + x);
          const auto seen = static_cast<unsigned char>(bytes[at]);
          if (seen == 255) continue;  // the cross
          ASSERT_NEAR(seen, grey, 1.0) << shown.plane << " " << x << " " << y << "\n" << axes;
          ++looked;
        }
    }
  }
  EXPECT_GT(looked, 48 * 3 * 30);
}

}  // namespace
