// SPDX-License-Identifier: BSD-3-Clause
// The verdict on a stack, from positions and orientations alone.
#include "datasets/readers/dicom/stack.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "datasets/readers/dicom/straighten.h"
#include "tests/support/sentence.h"

namespace datasets {
namespace {

using haptics::Vec3;

/// Slices at the given heights of an oblique stack with unequal pixel spacing.
std::vector<SlicePlane> stack(const std::vector<double>& heights_mm, double tilt_deg = 0.0) {
  const Eigen::Quaterniond turn =
      Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()) * Eigen::Quaterniond::Identity();
  const Vec3 row = turn * Vec3::UnitX(), column = turn * Vec3::UnitY(),
             normal = turn * Vec3::UnitZ();
  std::vector<SlicePlane> slices;
  for (const double h : heights_mm) {
    SlicePlane s;
    s.position_mm =
        Vec3(10, -20, 30) + normal * h + column * h * std::tan(tilt_deg * std::numbers::pi / 180.0);
    s.along_row = row;
    s.along_column = column;
    s.column_step_mm = 0.6;
    s.row_step_mm = 0.7;
    s.columns = 8;
    s.rows = 9;
    slices.push_back(s);
  }
  return slices;
}

std::string reasonForStack(const std::vector<SlicePlane>& slices) {
  const auto verdict = stackOf(slices);
  return verdict ? "" : verdict.error().reason;
}

/// The reason for which a stack has to be straightened; "no" where it has not, or cannot.
std::string crookedFor(const std::vector<SlicePlane>& slices) {
  const auto verdict = stackOf(slices);
  return verdict && verdict->crooked ? verdict->crooked->why.reason : "no";
}

TEST(DicomSeries, ShuffledSlicesAreOrderedAlongTheNormal) {
  auto slices = stack({0, 1.25, 2.5, 3.75, 5, 6.25});
  std::shuffle(slices.begin(), slices.end(), std::mt19937(3));
  const auto verdict = stackOf(slices);
  ASSERT_TRUE(verdict) << sentence(verdict.error());
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const auto grid = gridOf(verdict->geometry);
    ASSERT_TRUE(grid);
    const Vec3 where_mm = 1e3 * grid->worldOf({0, 0, static_cast<double>(k)});
    EXPECT_LT((where_mm - slices[verdict->order[k]].position_mm).norm(), 1e-9) << k;
  }
}

TEST(DicomSeries, ColumnsGoAlongRowsAndRowsDownColumns) {
  const auto slices = stack({0, 2});
  const auto grid = gridOf(stackOf(slices)->geometry);
  ASSERT_TRUE(grid);
  const SlicePlane& s = slices.front();
  // the voxel in column 3 and row 5, by the standard's own equation (C.7.6.2.1-1)
  const Vec3 expected_mm =
      s.position_mm + 3 * s.column_step_mm * s.along_row + 5 * s.row_step_mm * s.along_column;
  EXPECT_LT((1e3 * grid->worldOf({3, 5, 0}) - expected_mm).norm(), 1e-9);
  EXPECT_EQ(grid->dims[0], 8);
  EXPECT_EQ(grid->dims[1], 9);
}

TEST(DicomSeries, TheLongestRunLiesBetweenTwoGaps) {
  using Indices = std::vector<std::size_t>;
  EXPECT_EQ(longestRun(stack({0, 1, 2, 4, 5, 6, 7, 9, 10})), (Indices{3, 4, 5, 6}));
  EXPECT_EQ(longestRun(stack({7, 0, 5, 1, 6, 4, 2, 9, 10})), (Indices{5, 2, 4, 0}));  // shuffled
  EXPECT_EQ(longestRun(stack({0, 1, 2, 4, 5, 6})), (Indices{0, 1, 2}));  // of two the lowest
  // every second slice missing is a gap too, however evenly
  EXPECT_EQ(longestRun(stack({0, 1, 2, 3, 5, 7, 9, 10, 11})), (Indices{0, 1, 2, 3}));
  EXPECT_EQ(longestRun({}), Indices{});
}

TEST(DicomSeries, RefusesByName) {
  EXPECT_EQ(reasonForStack(stack({0, 1, 2, 4, 5, 6})), "missing-slices");
  EXPECT_EQ(reasonForStack(stack({0, 1, 2, 5, 6, 7})), "missing-slices");
  EXPECT_EQ(reasonForStack(stack({0, 1, 2, 3, 12.5, 14})), "uneven-spacing");
  EXPECT_EQ(reasonForStack(stack({0, 1, 2, 2, 3})), "duplicate");
  EXPECT_EQ(reasonForStack(stack({0, 1, 2, 3}, 50.0)), "sheared");
  EXPECT_EQ(reasonForStack(stack({0, 1, 3, 4}, 12.0)), "missing-slices");
  // as far apart as no memory would hold, and farther than numbers of pixels go
  EXPECT_EQ(reasonForStack(stack({0, 1e6}, 30.0)), "sheared");
  EXPECT_EQ(reasonForStack(stack({0, 1e100}, 30.0)), "sheared");
  EXPECT_EQ(reasonForStack({}), "no-pixels");

  auto turned = stack({0, 1, 2, 3});
  turned[2].along_column =
      Eigen::AngleAxisd(0.003, turned[2].along_row) * turned[2].along_column;  // 0.17 degrees
  EXPECT_EQ(reasonForStack(turned), "mixed-orientation");

  auto sized = stack({0, 1, 2});
  sized[1].rows = 10;
  EXPECT_EQ(reasonForStack(sized), "mixed-size");
  auto spaced = stack({0, 1, 2});
  spaced[1].row_step_mm = 0.71;
  EXPECT_EQ(reasonForStack(spaced), "mixed-size");
  auto aside = stack({0, 1, 2});
  aside[1].position_mm += 0.3 * aside[1].along_row;
  EXPECT_EQ(reasonForStack(aside), "sheared");
  auto broken = stack({0, 1, 2});
  broken[1].along_row = Vec3::Zero();
  EXPECT_EQ(reasonForStack(broken), "bad-header");
  broken = stack({0, 1, 2});
  broken[1].position_mm.x() = std::nan("");
  EXPECT_EQ(reasonForStack(broken), "bad-header");
}

TEST(DicomSeries, StepsMayWanderByOnePercentOrATwentiethOfAMillimetre) {
  EXPECT_EQ(crookedFor(stack({0, 1, 2.04, 3.0, 4})), "no");
  EXPECT_EQ(crookedFor(stack({0, 1, 2.06, 3.12, 4})), "uneven-spacing");
  EXPECT_EQ(crookedFor(stack({0, 10, 20.09, 30, 40})), "no");
  EXPECT_EQ(crookedFor(stack({0, 10, 20.11, 30, 40})), "uneven-spacing");
}

std::vector<double> scaled(std::vector<double> heights_mm, double factor) {
  for (double& height : heights_mm) height *= factor;
  return heights_mm;
}

// planted: steps that may be off by 0.05 mm whatever their size
TEST(DicomSeries, WhatCountsAsEvenGoesWithTheStep) {
  for (const double step_mm : {0.0008, 0.018, 0.5, 3.0}) {
    EXPECT_EQ(reasonForStack(stack(scaled({0, 1, 2, 3, 5, 6, 7}, step_mm))), "missing-slices")
        << step_mm;
    EXPECT_EQ(reasonForStack(stack(scaled({0, 1, 2, 2.0001, 3}, step_mm))), "duplicate") << step_mm;
    EXPECT_EQ(crookedFor(stack(scaled({0, 1, 2, 3, 4}, step_mm))), "no") << step_mm;
    EXPECT_EQ(crookedFor(stack(scaled({0, 1, 2.2, 3, 4}, step_mm))), "uneven-spacing") << step_mm;
  }
}

// planted: steps that are judged one by one only
TEST(DicomSeries, ADriftIsSeenThoughEachStepIsNearTheUsualOne) {
  std::vector<double> heights_mm{0.0};
  for (int k = 0; k < 60; ++k) heights_mm.push_back(heights_mm.back() + (k < 30 ? 1.01 : 0.99));
  EXPECT_EQ(crookedFor(stack(heights_mm)), "uneven-spacing");
  EXPECT_NE(sentence(stackOf(stack(heights_mm))->crooked->why).find("drift"), std::string::npos);
  EXPECT_EQ(crookedFor(stack({0, 1.01, 2.02, 3.01, 4})), "no");
}

/// Slices at heights that are written with so many decimals.
std::vector<SlicePlane> written(double step_mm, int count, int decimals) {
  const double quantum_mm = std::pow(10.0, -decimals);
  std::vector<SlicePlane> slices;
  for (int k = 0; k < count; ++k) {
    SlicePlane s;
    s.position_mm = {-41.5, -60.2, std::round((-210.07 + step_mm * k) / quantum_mm) * quantum_mm};
    s.columns = s.rows = 4;
    slices.push_back(s);
  }
  return slices;
}

TEST(DicomSeries, WhatWritingRoundsIsEven) {
  for (const double step_mm : {0.25, 0.33, 0.625, 1.25, 0.6667})
    EXPECT_EQ(crookedFor(written(step_mm, 40, 1)), "no") << step_mm;
  EXPECT_EQ(crookedFor(written(0.0333, 40, 2)), "no");
  auto lacking = written(0.33, 40, 1);
  lacking.erase(lacking.begin() + 20);
  EXPECT_EQ(reasonForStack(lacking), "missing-slices");
  for (const double step_mm : {0.625, 0.75, 1.25}) {
    lacking = written(step_mm, 30, 1);
    lacking.erase(lacking.begin() + 11);
    EXPECT_EQ(reasonForStack(lacking), "missing-slices") << step_mm;
    EXPECT_EQ(longestRun(lacking).size(), 18u) << step_mm;
  }
}

TEST(DicomSeries, TwoRegularStepsCanBeResampled) {
  const auto heights = [](int below, double low_mm, int above, double high_mm) {
    std::vector<double> heights_mm{0.0};
    for (int k = 0; k < below + above; ++k)
      heights_mm.push_back(heights_mm.back() + (k < below ? low_mm : high_mm));
    return heights_mm;
  };
  for (const auto& [below, low_mm, above, high_mm] :
       {std::tuple{9, 2.5, 6, 5.0}, std::tuple{6, 5.0, 9, 2.5}, std::tuple{5, 5.0, 3, 2.5},
        std::tuple{4, 1.0, 8, 5.0}}) {
    const auto verdict = stackOf(stack(heights(below, low_mm, above, high_mm)));
    ASSERT_TRUE(verdict) << sentence(verdict.error());
    ASSERT_TRUE(verdict->crooked);
    EXPECT_EQ(verdict->crooked->why.reason, "uneven-spacing");
    EXPECT_NEAR(verdict->geometry.steps_mm.col(2).norm(), std::min(low_mm, high_mm), 1e-9);
  }
  // two that are missing are missing
  EXPECT_EQ(reasonForStack(stack({0, 1, 2, 3, 4, 5, 7, 9})), "missing-slices");
}

TEST(DicomSeries, TiltedAndUnevenStacksCanBeStraightened) {
  EXPECT_EQ(crookedFor(stack({0, 1, 2, 3.5, 4.5, 5.5})), "uneven-spacing");
  EXPECT_EQ(crookedFor(stack({0, 1, 2, 3, 6.5, 8})), "uneven-spacing");
  EXPECT_EQ(crookedFor(stack({0, 1, 2, 3}, 0.2)), "gantry-tilt");
  EXPECT_EQ(crookedFor(stack({0, 1, 2, 3}, 0.05)), "no");
  EXPECT_EQ(crookedFor(stack({0, 1, 2, 3.5}, -20.0)), "gantry-tilt");
  const auto verdict = stackOf(stack({0, 1, 2, 3}, 12.0));
  ASSERT_TRUE(verdict);
  const std::string why = sentence(verdict->crooked->why);
  EXPECT_NE(why.find("12 degrees"), std::string::npos) << why;
}

// linear interpolation keeps what is linear: wherever slices reach, the straightened box has the
// value of its place in the patient, and elsewhere the least of all
TEST(DicomSeries, WhatIsLinearInThePatientStaysSo) {
  const std::vector<std::vector<double>> heights{{0, 1, 2, 3, 4}, {0, 1, 2.5, 3.5, 4.2}};
  for (const double tilt : {0.0, 16.5, -30.0})
    for (const auto& at : heights) {
      const bool even = at == heights.front();
      if (even && tilt == 0.0) continue;
      auto slices = stack(at, tilt);
      std::shuffle(slices.begin(), slices.end(), std::mt19937(5));
      const auto made = stackOf(slices);
      ASSERT_TRUE(made && made->crooked);
      const auto grid = gridOf(made->geometry);
      ASSERT_TRUE(grid);
      const auto linear = [](const Vec3& p_mm) { return 500.0 + p_mm.dot(Vec3(3, -2, 7)); };
      std::vector<float> voxels;
      for (const std::size_t index : made->order) {
        const SlicePlane& s = slices[index];
        for (std::int64_t row = 0; row < s.rows; ++row)
          for (std::int64_t column = 0; column < s.columns; ++column)
            voxels.push_back(
                float(linear(s.position_mm + double(column) * s.column_step_mm * s.along_row +
                             double(row) * s.row_step_mm * s.along_column)));
      }
      const float least = *std::min_element(voxels.begin(), voxels.end());
      std::vector<float> box(std::size_t(grid->voxelCount()));
      ASSERT_TRUE(straighten(*made, haptics::ScalarType::Float32, voxels.data(), box.data(), {}));
      const SlicePlane& low = slices[made->order.front()];
      std::int64_t reached = 0, n = 0;
      for (std::int64_t k = 0; k < grid->dims[2]; ++k)
        for (std::int64_t j = 0; j < grid->dims[1]; ++j)
          for (std::int64_t i = 0; i < grid->dims[0]; ++i, ++n) {
            const Vec3 p_mm = 1e3 * grid->worldOf({double(i), double(j), double(k)});
            if (box[std::size_t(n)] == least) continue;
            ++reached;
            EXPECT_NEAR(box[std::size_t(n)], linear(p_mm), 1e-3) << i << " " << j << " " << k;
          }
      // all columns, and all rows but the one that a slice between two pixels loses, and those
      // that only one of the two slices beside a plane has
      EXPECT_GE(reached, (low.columns - 1) * (low.rows - 3) * grid->dims[2]) << tilt;
      // the first slice keeps its pixels
      const Vec3 corner = grid->indexOf(1e-3 * low.position_mm);
      EXPECT_LT((corner - Vec3(corner.array().round())).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace datasets
