// SPDX-License-Identifier: BSD-3-Clause
// DICOM series, on real scans.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "datasets/readers/volume_reader.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;
using testing::differing;
using testing::scan;
using testing::voxelAt;
using testing::Workshop;

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string reasonFor(const fs::path& path) {
  const auto volume = readVolume(path);
  return volume ? "" : volume.error().reason;
}

TEST(DicomReader, HeadSlabIsTheSameRegionOfTheHead) {
  const fs::path slab_path = scan("visible_human_female_head/dicom_slab");
  const fs::path head_path = scan("visible_human_female_head/vhf_head_512x512x234.nrrd");
  NEEDS_SCAN(slab_path);
  NEEDS_SCAN(head_path);
  const auto slab = readVolume(slab_path);
  ASSERT_TRUE(slab) << slab.error().what;
  const auto head = readVolume(head_path);
  ASSERT_TRUE(head) << head.error().what;

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

TEST(DicomReader, NamesDoNotOrderTheSlices) {
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

TEST(DicomReader, OneFileStandsForItsSeries) {
  const fs::path folder = scan("visible_human_female_head/dicom_slab");
  NEEDS_SCAN(folder);
  const auto whole = readVolume(folder);
  const auto by_file = readVolume(filesIn(folder).at(7));
  ASSERT_TRUE(whole && by_file);
  EXPECT_EQ(differing(*whole, *by_file), 0);
  EXPECT_FALSE(survey(filesIn(folder).at(7))->folder);
}

TEST(DicomReader, PhantomOfOneMillimetre) {
  const fs::path path = scan("philips_head_phantom/bone_1mm");
  NEEDS_SCAN(path);
  const auto v = readVolume(path);
  ASSERT_TRUE(v) << v.error().what;
  EXPECT_EQ(v->grid.dims, (std::array<std::int64_t, 3>{512, 512, 48}));
  EXPECT_LT((1e3 * v->grid.spacing - Vec3(0.451171875, 0.451171875, 1)).norm(), 1e-12);
  EXPECT_LT((1e3 * v->grid.origin - Vec3(-115.5, -1.85, 694.21)).norm(), 1e-9);
  EXPECT_EQ(v->type, ScalarType::Int16);
  EXPECT_EQ(v->least, -1024);
  EXPECT_EQ(v->greatest, 3071);
  EXPECT_EQ(v->unit, "HU");
  const auto said = survey(path);
  ASSERT_TRUE(said);
  EXPECT_TRUE(said->folder);
  ASSERT_EQ(said->series.size(), 1u);
  EXPECT_TRUE(said->series[0].sound);
}

TEST(DicomReader, UnequalPixelsAndFractionalRescale) {
  const fs::path path = scan("dicom_oddities/series_non_isotropic_slope");
  NEEDS_SCAN(path);
  const auto v = readVolume(path);
  ASSERT_TRUE(v) << v.error().what;
  EXPECT_EQ(v->grid.dims, (std::array<std::int64_t, 3>{64, 28, 4}));
  EXPECT_NEAR(1e3 * v->grid.spacing.x(), 6.4, 1e-3);
  EXPECT_NEAR(1e3 * v->grid.spacing.y(), 4.0, 1e-3);
  EXPECT_EQ(v->type, ScalarType::Float32);
  EXPECT_EQ(v->unit, "");
}

TEST(DicomReader, RefusesByName) {
  const std::map<std::string, std::string> expected = {
      {"philips_head_phantom/gantry_tilt_16.5deg", "gantry-tilt"},
      {"dicom_oddities/series_failing/gantrytilting", "gantry-tilt"},
      {"dicom_oddities/series_failing/sliceincrement", "missing-slices"},
      {"dicom_oddities/series_failing/sliceorientation", "mixed-orientation"},
      {"dicom_oddities/series_rgb", "not-scalar"},
      {"dicom_oddities/multiframe/eCT_Supplemental.dcm", "multi-frame"},
      {"dicom_oddities/pydicom/badVR.dcm", "multi-frame"},
      {"dicom_oddities/pydicom/MR_truncated.dcm", "truncated"},
      {"dicom_oddities/pydicom/rtstruct.dcm", "no-pixels"},
      {"dicom_oddities/pydicom/image_dfl.dcm", "unsupported-syntax"},
      {"dicom_oddities/transfer_syntaxes/no-pixel-data.dcm", "no-pixels"},
      {"dicom_oddities/fo_dicom/CR-MONO1-10-chest", "bad-header"},
      {"dicom_oddities/fo_dicom/LICENSE.txt", "unreadable"}};
  for (const auto& [name, reason] : expected) {
    NEEDS_SCAN(scan(name));
    EXPECT_EQ(reasonFor(scan(name)), reason) << name;
  }
  EXPECT_EQ(reasonFor("/no/such/folder"), "unreadable");
}

TEST(DicomReader, LosslessSyntaxesGiveEqualVoxels) {
  const fs::path folder = scan("dicom_oddities/transfer_syntaxes");
  NEEDS_SCAN(folder);
  // name fragment, and how far its voxels may be off; -1: refused by its syntax
  const std::vector<std::pair<std::string, double>> expected = {
      {"LittleEndianImplicit", 0}, {"BigEndianExplicit", 0},
      {"RLELossless", 0},          {"JPEGProcess14SV1", 0},
      {"JPEGProcess14Tr", 0},      {"JPEGLSLossless", 0},
      {"JPEG2000LosslessOnly", 0}, {"JPEG2000Transfer", 5},
      {"JPEGLSLossyT", 5},         {"Deflated", -1},
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
      ASSERT_TRUE(v) << fragment << ": " << v.error().what;
      EXPECT_EQ(differing(*plain, *v, tolerance), 0) << fragment;
    }
  }
}

TEST(DicomReader, MixedFolderListsItsSeries) {
  const fs::path folder = scan("philips_head_phantom/mixed_series_one_folder");
  NEEDS_SCAN(folder);
  const auto said = survey(folder);
  ASSERT_TRUE(said) << said.error().what;
  std::map<std::string, int> verdicts;
  int stacks = 0;
  for (const SeriesVerdict& s : said->series) {
    stacks += s.sound ? 1 : 0;
    if (!s.sound) ++verdicts[s.reasons.at(0)];
    EXPECT_EQ(s.dims[2], s.sound ? 4 : 1);
  }
  EXPECT_EQ(stacks, 2);
  EXPECT_EQ(verdicts["localizer"], 1);
  EXPECT_EQ(verdicts["not-scalar"], 1);
  const auto open = readVolume(folder);
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().reason, "which-series");
  EXPECT_EQ(reasonFor(folder / "IM0001"), "");
  // two kernels at the same positions: equal places, unequal voxels
  const auto first = readVolume(folder, 1), second = readVolume(folder, 2);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->grid.origin, second->grid.origin);
  EXPECT_GT(differing(*first, *second), 100000);
  EXPECT_EQ(readVolume(folder, 99).error().reason, "no-such-series");
}

TEST(DicomReader, DamagedFoldersAreRefused) {
  const fs::path folder = scan("philips_head_phantom/bone_1mm");
  NEEDS_SCAN(folder);
  const auto files = filesIn(folder);
  Workshop workshop;
  for (std::size_t i = 0; i < 9; ++i) workshop.copy(files[i], "whole/" + std::to_string(i));
  const fs::path whole = workshop.folder() / "whole";
  fs::copy(whole, workshop.folder() / "twice");
  fs::copy_file(whole / "3", workshop.folder() / "twice" / "copy");
  EXPECT_EQ(reasonFor(workshop.folder() / "twice"), "duplicate");
  fs::copy(whole, workshop.folder() / "cut");
  fs::resize_file(workshop.folder() / "cut" / "5", fs::file_size(whole / "5") - 1000);
  EXPECT_EQ(reasonFor(workshop.folder() / "cut"), "truncated");
  fs::create_directories(workshop.folder() / "empty");
  EXPECT_EQ(reasonFor(workshop.folder() / "empty"), "unreadable");
}

TEST(DicomReader, AMissingSliceIsSeen) {
  const fs::path folder = scan("visible_human_female_head/dicom_slab");
  NEEDS_SCAN(folder);
  Workshop workshop;
  const auto files = filesIn(folder);
  for (std::size_t i = 0; i < files.size(); ++i)
    if (i != 11) workshop.copy(files[i]);
  const auto v = readVolume(workshop.folder());
  ASSERT_FALSE(v);
  EXPECT_EQ(v.error().reason, "missing-slices");
  EXPECT_NE(v.error().what.find("1 slice is missing"), std::string::npos) << v.error().what;
}

TEST(DicomReader, SentencesHoldNoIdentifiers) {
  for (const char* name : {"philips_head_phantom/gantry_tilt_16.5deg", "dicom_oddities/pydicom",
                           "dicom_oddities/transfer_syntaxes", "dicom_oddities/multiframe"}) {
    NEEDS_SCAN(scan(name));
    const auto said = survey(scan(name));
    ASSERT_TRUE(said) << name;
    for (const SeriesVerdict& s : said->series)
      EXPECT_EQ(s.message.find("1.2."), std::string::npos) << s.message;
  }
}

TEST(DicomReader, CancelEndsTheRead) {
  const fs::path folder = scan("philips_head_phantom/bone_1mm");
  NEEDS_SCAN(folder);
  std::atomic<bool> cancel = false;
  double last = 0.0;
  const auto v = readVolume(folder, {},
                            {[&](double f) {
                               last = f;
                               cancel = f > 0.4;
                             },
                             &cancel});
  ASSERT_FALSE(v);
  EXPECT_EQ(v.error().kind, haptics::Error::Kind::Cancelled);
  EXPECT_LT(last, 0.5);
}

}  // namespace
}  // namespace datasets
