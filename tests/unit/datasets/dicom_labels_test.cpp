// SPDX-License-Identifier: BSD-3-Clause
// DICOM objects that mark structures: where each lies, on which side, what it is called, whether it
// belongs to the scan, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "datasets/labels/dicom_segments.h"
#include "datasets/labels/label_file.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/codestreams.h"
#include "tests/support/sentence.h"
#include "tests/support/turned_scan.h"
#include "tests/unit/datasets/dicom_label_bytes.h"
#include "tests/unit/datasets/label_scans.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using haptics::Grid;
using haptics::Mat3;
using haptics::Vec3;
using namespace testing;

/// The octants of the box along these axes, a frame for each octant and slice that has some; in an
/// order that is nobody's.
SegmentObject octantsAlong(const Mat3& axes) {
  const Grid grid = turned::gridAlong(axes);
  SegmentObject object;
  object.columns = int(grid.dims[0]);
  object.rows = int(grid.dims[1]);
  object.along_row = grid.direction.col(0);
  object.along_column = grid.direction.col(1);
  object.column_step_mm = object.row_step_mm = object.between_mm = turned::kStep_mm;
  const auto octants = turned::voxelsOf(grid, octantAt);
  const std::int64_t slice = grid.dims[0] * grid.dims[1];
  for (int octant = 1; octant <= 8; ++octant) {
    object.segments.push_back({octant, "octant " + std::to_string(octant)});
    for (std::int64_t k = 0; k < grid.dims[2]; ++k) {
      std::vector<int> values;
      for (std::int64_t n = k * slice; n < (k + 1) * slice; ++n)
        values.push_back(octants[std::size_t(n)] == octant ? 1 : 0);
      if (std::ranges::find(values, 1) != values.end())
        object.frames.push_back({octant, 1e3 * grid.worldOf({0.0, 0.0, double(k)}), values});
    }
  }
  std::ranges::shuffle(object.frames, std::mt19937{17});
  return object;
}

TEST(DicomLabels, SegmentsOfEveryOrientationLieWhereThePatientHasThem) {
  const haptics::Volume scan = scanOn(obliqueGrid());
  std::map<int, std::int64_t> counted;
  const std::vector<int> expected = octantsOn(scan.grid, counted);
  ASSERT_EQ(counted.size(), 9U);
  for (const Mat3& axes : turned::orientations()) {
    Workshop workshop;
    const auto map = readLabels(workshop.write("seg", bytesOf(octantsAlong(axes))), scan);
    ASSERT_TRUE(map) << sentence(map.error());
    ASSERT_EQ(map->structures().size(), 8U);
    ASSERT_EQ(numbersIn(*map), expected) << axes;
    EXPECT_EQ(map->structures()[4].name, "octant 5");
    for (int n = 1; n <= 8; ++n)
      EXPECT_EQ(map->structures()[std::size_t(n - 1)].voxels, counted[n]);
  }
}

/// Two frames of 4 x 3 pixels of 1 mm, on the planes of smallGrid().
SegmentObject smallObject() {
  SegmentObject object;
  object.columns = 4;
  object.rows = 3;
  object.between_mm = 1.0;
  object.segments = {{1, "nerve"}, {7, "canal"}};
  const std::vector<int> first{1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1},
      second{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0};
  object.frames = {{1, Vec3(0.0, 0.0, 0.0), first},
                   {7, Vec3(0.0, 0.0, 0.0), second},
                   {7, Vec3(0.0, 0.0, 1.0), first}};
  return object;
}

using Set = std::vector<std::uint8_t>;

TEST(DicomLabels, SegmentsOverlapAndKeepNamesAndColours) {
  Workshop workshop;
  SegmentObject object = smallObject();
  // the sRGB red and white in CIELab with the white of D65
  object.segments[0].cie_lab = {34891, 53480, 50167};
  object.segments[1].cie_lab = {65535, 32896, 32896};
  object.segments[1].label = "N. VII \x1b[31m^left";
  const auto map = readLabels(workshop.write("seg", bytesOf(object)), scanOn(smallGrid()));
  ASSERT_TRUE(map) << sentence(map.error());
  EXPECT_EQ(setAt(*map, 0), (Set{0, 1}));
  EXPECT_EQ(setAt(*map, 1), Set{0});
  EXPECT_EQ(setAt(*map, 5), Set{1});
  EXPECT_EQ(setAt(*map, 11), Set{0});
  EXPECT_EQ(setAt(*map, 12), Set{1});
  EXPECT_EQ(map->structures()[0].voxels, 3);
  EXPECT_EQ(map->structures()[1].voxels, 5);
  EXPECT_EQ(map->structures()[1].name, "N. VII  [31m^left");
  const std::array<double, 3> red{1.0, 0.0, 0.0}, white{1.0, 1.0, 1.0};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(map->structures()[0].colour[c], red[c], 0.004);
    EXPECT_NEAR(map->structures()[1].colour[c], white[c], 0.004);
  }
}

TEST(DicomLabels, AFractionBelongsFromHalfOn) {
  Workshop workshop;
  SegmentObject object = smallObject();
  object.type = "FRACTIONAL";
  object.greatest = 200;
  object.frames = {{7, Vec3(0.0, 0.0, 0.0), {0, 1, 99, 100, 101, 200, 0, 0, 0, 0, 0, 0}}};
  const haptics::Volume scan = scanOn(smallGrid());
  const auto expectHalves = [&](const haptics::Expected<LabelMap>& map) {
    ASSERT_TRUE(map) << sentence(map.error());
    for (int n = 0; n < 24; ++n) EXPECT_EQ(setAt(*map, n), n >= 3 && n <= 5 ? Set{1} : Set{}) << n;
  };
  expectHalves(readLabels(workshop.write("seg", bytesOf(object)), scan));
  // compressed, which a program of its own decodes
  std::vector<std::uint16_t> values(object.frames[0].values.begin(), object.frames[0].values.end());
  const std::string rle = support::asRle({4, 3, 8, 1, values});
  expectHalves(readLabels(
      workshop.write("rle", compressedBytesOf(object, "1.2.840.10008.1.2.5", {rle})), scan));
  // bits are never compressed
  object.type = "BINARY";
  EXPECT_EQ(
      reasonOf(readLabels(
          workshop.write("bits", compressedBytesOf(object, "1.2.840.10008.1.2.5", {rle})), scan)),
      "unsupported-syntax");
}

TEST(DicomLabels, ALabelMapHasAllSegmentsInOneFrame) {
  Workshop workshop;
  SegmentObject object = smallObject();
  object.origin.sop_class = "1.2.840.10008.5.1.4.1.1.66.7";
  object.type = "LABELMAP";
  object.segments.insert(object.segments.begin(), {0, "background"});
  object.frames = {{0, Vec3(0.0, 0.0, 0.0), {0, 1, 7, 7, 0, 0, 0, 0, 0, 0, 0, 0}},
                   {0, Vec3(0.0, 0.0, 1.0), {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}}};
  const haptics::Volume scan = scanOn(smallGrid());
  const auto map = readLabels(workshop.write("seg", bytesOf(object)), scan);
  ASSERT_TRUE(map) << sentence(map.error());
  ASSERT_EQ(map->structures().size(), 2U);
  EXPECT_EQ(setAt(*map, 1), Set{0});
  EXPECT_EQ(setAt(*map, 2), Set{1});
  EXPECT_EQ(setAt(*map, 12), Set{0});
  object.frames[0].values[5] = 3;  // which nobody describes
  EXPECT_EQ(reasonOf(readLabels(workshop.write("odd", bytesOf(object)), scan)), "bad-header");
}

TEST(DicomLabels, FramesThatAreLeftOutMarkNothing) {
  Workshop workshop;
  Grid grid = smallGrid();
  grid.dims = {4, 3, 9};
  const haptics::Volume scan = scanOn(grid);
  SegmentObject object = smallObject();
  object.segments = {{1, "a"}};
  const std::vector<int> all(12, 1);
  object.frames = {
      {1, Vec3(0.0, 0.0, 8.0), all}, {1, Vec3(0.0, 0.0, 2.0), all}, {1, Vec3(0.0, 0.0, 4.0), all}};
  const auto marked = [&](const SegmentObject& stated) {
    const auto map = readLabels(workshop.write("seg", bytesOf(stated)), scan);
    std::string slices;
    for (int k = 0; map && k < 9; ++k) slices += setAt(*map, 12 * k + 5).empty() ? '.' : 'x';
    return map ? slices : map.error().reason;
  };
  object.between_mm = 1.0;
  EXPECT_EQ(marked(object), "..x.x...x");
  // not stated, or stated wrongly: the smallest gap is the step
  object.between_mm = 0.0;
  EXPECT_EQ(marked(object), "..xxx...x");
  object.between_mm = 1.6;
  EXPECT_EQ(marked(object), "..xxx...x");
  object.frames[0].position_mm.z() = 7.2;
  EXPECT_EQ(marked(object), "uneven-spacing");
  // slices that advance off their normal lie where each says
  object.between_mm = 1.0;
  object.frames = {{1, Vec3(0.0, 0.0, 0.0), {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
                   {1, Vec3(0.0, 1.0, 1.0), {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}}};
  const auto tilted = readLabels(workshop.write("tilted", bytesOf(object)), scan);
  ASSERT_TRUE(tilted) << sentence(tilted.error());
  EXPECT_EQ(setAt(*tilted, 0), Set{0});
  EXPECT_EQ(setAt(*tilted, 12 + 4), Set{0});
  EXPECT_EQ(tilted->structures()[0].voxels, 2);
  // a single plane is as thick as it says
  object.between_mm = 0.0;
  object.frames = {{1, Vec3(0.0, 0.0, 4.0), all}};
  EXPECT_EQ(marked(object), "bad-header");
  object.thickness_mm = 3.0;
  EXPECT_EQ(marked(object), "...xxx...");
}

TEST(DicomLabels, WhatIsNoneIsRefusedByName) {
  Workshop workshop;
  const haptics::Volume scan = scanOn(smallGrid());
  int number = 0;
  const auto reasonFor = [&](const SegmentObject& object) {
    const auto map = readLabels(workshop.write(std::to_string(++number), bytesOf(object)), scan);
    EXPECT_TRUE(map || !sentence(map.error()).empty());
    return reasonOf(map);
  };
  EXPECT_EQ(reasonFor(smallObject()), "");
  const auto with = [](auto change) {
    SegmentObject object = smallObject();
    change(object);
    return object;
  };
  EXPECT_EQ(reasonFor(with([](auto& o) { o.segments.clear(); })), "bad-header");
  EXPECT_EQ(reasonFor(with([](auto& o) { o.segments[1].number = 1; })), "bad-header");
  EXPECT_EQ(reasonFor(with([](auto& o) { o.frames[1].segment = 2; })), "bad-header");
  EXPECT_EQ(reasonFor(with([](auto& o) { o.type = "PARTIAL"; })), "bad-header");
  EXPECT_EQ(reasonFor(with([](auto& o) {
              o.type = "FRACTIONAL";
              o.greatest = 0;
            })),
            "bad-header");
  EXPECT_EQ(reasonFor(with([](auto& o) { o.frames[2] = o.frames[1]; })), "duplicate");
  EXPECT_EQ(reasonFor(with([](auto& o) { o.along_column = o.along_row; })), "bad-header");
  EXPECT_EQ(reasonFor(with([](auto& o) { o.row_step_mm = 0.0; })), "bad-header");
  EXPECT_EQ(reasonFor(with([](auto& o) { o.frames[2].position_mm.z() = 1e9; })), "bad-header");
  EXPECT_EQ(reasonFor(with([](auto& o) {
              for (auto& frame : o.frames) std::ranges::fill(frame.values, 0);
            })),
            "labels-elsewhere");
  EXPECT_EQ(reasonFor(with([](auto& o) {
              for (auto& frame : o.frames) frame.position_mm.x() = 500.0;
            })),
            "labels-elsewhere");
  EXPECT_EQ(reasonFor(with([](auto& o) {
              for (int n = 10; n < 265; ++n) o.segments.push_back({n, "x"});
            })),
            "labels-too-many");
  EXPECT_EQ(
      reasonOf(readLabels(workshop.write("cut", bytesOf(smallObject()).substr(0, 1200)), scan)),
      "truncated");
  EXPECT_EQ(reasonOf(readLabels(workshop.write("seg", bytesOf(smallObject())),
                                scanOn(smallGrid(), false))),
            "orientation-unknown");
  // a slice of a scan is no structure
  DicomSlice slice;
  slice.pixels = {1};
  EXPECT_EQ(reasonOf(readLabels(workshop.write("ct", bytesOf(slice)), scan)), "not-labels");
}

TEST(DicomLabels, OfAnotherScanAreAskedAbout) {
  Workshop workshop;
  const auto scanWith = [&](const std::string& patient, const std::string& frame) {
    DicomSlice slice;
    slice.rows = 3;
    slice.columns = 4;
    slice.pixels.assign(12, 5);
    std::vector<Element> more{{0x10, 0x10, "PN", "Doe^J"}};
    if (!patient.empty()) more.push_back({0x10, 0x20, "LO", patient});
    if (!frame.empty()) more.push_back({0x20, 0x52, "UI", frame});
    return workshop.write("ct/" + patient + frame + "/1", edited(bytesOf(slice), more))
        .parent_path();
  };
  const auto path = workshop.write("seg", bytesOf(smallObject()));
  const auto reasonBeside = [&](const std::filesystem::path& folder, bool agreed = false) {
    const auto survey = datasets::survey(folder);
    EXPECT_TRUE(survey);
    const auto scan = readVolume(survey->series.at(0));
    EXPECT_TRUE(scan) << sentence(scan.error());
    const auto map =
        readLabels(path, *scan, {}, {.of = identityOf(survey->series.at(0)), .agreed = agreed});
    EXPECT_TRUE(map || map.error().kind == haptics::Error::Kind::Correctable);
    return reasonOf(map);
  };
  EXPECT_EQ(reasonBeside(scanWith("P1", "1.2.3.9")), "");
  EXPECT_EQ(reasonBeside(scanWith("P2", "1.2.3.9")), "another-patient");
  EXPECT_EQ(reasonBeside(scanWith("P2", "1.2.3.9"), true), "");
  EXPECT_EQ(reasonBeside(scanWith("P1", "1.2.3.8")), "another-frame-of-reference");
  EXPECT_EQ(reasonBeside(scanWith("P1", "1.2.3.8"), true), "");
  EXPECT_EQ(reasonBeside(scanWith("P1", "")), "");  // not stated
  // without an identifier the name counts
  EXPECT_EQ(reasonBeside(scanWith("", "1.2.3.9")), "another-patient");
  EXPECT_EQ(reasonOf(readLabels(path, scanOn(smallGrid()))), "");  // a scan that states nothing
}

/// Changes bytes, cuts, repeats and removes pieces.
std::string damaged(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t end) {
    return std::uniform_int_distribution<std::size_t>{0, end - 1}(random);
  };
  const std::size_t changes = 1 + below(4);
  for (std::size_t n = 0; n < changes && bytes.size() > 200; ++n) {
    const std::size_t at = 132 + below(bytes.size() - 132);
    switch (below(5)) {
      case 0:
        bytes[at] = char(below(256));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.erase(at, 1 + below(8));
        break;
      case 3:
        bytes.insert(at, bytes.substr(132 + below(bytes.size() - 132), 1 + below(40)));
        break;
      default:
        for (std::size_t m = at; m < std::min(at + 4, bytes.size()); ++m) bytes[m] = '\xff';
    }
  }
  return bytes;
}

/// Damages a file until 200 are refused; each with a sentence and a reason.
void expectDamagedRefused(const std::string& bytes) {
  Workshop workshop;
  const haptics::Volume scan = scanOn(smallGrid());
  std::mt19937 random{46};
  int refused = 0, all = 0;
  for (; refused < 200 && all < 2000; ++all) {
    const auto map = readLabels(workshop.write("damaged", damaged(bytes, random)), scan);
    if (map) continue;
    ++refused;
    EXPECT_FALSE(sentence(map.error()).empty());
    EXPECT_FALSE(map.error().reason.empty());
  }
  EXPECT_EQ(refused, 200) << "of " << all;
}

TEST(DicomLabels, DamagedSegmentsAreRefusedWithASentence) {
  expectDamagedRefused(bytesOf(smallObject()));
}

}  // namespace
}  // namespace datasets
