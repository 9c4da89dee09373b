// SPDX-License-Identifier: BSD-3-Clause
// DICOM objects that mark structures: where each lies, on which side, what it is called, whether it
// belongs to the scan, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// Without its end.
std::string cutOff() {
  const std::string bytes = bytesOf(smallObject());
  return bytes.substr(0, bytes.size() - 40);
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
  EXPECT_EQ(map->structures()[1].name, "N. VII [31m^left");
  const std::array<double, 3> red{1.0, 0.0, 0.0}, white{1.0, 1.0, 1.0};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(map->structures()[0].colour[c], red[c], 0.004);
    EXPECT_NEAR(map->structures()[1].colour[c], white[c], 0.004);
  }
}

TEST(DicomLabels, WhatLiesOutsideTheScanIsCounted) {
  Workshop workshop;
  const auto path = workshop.write("seg", bytesOf(smallObject()));
  haptics::Grid grid = smallGrid();
  EXPECT_EQ(readLabels(path, scanOn(grid))->structures()[0].outside, 0);
  grid.origin.x() += 1e-3;  // the first column is lost
  const auto map = readLabels(path, scanOn(grid));
  ASSERT_TRUE(map) << sentence(map.error());
  EXPECT_EQ(map->structures()[0].marked, 3);
  EXPECT_EQ(map->structures()[0].outside, 1);
  EXPECT_EQ(map->notes().size(), 1U);
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
  EXPECT_EQ(marked(object), "..xxx..xx");
  object.between_mm = 1.6;
  EXPECT_EQ(marked(object), "..xxx..xx");
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
  EXPECT_EQ(reasonOf(readLabels(workshop.write("cut", cutOff()), scan)), "truncated");
  EXPECT_EQ(reasonOf(readLabels(workshop.write("seg", bytesOf(smallObject())),
                                scanOn(smallGrid(), false))),
            "orientation-unknown");
  // a slice of a scan is no structure
  DicomSlice slice;
  slice.pixels = {1};
  EXPECT_EQ(reasonOf(readLabels(workshop.write("ct", bytesOf(slice)), scan)), "not-labels");
}

/// The octants of the box as contours on its slices along these axes: the squares around pixels,
/// all in one region, and so a contour a pixel.
ContourObject contoursAlong(const Mat3& axes) {
  const Grid grid = turned::gridAlong(axes);
  const auto octants = turned::voxelsOf(grid, octantAt);
  ContourObject object;
  for (int octant = 1; octant <= 8; ++octant) {
    object.regions.push_back({octant, "octant " + std::to_string(octant), {octant, 0, 255}});
    for (std::int64_t n = 0; n < grid.voxelCount(); ++n) {
      if (octants[std::size_t(n)] != octant) continue;
      const Vec3 index(double(n % grid.dims[0]), double(n / grid.dims[0] % grid.dims[1]),
                       double(n / grid.dims[0] / grid.dims[1]));
      ContourObject::DrawnContour square{"CLOSED_PLANAR", {}};
      for (const Vec3& corner :
           {Vec3(-0.5, -0.5, 0.0), Vec3(0.5, -0.5, 0.0), Vec3(0.5, 0.5, 0.0), Vec3(-0.5, 0.5, 0.0)})
        square.corners.push_back(1e3 * grid.worldOf(index + corner));
      object.regions.back().contours.push_back(square);
    }
  }
  return object;
}

TEST(DicomLabels, ContoursOfEveryOrientationLieWhereThePatientHasThem) {
  const haptics::Volume scan = scanOn(obliqueGrid());
  std::map<int, std::int64_t> counted;
  const std::vector<int> expected = octantsOn(scan.grid, counted);
  for (const Mat3& axes : turned::orientations()) {
    Workshop workshop;
    ContourObject object = contoursAlong(axes);
    object.contours_are_unknown = axes(0, 0) > 0.0;
    const auto map = readLabels(workshop.write("rt", bytesOf(object)), scan);
    ASSERT_TRUE(map) << sentence(map.error());
    ASSERT_EQ(map->structures().size(), 8U);
    ASSERT_EQ(numbersIn(*map), expected) << axes;
    EXPECT_TRUE(map->notes().empty());
    EXPECT_EQ(map->structures()[4].name, "octant 5");
    EXPECT_EQ(map->structures()[4].colour, (std::array{5.0 / 255.0, 0.0, 1.0}));
  }
}

std::vector<Vec3> ringOf(double radius_mm, const Vec3& centre_mm, int corners = 90) {
  std::vector<Vec3> ring;
  for (int n = 0; n < corners; ++n) {
    const double angle = 6.283185307179586 * n / corners;
    ring.push_back(centre_mm + radius_mm * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  return ring;
}

TEST(DicomLabels, AContourWithinAnotherIsAHole) {
  Grid grid;
  grid.dims = {41, 41, 9};
  grid.spacing = Vec3::Constant(1e-3);
  const haptics::Volume scan = scanOn(grid);
  const Vec3 centre(20.3, 19.8, 0.0);
  ContourObject object;
  object.contours_are_unknown = true;
  object.regions = {{3, "ring"}, {4, "cut ring"}, {5, "points"}};
  for (const double z : {2.0, 3.0, 4.0, 7.0}) {
    const Vec3 at = centre + Vec3(0.0, 0.0, z);
    // so long that its length does not fit into 16 bits
    const auto outer = ringOf(15.5, at, 5'000), inner = ringOf(7.25, at);
    object.regions[0].contours.push_back({"CLOSED_PLANAR", inner});
    object.regions[0].contours.push_back({"CLOSED_PLANAR", outer});
    // one contour, which goes to the hole and back by the same way
    auto cut = outer;
    cut.push_back(outer.front());
    cut.insert(cut.end(), inner.rbegin(), inner.rend());
    cut.push_back(inner.back());
    object.regions[1].contours.push_back({"CLOSED_PLANAR", cut});
  }
  object.regions[0].contours.push_back({"POINT", {centre}});
  object.regions[0].contours.push_back({"OPEN_PLANAR", ringOf(9.0, centre)});
  object.regions[2].contours.push_back({"POINT", {centre}});
  auto bent = ringOf(5.0, centre);
  bent[7].z() += 0.5;
  object.regions[2].contours.push_back({"CLOSED_PLANAR", bent});
  Workshop workshop;
  const auto map = readLabels(workshop.write("rt", bytesOf(object)), scan);
  ASSERT_TRUE(map) << sentence(map.error());
  ASSERT_EQ(map->structures().size(), 3U);
  ASSERT_EQ(map->notes().size(), 1U);
  EXPECT_NE(sentence(map->notes()[0]).find("left out: 4."), std::string::npos)
      << sentence(map->notes()[0]);
  EXPECT_EQ(map->structures()[2].voxels, 0);
  // the polygon lies close to the circle
  int unsure = 0, marked = 0;
  for (int k = 0; k < 9; ++k)
    for (int j = 0; j < 41; ++j)
      for (int i = 0; i < 41; ++i) {
        const double r = std::hypot(i - centre.x(), j - centre.y());
        if (std::abs(r - 15.5) < 0.02 || std::abs(r - 7.25) < 0.02) {
          ++unsure;
          continue;
        }
        const bool within = r < 15.5 && r > 7.25 && ((k >= 2 && k <= 4) || k == 7);
        marked += within ? 1 : 0;
        EXPECT_EQ(setAt(*map, (k * 41 + j) * 41 + i), within ? (Set{0, 1}) : Set{})
            << i << ' ' << j << ' ' << k;
      }
  EXPECT_LT(unsure, 200);
  EXPECT_GT(marked, 2000);
}

ContourObject smallContours() {
  ContourObject object;
  for (const int number : {1, 7}) {
    object.regions.push_back({number, "r", {255, 0, 0}});
    for (const double z : {0.0, 1.0})
      object.regions.back().contours.push_back({"CLOSED_PLANAR",
                                                {Vec3(-0.4, -0.4, z), Vec3(1.4, -0.4, z),
                                                 Vec3(1.4, 0.4 * number, z), Vec3(-0.4, 1.0, z)}});
  }
  return object;
}

TEST(DicomLabels, ContoursThatAreNoneAreRefusedByName) {
  Workshop workshop;
  const haptics::Volume scan = scanOn(smallGrid());
  int number = 0;
  const auto reasonFor = [&](auto change) {
    ContourObject object = smallContours();
    change(object);
    const auto map = readLabels(workshop.write(std::to_string(++number), bytesOf(object)), scan);
    EXPECT_TRUE(map || !sentence(map.error()).empty());
    return reasonOf(map);
  };
  EXPECT_EQ(reasonFor([](auto&) {}), "");
  EXPECT_EQ(reasonFor([](auto& o) { o.regions.clear(); }), "bad-header");
  EXPECT_EQ(reasonFor([](auto& o) { o.regions[1].number = 1; }), "bad-header");
  EXPECT_EQ(reasonFor([](auto& o) {
              for (auto& region : o.regions)
                for (auto& contour : region.contours) contour.type = "OPEN_PLANAR";
            }),
            "labels-none");
  EXPECT_EQ(reasonFor([](auto& o) { o.regions[1].contours[0].corners[0].x() = 1e7; }),
            "bad-header");
  EXPECT_EQ(reasonFor([](auto& o) {
              for (auto& region : o.regions)
                for (auto& contour : region.contours)
                  for (Vec3& corner : contour.corners) corner.y() += 300.0;
            }),
            "labels-elsewhere");
  EXPECT_EQ(reasonFor([](auto& o) {
              for (int n = 10; n < 265; ++n)
                o.regions.push_back({n, "x", {}, o.regions[0].contours});
            }),
            "labels-too-many");
  const std::string bytes = bytesOf(smallContours());
  auto comma = bytes;
  comma.replace(comma.rfind("-0.4"), 4, "-0,4");
  EXPECT_EQ(reasonOf(readLabels(workshop.write("comma", comma), scan)), "bad-header");
  auto fewer = bytes;
  const auto at = fewer.rfind("4 ", fewer.rfind("-0.4"));
  fewer.replace(at, 2, "5 ");
  EXPECT_EQ(reasonOf(readLabels(workshop.write("fewer", fewer), scan)), "bad-header");
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
  // each region of a structure set refers to an origin of its own
  ContourObject contours = smallContours();
  contours.regions[1].frame_of_reference = "1.2.3.8";
  const auto drawn = workshop.write("rt", bytesOf(contours));
  ScanIdentity scan{.patient_id = "P1", .patient_name = "", .frames_of_reference = {"1.2.3.9"}};
  EXPECT_EQ(reasonOf(readLabels(drawn, scanOn(smallGrid()), {}, {.of = scan})),
            "another-frame-of-reference");
  scan.frames_of_reference.insert("1.2.3.8");
  EXPECT_EQ(reasonOf(readLabels(drawn, scanOn(smallGrid()), {}, {.of = scan})), "");
}

TEST(DicomLabels, ASurveyListsThemBesideTheScan) {
  Workshop workshop;
  DicomSlice slice;
  slice.rows = 3;
  slice.columns = 4;
  slice.pixels.assign(12, 5);
  const auto ct = workshop.write("study/ct", bytesOf(slice));
  SegmentObject fractions = smallObject();  // a byte a pixel, and so nearly an image
  fractions.type = "FRACTIONAL";
  workshop.write("study/fractions", bytesOf(fractions));
  workshop.write("study/deep/seg", bytesOf(smallObject()));
  workshop.write("study/deep/cut", cutOff());
  const auto contours = workshop.write("study/deep/rt", bytesOf(smallContours()));
  const auto listed = [](const Survey& survey) {
    std::string all;
    for (const StructuresFound& found : survey.structures) {
      EXPECT_TRUE(std::filesystem::exists(found.path));
      all += found.name + (found.kind == StructuresFound::Kind::Contours ? " drawn;" : ";");
    }
    return all;
  };
  const auto folder = survey(workshop.folder() / "study");
  ASSERT_TRUE(folder) << sentence(folder.error());
  EXPECT_EQ(folder->series.size(), 1U);
  EXPECT_EQ(listed(*folder), "deep/cut;deep/rt drawn;deep/seg;fractions;");
  const auto file = survey(ct);
  ASSERT_TRUE(file) << sentence(file.error());
  EXPECT_EQ(file->series.size(), 1U);
  EXPECT_EQ(file->series[0].verdict, Verdict::Sound);
  EXPECT_EQ(listed(*file), "fractions;");
  for (const auto& path :
       {contours, contours.parent_path(), workshop.folder() / "study/fractions"}) {
    const auto refused = survey(path);
    ASSERT_FALSE(refused) << path;
    EXPECT_EQ(refused.error().reason, "no-pixels");
    EXPECT_NE(sentence(refused.error()).find("holds structures"), std::string::npos);
  }
}

TEST(DicomLabels, DamagedSegmentsAreRefusedWithASentence) {
  expectDamagedRefused({{"damaged", bytesOf(smallObject())}}, 132);
}

TEST(DicomLabels, DamagedContoursAreRefusedWithASentence) {
  expectDamagedRefused({{"damaged", bytesOf(smallContours())}}, 132);
}

}  // namespace
}  // namespace datasets
