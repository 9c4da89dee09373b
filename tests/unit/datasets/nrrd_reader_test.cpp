// SPDX-License-Identifier: BSD-3-Clause
// NRRD: what it means, and what is refused.
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <map>
#include <optional>
#include <string>

#include "datasets/readers/nrrd/vtk_reader.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/comma_locale.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

/// teem 1.12 does not free its gzip state where the file ends early or the stream stops.
extern "C" const char* __lsan_default_suppressions() { return "leak:libteem\nleak:libz.so\n"; }

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;
using testing::differing;
using testing::reasonFor;
using testing::voxelAt;
using testing::Workshop;

/// 5 x 4 x 3 voxels, each different from all others.
std::string rampBytes() {
  std::string bytes;
  for (std::int16_t v = 0; v < 60; ++v) bytes.append(reinterpret_cast<const char*>(&v), 2);
  return bytes;
}

std::string header(const std::string& fields) {
  return "NRRD0005\ntype: short\ndimension: 3\nsizes: 5 4 3\nendian: little\nencoding: raw\n" +
         fields;
}

TEST(NrrdReader, OneRampInThreeSpacesLiesAtOnePlace) {
  Workshop workshop;
  // i towards left, j towards posterior, k towards superior, in three ways of writing
  const std::string units = "space units: \"mm\" \"mm\" \"mm\"\n";
  const std::map<std::string, std::string> spaces = {
      {"lps",
       "space: left-posterior-superior\nspace directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: "
       "(10,20,30)\n"},
      {"ras",
       "space: RAS\nspace directions: (-2,0,0) (0,-3,0) (0,0,4)\nspace origin: (-10,-20,30)\n"},
      {"las",
       "space: left-anterior-superior\nspace directions: (2,0,0) (0,-3,0) (0,0,4)\nspace origin: "
       "(10,-20,30)\n"}};
  for (const auto& [name, fields] : spaces) {
    const auto v =
        readVolume(workshop.write(name + ".nrrd", header(fields + units) + "\n" + rampBytes()));
    ASSERT_TRUE(v) << name << ": " << sentence(v.error());
    EXPECT_TRUE(v->orientation_known);
    EXPECT_LT((v->grid.worldOf({4, 2, 1}) - Vec3(0.018, 0.026, 0.034)).norm(), 1e-12) << name;
    EXPECT_EQ(voxelAt(*v, 4, 2, 1), 4 + 5 * (2 + 4 * 1)) << name;
    EXPECT_LT((v->grid.direction - haptics::Mat3::Identity()).norm(), 1e-12) << name;
  }
}

TEST(NrrdReader, AFieldWithoutEndIsRefused) {
  // 900 to 1,100: where teem's own message about it would outgrow its buffer
  Workshop workshop;
  for (const char* begin : {"space: LPS\nspace directions: ", "unheard of: ", "no colon "})
    for (std::size_t length = 900; length <= 1100; length += 20) {
      const std::string field = begin + std::string(length, '(') + "\n";
      const auto v = readVolume(workshop.write("v.nrrd", header(field) + "\n" + rampBytes()));
      ASSERT_FALSE(v) << begin << length;
      EXPECT_EQ(v.error().reason, "bad-header");
    }
  const std::string content = "content: " + std::string(5000, 'c') + "\n";
  EXPECT_TRUE(readVolume(workshop.write("v.nrrd", header(content) + "\n" + rampBytes())));
}

TEST(NrrdReader, AxesMayBePlacedByTheirEnds) {
  Workshop workshop;
  const auto spacingOf = [&](const std::string& fields) {
    const auto v = readVolume(workshop.write("v.nrrd", header(fields) + "\n" + rampBytes()));
    EXPECT_TRUE(v) << sentence(v.error());
    return v ? haptics::Vec3(v->grid.spacing * 1e3) : haptics::Vec3::Zero();
  };
  const auto whole = readVolume(workshop.write("w.nrrd", header("") + "\n" + rampBytes()));
  ASSERT_TRUE(whole);
  const auto n = [&](std::size_t a) { return static_cast<double>(whole->grid.dims[a]); };
  const std::string ends = "axis mins: 1 -2 0\naxis maxs: 11 10 6\n";
  EXPECT_LT((spacingOf(ends) - Vec3(10 / n(0), 12 / n(1), 6 / n(2))).norm(), 1e-12);
  EXPECT_LT((spacingOf(ends + "centerings: node cell node\n") -
             Vec3(10 / (n(0) - 1), 12 / n(1), 6 / (n(2) - 1)))
                .norm(),
            1e-12);
}

TEST(NrrdReader, EachDirectionBelongsToItsAxis) {
  Workshop workshop;
  const auto v = readVolume(
      workshop.write("v.nrrd", header("space: LPS\nspace directions: (0,2,0) (0,0,3) (4,0,0)\n"
                                      "space origin: (1,2,3)\n") +
                                   "\n" + rampBytes()));
  ASSERT_TRUE(v) << sentence(v.error());
  // 4 steps along y, 2 along z, 1 along x
  EXPECT_LT((v->grid.worldOf({4, 2, 1}) - Vec3(0.005, 0.010, 0.009)).norm(), 1e-12);
}

TEST(NrrdReader, AShearOfATenthOfADegreeIsRoundingAndMoreIsNot) {
  Workshop workshop;
  const auto sheared = [&](const char* leaning) {
    return workshop.write("v.nrrd", header(std::string("space: LPS\nspace directions: (2,0,0) ") +
                                           leaning + " (0,0,-4)\n") +
                                        "\n" + rampBytes());
  };
  const fs::path path = sheared("(0.0052,3,0)");
  const auto v = readVolume(path);
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_LT((v->grid.direction.transpose() * v->grid.direction - haptics::Mat3::Identity()).norm(),
            1e-12);
  EXPECT_LT(v->grid.direction.determinant(), 0.0);
  EXPECT_NE(sentence(survey(path)->series.front().message).find("0.09931 degrees off"),
            std::string::npos);
  EXPECT_EQ(reasonFor(sheared("(0.0055,3,0)")), "sheared");
}

TEST(NrrdReader, HeadersThatLieAreRefusedBeforeMemoryIsAsked) {
  Workshop workshop;
  const auto reason = [&](const std::string& text) {
    return reasonFor(workshop.write("lie.nrrd", text));
  };
  const std::string rest = "endian: little\nspacings: 1 1 1\n";
  const std::string start = "NRRD0004\ntype: short\ndimension: 3\n" + rest;
  EXPECT_EQ(reason(start + "encoding: raw\nsizes: -5 4 3\n\n" + rampBytes()), "bad-header");
  EXPECT_EQ(reason(start + "encoding: raw\nsizes: 0 4 3\n\n" + rampBytes()), "bad-header");
  EXPECT_EQ(reason(start + "encoding: raw\nsizes: 5 4\n\n" + rampBytes()), "bad-header");
  EXPECT_EQ(reason(start + "encoding: raw\nsizes: 9223372036854775807 9223372036854775807 2\n\n"),
            "too-large");
  EXPECT_EQ(reason(start + "encoding: gzip\nsizes: 100000 100000 100\n\n" + rampBytes()),
            "truncated");
  EXPECT_EQ(reason(start + "encoding: ascii\nsizes: 1000 1000 100\n\n1 2 3\n"), "truncated");
  EXPECT_EQ(reason("NRRD0004\ntype: short\nsizes: 5 4 3\ndimension: 3\n" + rest +
                   "encoding: raw\n\n" + rampBytes()),
            "bad-header");
  EXPECT_EQ(reason("NRRD0004\ntype: int64\ndimension: 3\nsizes: 5 4 3\n" + rest +
                   "encoding: raw\n\n" + std::string(480, 'a')),
            "unsupported-type");
  EXPECT_EQ(
      reason(header("kinds: RGB-color domain domain\nspacings: 1 1 1\n") + "\n" + rampBytes()),
      "not-scalar");
  EXPECT_EQ(reason(header("spacings: 1 1 0\n") + "\n" + rampBytes()), "bad-header");
  EXPECT_EQ(reason(header("spacings: 1 1 1\nspacings: 2 2 2\n") + "\n" + rampBytes()),
            "bad-header");
  EXPECT_EQ(reason(header("space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) "
                          "(0,0,1)\nspace units: \"furlong\" \"mm\" \"mm\"\n") +
                   "\n" + rampBytes()),
            "bad-header");
  EXPECT_EQ(
      reason(
          "NRRD0004\ntype: short\ndimension: 3\nsizes: 5 4 3\nspacings: 1 1 1\nencoding: raw\n\n" +
          rampBytes()),
      "bad-header");
  // a header that was true when it was surveyed, and files that have changed since
  workshop.write("later.raw", rampBytes());
  const auto laterHeader = [&](const std::string& step) {
    return workshop.write("later.nhdr",
                          header("spacings: " + step + " 1 1\ndata file: later.raw\n"));
  };
  const auto found = survey(laterHeader("1"));
  ASSERT_TRUE(found) << sentence(found.error());
  const SeriesVerdict& before = found->series.front();
  EXPECT_TRUE(readVolume(before));
  workshop.write("later.raw", rampBytes().substr(2));
  EXPECT_EQ(readVolume(before).error().reason, "truncated");
  workshop.write("later.raw", rampBytes());
  laterHeader("2.5");
  const auto after = readVolume(before);
  ASSERT_TRUE(after) << sentence(after.error());
  EXPECT_NEAR(after->grid.spacing.x(), 2.5e-3, 1e-12);  // m
}

TEST(NrrdReader, DataFilesStayInTheHeadersFolder) {
  Workshop workshop;
  workshop.write("outside.raw", rampBytes());
  workshop.write("in/inside.raw", rampBytes());
  workshop.write("in/longer.raw", "some header" + rampBytes());
  fs::create_symlink(workshop.folder() / "outside.raw", workshop.folder() / "in/link.raw");
  const auto reason = [&](const std::string& data) {
    return reasonFor(workshop.write("in/v.nhdr", header("spacings: 1 1 1\n" + data + "\n")));
  };
  EXPECT_EQ(reason("data file: inside.raw"), "");
  EXPECT_EQ(reason("data file: ../outside.raw"), "outside-folder");
  EXPECT_EQ(reason("data file: " + (workshop.folder() / "in/inside.raw").string()),
            "outside-folder");
  EXPECT_EQ(reason("data file: link.raw"), "outside-folder");
  EXPECT_EQ(reason("data file: LIST\n../outside.raw"), "outside-folder");
  EXPECT_EQ(reason("data file: ../o%05d.raw 1 2 1"), "outside-folder");
  EXPECT_EQ(reason("data file: %s%n.raw 1 2 1"), "bad-header");
  EXPECT_EQ(reason("data file: absent.raw"), "truncated");
  EXPECT_EQ(reason("data file: longer.raw"), "bad-header");
  EXPECT_EQ(reason("byte skip: 11\ndata file: longer.raw"), "");
  EXPECT_EQ(reason("byte skip: -1\ndata file: longer.raw"), "");
}

TEST(NrrdReader, UnitsOfLength) {
  Workshop workshop;
  for (const auto& [unit, metres] :
       std::map<std::string, double>{{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"um", 1e-6}}) {
    const std::string quoted = "\"" + unit + "\"";
    const auto v =
        readVolume(workshop.write("u.nrrd", header("space: LPS\nspace directions: (1,0,0) (0,1,0) "
                                                   "(0,0,1)\nspace origin: (7,0,0)\nspace units: " +
                                                   quoted + " " + quoted + " " + quoted + "\n") +
                                                "\n" + rampBytes()));
    ASSERT_TRUE(v) << unit << ": " << sentence(v.error());
    EXPECT_NEAR(v->grid.spacing.z() / metres, 1.0, 1e-12) << unit;
    EXPECT_NEAR(v->grid.origin.x() / metres, 7.0, 1e-11) << unit;
  }
}

TEST(NrrdReader, AxesOfDifferentUnitsAreRefused) {
  Workshop workshop;
  const auto reason = [&](const std::string& fields) {
    return reasonFor(workshop.write("u.nrrd", header(fields) + "\n" + rampBytes()));
  };
  const std::string placed =
      "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace units: \"mm\" ";
  EXPECT_EQ(reason(placed + "\"mm\" \"mm\"\n"), "");
  EXPECT_EQ(reason(placed + "\"mm\" \"cm\"\n"), "bad-header");
  EXPECT_EQ(reason("spacings: 1 1 1\nunits: \"mm\" \"mm\" \"cm\"\n"), "bad-header");
}

TEST(NrrdReader, AxisMinsArePlaces) {
  Workshop workshop;
  const auto read = [&](const std::string& fields) {
    return readVolume(workshop.write("m.nrrd", header(fields) + "\n" + rampBytes()));
  };
  const auto cells = read("spacings: 2 2 2\naxis mins: 10 20 30\n");
  ASSERT_TRUE(cells) << sentence(cells.error());
  EXPECT_LT((1e3 * cells->grid.origin - Vec3(11, 21, 31)).norm(), 1e-9);
  const auto nodes = read("spacings: 2 2 2\naxis mins: 10 20 30\ncenterings: node node node\n");
  ASSERT_TRUE(nodes) << sentence(nodes.error());
  EXPECT_LT((1e3 * nodes->grid.origin - Vec3(10, 20, 30)).norm(), 1e-9);
  const auto wrong = read("spacings: 2 2 2\naxis mins: 0 0 0\naxis maxs: 99 99 99\n");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().reason, "bad-header");
}

TEST(NrrdReader, TextBeyondItsTypeIsRefused) {
  Workshop workshop;
  const auto reason = [&](const std::string& type, const std::string& value) {
    return reasonFor(workshop.write(
        "t.nrrd", "NRRD0004\ntype: " + type +
                      "\ndimension: 3\nsizes: 2 1 1\nencoding: ascii\nspacings: 1 1 1\n\n7 " +
                      value + "\n"));
  };
  for (const auto& [type, value] : {std::pair{"uchar", "255"}, std::pair{"short", "-32768"},
                                    std::pair{"ushort", "+65535"}, std::pair{"float", "1e3"}})
    EXPECT_EQ(reason(type, value), "") << type << " " << value;
  for (const auto& [type, value] :
       {std::pair{"uchar", "256"}, std::pair{"uchar", "-1"}, std::pair{"short", "32768"},
        std::pair{"int", "4294967296"}, std::pair{"short", "1.5"}, std::pair{"float", "1,5"},
        std::pair{"uchar", "0x10"}})
    EXPECT_EQ(reason(type, value), "bad-header") << type << " " << value;
}

TEST(NrrdReader, OriginsBeyondAllRoomsAreRefused) {
  Workshop workshop;
  const std::string placed = "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n";
  const auto reason = [&](const std::string& origin) {
    return reasonFor(workshop.write(
        "o.nrrd", header(placed + "space origin: (" + origin + ",0,0)\n") + "\n" + rampBytes()));
  };
  EXPECT_EQ(reason("99999"), "");
  EXPECT_EQ(reason("1e15"), "bad-header");
}

TEST(NrrdReader, NumbersAreReadAlikeInEveryLanguage) {
  Workshop workshop;
  const fs::path path =
      workshop.write("l.nrrd", header("spacings: 0.5 0.25 1.5\n") + "\n" + rampBytes());
  std::optional<support::CommaLocale> comma(workshop.folder());
  ASSERT_TRUE(comma->isSet());
  const auto v = readVolume(path);
  const auto floats = readVolume(workshop.write(
      "f.nrrd",
      "NRRD0005\ntype: float\ndimension: 3\nsizes: 2 1 1\nencoding: ascii\n\n0.5 1.75\n"));
  comma.reset();
  ASSERT_TRUE(v) << sentence(v.error());
  ASSERT_TRUE(floats) << sentence(floats.error());
  EXPECT_EQ(voxelAt(*floats, 1, 0, 0), 1.75);
  EXPECT_LT((1e3 * v->grid.spacing - Vec3(0.5, 0.25, 1.5)).norm(), 1e-12);
}

TEST(NrrdReader, TheVtkImageLooksAtTheVolumesVoxels) {
  Workshop workshop;
  vtkNew<VtkNrrdReader> reader;
  reader->setPath(workshop.write(
      "v.nrrd",
      header("space: LPS\nspace directions: (0,2,0) (3,0,0) (0,0,4)\nspace origin: (1,2,3)\n") +
          "\n" + rampBytes()));
  reader->Update();
  ASSERT_TRUE(reader->volume()) << sentence(reader->volume().error());
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(image->GetScalarPointer(), reader->volume()->voxels.get());
  EXPECT_EQ(image->GetScalarComponentAsDouble(4, 2, 1, 0), 34);
  double index[3] = {4, 2, 1}, world[3];
  image->TransformContinuousIndexToPhysicalPoint(index, world);
  EXPECT_LT((Vec3(world) - reader->volume()->grid.worldOf({4, 2, 1})).norm(), 1e-12);
}

}  // namespace
}  // namespace datasets
