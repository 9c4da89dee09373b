// SPDX-License-Identifier: BSD-3-Clause
// DICOM that others made. The same faults are looked for in made files: see dicom_folders_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <regex>

#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;
using testing::differing;
using testing::reasonFor;
using testing::scan;
using testing::voxelAt;
using testing::Workshop;

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(RealScans, HeadSlabIsTheSameRegionOfTheHead) {
  const fs::path slab_path = scan("visible_human_female_head/dicom_slab");
  const fs::path head_path = scan("visible_human_female_head/vhf_head_512x512x234.nrrd");
  NEEDS_SCAN(slab_path);
  NEEDS_SCAN(head_path);
  const auto slab = readVolume(slab_path);
  ASSERT_TRUE(slab) << sentence(slab.error());
  const auto head = readVolume(head_path);
  ASSERT_TRUE(head) << sentence(head.error());

  EXPECT_EQ(slab->grid.dims, (std::array<std::int64_t, 3>{512, 512, 32}));
  EXPECT_EQ(slab->type, ScalarType::Int16);
  EXPECT_EQ(slab->unit, "HU");
  EXPECT_EQ(slab->modality, "CT");
  EXPECT_EQ(head->unit, "HU");
  EXPECT_EQ(head->least, -1024);
  EXPECT_EQ(head->greatest, 3063);
  // every corner of the slab lies on a voxel of the head, z 1580 on its slice 80
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(511, 0, 0), Vec3(0, 511, 0), Vec3(0, 0, 31)}) {
    const Vec3 in_head = head->grid.indexOf(slab->grid.worldOf(corner));
    EXPECT_LT((in_head - (corner + Vec3(0, 0, 80))).norm(), 1e-9) << in_head.transpose();
  }
  std::int64_t unequal = 0;
  for (std::int64_t k = 0; k < 32; ++k)
    for (std::int64_t j = 0; j < 512; ++j)
      for (std::int64_t i = 0; i < 512; ++i)
        unequal += voxelAt(*slab, i, j, k) != voxelAt(*head, i, j, k + 80) ? 1 : 0;
  EXPECT_EQ(unequal, 0);
}

TEST(RealScans, NamesDoNotOrderTheSlices) {
  const fs::path folder = scan("visible_human_female_head/dicom_slab");
  NEEDS_SCAN(folder);
  const auto files = filesIn(folder);
  Workshop workshop;
  for (std::size_t i = 0; i < files.size(); ++i)
    workshop.copy(files[i], std::to_string(100 + (i * 13) % files.size()));
  const auto named = readVolume(folder), renamed = readVolume(workshop.folder());
  ASSERT_TRUE(named && renamed);
  EXPECT_EQ(renamed->grid.origin, named->grid.origin);
  EXPECT_EQ(differing(*named, *renamed), 0);
}

TEST(RealScans, OneFileStandsForItsSeries) {
  const fs::path folder = scan("visible_human_female_head/dicom_slab");
  NEEDS_SCAN(folder);
  const auto whole = readVolume(folder);
  const auto by_file = readVolume(filesIn(folder).at(7));
  ASSERT_TRUE(whole && by_file);
  EXPECT_EQ(differing(*whole, *by_file), 0);
  EXPECT_FALSE(survey(filesIn(folder).at(7))->several);
}

TEST(RealScans, PhantomOfOneMillimetre) {
  const fs::path path = scan("philips_head_phantom/bone_1mm");
  NEEDS_SCAN(path);
  const auto v = readVolume(path);
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->grid.dims, (std::array<std::int64_t, 3>{512, 512, 48}));
  EXPECT_LT((1e3 * v->grid.spacing - Vec3(0.451171875, 0.451171875, 1)).norm(), 1e-12);
  EXPECT_LT((1e3 * v->grid.origin - Vec3(-115.5, -1.85, 694.21)).norm(), 1e-9);
  EXPECT_EQ(v->type, ScalarType::Int16);
  EXPECT_EQ(v->least, -1024);
  EXPECT_EQ(v->greatest, 3071);
  EXPECT_EQ(v->unit, "HU");
  const auto said = survey(path);
  ASSERT_TRUE(said);
  EXPECT_TRUE(said->several);
  ASSERT_EQ(said->series.size(), 1u);
  EXPECT_EQ(said->series[0].verdict, Verdict::Sound);
}

TEST(RealScans, UnequalPixelsAndFractionalRescale) {
  const fs::path path = scan("dicom_oddities/series_non_isotropic_slope");
  NEEDS_SCAN(path);
  const auto v = readVolume(path);
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->grid.dims, (std::array<std::int64_t, 3>{64, 28, 4}));
  EXPECT_NEAR(1e3 * v->grid.spacing.x(), 6.4, 1e-3);
  EXPECT_NEAR(1e3 * v->grid.spacing.y(), 4.0, 1e-3);
  EXPECT_EQ(v->type, ScalarType::Float32);
  EXPECT_EQ(v->unit, "");
}

TEST(RealScans, DicomIsRefusedByName) {
  const std::map<std::string, std::string> expected = {
      {"philips_head_phantom/gantry_tilt_16.5deg", "gantry-tilt"},
      {"dicom_oddities/series_failing/gantrytilting", "gantry-tilt"},
      {"dicom_oddities/series_failing/sliceincrement", "missing-slices"},
      // two protocols of two slices each
      {"dicom_oddities/series_failing/sliceorientation", "which-series"},
      {"dicom_oddities/series_rgb", "not-scalar"},
      {"dicom_oddities/multiframe/emri_small.dcm", "bad-header"},
      {"dicom_oddities/pydicom/badVR.dcm", "bad-header"},
      {"dicom_oddities/pydicom/rtdose.dcm", "bad-header"},
      {"dicom_oddities/pydicom/MR_truncated.dcm", "truncated"},
      {"dicom_oddities/pydicom/rtstruct.dcm", "no-pixels"},
      {"dicom_oddities/pydicom/image_dfl.dcm", "bad-header"},
      {"dicom_oddities/transfer_syntaxes/no-pixel-data.dcm", "no-pixels"},
      {"dicom_oddities/fo_dicom/CR-MONO1-10-chest", "bad-header"},
      {"dicom_oddities/fo_dicom/LICENSE.txt", "unreadable"}};
  for (const auto& [name, reason] : expected) {
    NEEDS_SCAN(scan(name));
    EXPECT_EQ(reasonFor(scan(name)), reason) << name;
  }
  EXPECT_EQ(reasonFor("/no/such/folder"), "unreadable");
}

/// What a slice has at a place in the world, linear between its pixels; NaN beyond them.
double valueIn(const haptics::Volume& slice, const Vec3& p_W) {
  const Vec3 at = slice.grid.indexOf(p_W);
  const Vec3 low = (at.array() + 1e-6).floor();
  double value = 0.0;
  for (int dj = 0; dj < 2; ++dj)
    for (int di = 0; di < 2; ++di) {
      const double share_i = std::abs(1.0 - di - (at.x() - low.x())),
                   share_j = std::abs(1.0 - dj - (at.y() - low.y()));
      if (share_i * share_j < 1e-9) continue;
      const auto i = std::int64_t(low.x()) + di, j = std::int64_t(low.y()) + dj;
      if (i < 0 || j < 0 || i >= slice.grid.dims[0] || j >= slice.grid.dims[1])
        return std::numeric_limits<double>::quiet_NaN();
      value += share_i * share_j * voxelAt(slice, i, j, 0);
    }
  return value;
}

// every slice read alone, and looked up at the places that the corrected volume says it has
TEST(RealScans, ATiltedSeriesIsStraightenedIfTheUserAgrees) {
  const fs::path path = scan("philips_head_phantom/gantry_tilt_16.5deg");
  NEEDS_SCAN(path);
  const auto said = survey(path);
  ASSERT_TRUE(said);
  ASSERT_EQ(said->series.size(), 1u);
  EXPECT_EQ(said->series[0].verdict, Verdict::Correctable);
  EXPECT_EQ(said->series[0].reasons, std::vector<std::string>{"gantry-tilt"});
  EXPECT_NE(sentence(said->series[0].message).find("16.5 degrees"), std::string::npos);
  const auto as_stored = readVolume(path);
  ASSERT_FALSE(as_stored);
  EXPECT_EQ(as_stored.error().kind, haptics::Error::Kind::Correctable);

  const auto corrected = readVolume(path, {.geometry = Geometry::Corrected});
  ASSERT_TRUE(corrected) << sentence(corrected.error());
  EXPECT_TRUE(corrected->resampled);
  const haptics::Grid& grid = corrected->grid;
  EXPECT_EQ(grid.dims[0], 512);
  EXPECT_GT(grid.dims[1], 512);
  EXPECT_EQ(grid.dims[2], 24);
  // 2.5 mm along the table, less along the normal
  EXPECT_NEAR(1e3 * grid.spacing.z(), 2.5 * std::cos(16.5 * std::numbers::pi / 180.0), 1e-3);

  std::vector<haptics::Volume> slices;
  for (const fs::path& file : filesIn(path)) {
    Workshop workshop;
    auto slice = readVolume(workshop.copy(file));
    ASSERT_TRUE(slice) << sentence(slice.error());
    slices.push_back(std::move(*slice));
  }
  std::sort(slices.begin(), slices.end(), [&](const auto& a, const auto& b) {
    return grid.indexOf(a.grid.origin).z() < grid.indexOf(b.grid.origin).z();
  });
  double off = 0.0;
  std::int64_t compared = 0;
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; j += 3)
      for (std::int64_t i = 0; i < grid.dims[0]; i += 3) {
        const Vec3 p_W = grid.worldOf({double(i), double(j), double(k)});
        const double expected = valueIn(slices[std::size_t(k)], p_W);
        if (std::isnan(expected)) continue;
        ++compared;
        off = std::max(off, std::abs(voxelAt(*corrected, i, j, k) - expected));
      }
  EXPECT_GT(compared, 24 * 170 * 170);
  EXPECT_LT(off, 0.51);  // rounding to whole numbers
}

// the frames' positions are those that another DICOM toolkit prints; one of the files has private
// copies of them that are half a pixel off
TEST(RealScans, EnhancedFramesLieWhereTheirGroupsSay) {
  struct Said {
    const char* name;
    std::vector<Vec3> positions_mm;  // in the order of the file
    Vec3 spacing_mm;
  };
  const Said all[] = {{"eCT_Supplemental.dcm",
                       {{99.5, -301.5, -159}, {99.5, -301.5, -149}},
                       {0.388672, 0.388672, 10}},
                      {"philips_enhanced_mr.dcm",
                       {{100.293579101562, -150.60459327697, 116.949243545532},
                        {99.0935668945312, -150.60459327697, 116.949243545532},
                        {97.8935699462890, -150.60459327697, 116.949243545532},
                        {96.6935577392578, -150.60459327697, 116.949243545532},
                        {95.4935607910156, -150.60459327697, 116.949243545532},
                        {94.2935485839843, -150.60459327697, 116.949243545532},
                        {93.0935516357421, -150.60459327697, 116.949243545532},
                        {91.8935394287109, -150.60459327697, 116.949243545532}},
                       {1, 1, 1.2}},
                      {"siemens_xa_enhanced_mr.dcm",
                       {{-117.018, -101.63, -100.577},
                        {-117.054, -101.65, -99.6781},
                        {-117.091, -101.67, -98.7791},
                        {-117.127, -101.689, -97.88},
                        {-117.164, -101.709, -96.981},
                        {-117.2, -101.729, -96.0819},
                        {-117.237, -101.749, -95.1829},
                        {-117.273, -101.768, -94.2838}},
                       {0.9375, 0.9375, 0.9}}};
  for (const Said& said : all) {
    const fs::path path = scan("dicom_oddities/multiframe") / said.name;
    NEEDS_SCAN(path);
    const auto v = readVolume(path);
    ASSERT_TRUE(v) << said.name << ": " << sentence(v.error());
    const auto frames = std::int64_t(said.positions_mm.size());
    EXPECT_EQ(v->grid.dims[2], frames);
    EXPECT_LT((1e3 * v->grid.spacing - said.spacing_mm).norm(), 2e-3) << said.name;
    // stored as they are, at the end of the file
    std::ifstream file(path, std::ios::binary);
    const std::int64_t pixels = v->grid.dims[0] * v->grid.dims[1];
    file.seekg(-2 * pixels * frames, std::ios::end);
    const auto slope = said.name[0] == 'p' ? 4.25885225885225 : 1.0;
    const auto intercept = said.name[0] == 'e' ? -1024.0 : 0.0;
    for (std::int64_t n = 0; n < frames; ++n) {
      const Vec3 index = v->grid.indexOf(1e-3 * said.positions_mm[std::size_t(n)]);
      EXPECT_LT(index.head<2>().norm(), 0.05) << said.name << " " << index.transpose();
      const std::int64_t k = std::lround(index.z());
      EXPECT_NEAR(index.z(), double(k), 0.01);
      std::vector<std::uint16_t> stored(std::size_t(pixels), 0);
      file.read(reinterpret_cast<char*>(stored.data()), 2 * pixels);
      std::int64_t unequal = 0;
      for (std::int64_t p = 0; p < pixels; ++p) {
        const double expected = slope * stored[std::size_t(p)] + intercept;
        unequal += std::abs(voxelAt(*v, p % v->grid.dims[0], p / v->grid.dims[0], k) - expected) >
                   1e-6 * std::abs(expected);
      }
      EXPECT_EQ(unequal, 0) << said.name << ", frame " << n;
    }
  }
}

TEST(RealScans, LosslessSyntaxesGiveEqualVoxels) {
  const fs::path folder = scan("dicom_oddities/transfer_syntaxes");
  NEEDS_SCAN(folder);
  // name fragment, and how far its voxels may be off; -1: refused by its syntax
  const std::vector<std::pair<std::string, double>> expected = {
      {"LittleEndianImplicit", 0}, {"BigEndianExplicit", 0},
      {"RLELossless", 0},          {"JPEGProcess14SV1", 0},
      {"JPEGProcess14Tr", 0},      {"JPEGLSLossless", 0},
      {"JPEG2000LosslessOnly", 0}, {"JPEG2000Transfer", 5},
      {"JPEGLSLossyT", 5},         {"Deflated", 0},
      {"JPEGProcess10_12", -1},    {"JPEGProcess6_8", -1}};
  Workshop workshop;
  std::optional<haptics::Volume> plain;
  const auto alone = [&](const std::string& fragment) {
    for (const fs::path& file : filesIn(folder))
      if (file.filename().string().find("CTImage_" + fragment) == 0)
        return workshop.copy(file, fragment + "/slice.dcm").parent_path();
    ADD_FAILURE() << "no file for " << fragment;
    return fs::path();
  };
  plain = *readVolume(alone("LittleEndianExplicit"));
  // stored -2000 to 2402, intercept -1024
  EXPECT_EQ(plain->least, -3024);
  EXPECT_EQ(plain->greatest, 1378);
  for (const auto& [fragment, tolerance] : expected) {
    const auto v = readVolume(alone(fragment));
    if (tolerance < 0) {
      ASSERT_FALSE(v) << fragment;
      EXPECT_EQ(v.error().reason, "unsupported-syntax") << fragment;
    } else {
      ASSERT_TRUE(v) << fragment << ": " << sentence(v.error());
      EXPECT_EQ(differing(*plain, *v, tolerance), 0) << fragment;
    }
  }
}

TEST(RealScans, MixedFolderListsItsSeries) {
  const fs::path folder = scan("philips_head_phantom/mixed_series_one_folder");
  NEEDS_SCAN(folder);
  const auto said = survey(folder);
  ASSERT_TRUE(said) << sentence(said.error());
  std::map<std::string, int> verdicts;
  int stacks = 0;
  for (const SeriesVerdict& s : said->series) {
    stacks += s.verdict == Verdict::Sound ? 1 : 0;
    if (s.verdict != Verdict::Sound) ++verdicts[s.reasons.at(0)];
    EXPECT_EQ(s.dims[2], s.verdict == Verdict::Sound ? 4 : 1);
  }
  EXPECT_EQ(stacks, 2);
  EXPECT_EQ(verdicts["localizer"], 1);
  EXPECT_EQ(verdicts["not-scalar"], 1);
  const auto open = readVolume(folder);
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().reason, "which-series");
  EXPECT_EQ(reasonFor(folder / "IM0001"), "");
  // two kernels at the same positions: equal places, unequal voxels
  const auto first = readVolume(folder, {.series = 1}), second = readVolume(folder, {.series = 2});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->grid.origin, second->grid.origin);
  EXPECT_GT(differing(*first, *second), 100000);
  EXPECT_EQ(readVolume(folder, {.series = 99}).error().reason, "no-such-series");
}

TEST(RealScans, DamagedFoldersAreRefused) {
  const fs::path folder = scan("philips_head_phantom/bone_1mm");
  NEEDS_SCAN(folder);
  const auto files = filesIn(folder);
  Workshop workshop;
  for (std::size_t i = 0; i < 9; ++i) workshop.copy(files[i], "whole/" + std::to_string(i));
  const fs::path whole = workshop.folder() / "whole";
  fs::copy(whole, workshop.folder() / "cut");
  fs::resize_file(workshop.folder() / "cut" / "5", fs::file_size(whole / "5") - 1000);
  EXPECT_EQ(reasonFor(workshop.folder() / "cut"), "truncated");
  fs::create_directories(workshop.folder() / "empty");
  EXPECT_EQ(reasonFor(workshop.folder() / "empty"), "unreadable");
}

TEST(RealScans, AMissingSliceIsSeen) {
  const fs::path folder = scan("visible_human_female_head/dicom_slab");
  NEEDS_SCAN(folder);
  Workshop workshop;
  const auto files = filesIn(folder);
  for (std::size_t i = 0; i < files.size(); ++i)
    if (i != 11) workshop.copy(files[i]);
  const auto v = readVolume(workshop.folder());
  ASSERT_FALSE(v);
  EXPECT_EQ(v.error().reason, "missing-slices");
  EXPECT_NE(sentence(v.error()).find("1 slice is missing"), std::string::npos)
      << sentence(v.error());
}

TEST(RealScans, SentencesHoldNoIdentifiers) {
  for (const char* name : {"philips_head_phantom/gantry_tilt_16.5deg", "dicom_oddities/pydicom",
                           "dicom_oddities/transfer_syntaxes", "dicom_oddities/multiframe"}) {
    NEEDS_SCAN(scan(name));
    const auto said = survey(scan(name));
    ASSERT_TRUE(said) << name;
    for (const SeriesVerdict& s : said->series) {
      // transfer syntaxes are named
      const std::regex standard("1\\.2\\.840\\.10008[0-9.]*");
      const std::string text = std::regex_replace(sentence(s.message), standard, "");
      EXPECT_EQ(text.find("1.2."), std::string::npos) << sentence(s.message);
    }
  }
}

TEST(RealScans, CancelEndsTheReadOfASeries) {
  const fs::path folder = scan("philips_head_phantom/bone_1mm");
  NEEDS_SCAN(folder);
  std::atomic<bool> cancel = false;
  const auto v = readVolume(folder, {}, {[&](double f) { cancel = f > 0.4; }, &cancel});
  ASSERT_FALSE(v);
  EXPECT_EQ(v.error().kind, haptics::Error::Kind::Cancelled);
}

}  // namespace
}  // namespace datasets
