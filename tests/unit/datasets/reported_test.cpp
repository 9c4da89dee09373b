// SPDX-License-Identifier: BSD-3-Clause
// Small scans made after situations that people reported to other programs; tests/cases/reports
// says which.
#include <gtest/gtest.h>

#include <string>

#include "datasets/readers/volume_reader.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using testing::differing;
using testing::reasonFor;

fs::path reported(const std::string& name) { return places::source("tests/cases/reports/" + name); }

std::string saidOf(const fs::path& path) {
  const auto found = survey(path);
  return found ? sentence(found->series.front().message) : sentence(found.error());
}

/// The voxels and the geometry are those that all of one kind were made of.
void expectTruth(const fs::path& path, const Reading& reading = {}) {
  const auto truth = readVolume(reported("truth_18x14x9.nrrd"));
  ASSERT_TRUE(truth) << sentence(truth.error());
  const auto v = readVolume(path, reading);
  ASSERT_TRUE(v) << path.filename() << ": " << sentence(v.error());
  EXPECT_EQ(differing(*truth, *v), 0) << path.filename();
  const Eigen::Matrix3d axes = v->grid.direction.transpose() * truth->grid.direction;
  EXPECT_LT((v->grid.origin - truth->grid.origin).norm(), 1e-6) << path.filename();
  EXPECT_LT((v->grid.spacing - truth->grid.spacing).norm(), 2e-9) << path.filename();
  EXPECT_GT(axes.diagonal().cwiseAbs().minCoeff(), 0.999) << path.filename();
}

TEST(ReportedScans, OneScanIsOneSeries) {
  for (const char* name :
       {"acq_interleaved", "series_uid_per_slice", "nonimage_same_series", "thickness_comma"}) {
    expectTruth(reported(name));
    EXPECT_EQ(survey(reported(name))->series.size(), 1u) << name;
  }
  EXPECT_NE(saidOf(reported("acq_interleaved")).find("acquisition (2)"), std::string::npos);
  EXPECT_NE(saidOf(reported("series_uid_per_slice")).find("series (9)"), std::string::npos);
  EXPECT_NE(saidOf(reported("nonimage_same_series")).find("\"CSA\""), std::string::npos);
}

TEST(ReportedScans, OtherFormatsAreReadToo) {
  expectTruth(reported("nrrd_list_which/a.nhdr"));
  expectTruth(reported("archive_upper/A.TGZ"));
  // turned against the others: its voxels and steps are theirs
  const auto truth = readVolume(reported("truth_18x14x9.nrrd"));
  const auto v = readVolume(reported("nii_shear_0.1/a.nii"));
  ASSERT_TRUE(truth && v);
  EXPECT_EQ(differing(*truth, *v), 0);
  EXPECT_LT((v->grid.spacing - truth->grid.spacing).norm(), 2e-9);
  EXPECT_GT(v->grid.direction.determinant(), 0.0);
  const std::string said = saidOf(reported("nii_shear_0.1/a.nii"));
  EXPECT_NE(said.find("0.1 degrees off"), std::string::npos) << said;
}

TEST(ReportedScans, PhasesAreVolumes) {
  for (const char* name : {"phase_percent", "enh_cardiac", "enh_cardiac/E.dcm"}) {
    const auto found = survey(reported(name));
    ASSERT_TRUE(found) << sentence(found.error());
    ASSERT_EQ(found->series.size(), 3u) << name;
    for (const SeriesVerdict& series : found->series) {
      EXPECT_EQ(series.dims[2], 5) << name;
      const auto v = readVolume(series);
      EXPECT_TRUE(v) << sentence(v.error());
    }
    EXPECT_FALSE(found->series[1].part.empty()) << name;
  }
  EXPECT_NE(saidOf(reported("phase_percent")).find("phase 1 of 3 (10 %)"), std::string::npos)
      << saidOf(reported("phase_percent"));
}

TEST(ReportedScans, StepsThatDifferAreSaidForWhatTheyAre) {
  EXPECT_EQ(reasonFor(reported("uct_missing1")), "missing-slices");
  EXPECT_EQ(reasonFor(reported("head_25_5")), "uneven-spacing");
  const auto v = readVolume(reported("head_25_5"), {.geometry = Geometry::Corrected});
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_NEAR(1e3 * v->grid.spacing.z(), 2.5, 1e-9);
  EXPECT_EQ(v->grid.dims[2], 1 + 8 + 2 * 6);
  EXPECT_EQ(saidOf(reported("head_25_5")).find("missing"), std::string::npos)
      << saidOf(reported("head_25_5"));
}

}  // namespace
}  // namespace datasets
