// SPDX-License-Identifier: BSD-3-Clause
// Label maps beside a scan: where each structure lies, on which side, what it is called, and what
// is refused.
#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "datasets/labels/label_file.h"
#include "datasets/labels/segments.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/support/turned_scan.h"
#include "tests/unit/datasets/label_scans.h"
#include "tests/unit/datasets/nifti_bytes.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using haptics::Grid;
using haptics::Mat3;
using haptics::Vec3;
using namespace testing;

TEST(Labels, OfEveryOrientationLieWhereThePatientHasThem) {
  const haptics::Volume scan = scanOn(obliqueGrid());
  std::map<int, std::int64_t> counted;
  const std::vector<int> expected = octantsOn(scan.grid, counted);
  ASSERT_EQ(counted.size(), 9U);  // all octants, and none
  int files = 0;
  for (const Mat3& axes : turned::orientations())
    for (const auto& [space, signs] :
         {std::pair{"left-posterior-superior", Vec3{1.0, 1.0, 1.0}},
          std::pair{"right-anterior-superior", Vec3{-1.0, -1.0, 1.0}}}) {
      Workshop workshop;
      const Grid grid = turned::gridAlong(axes);
      const auto path = workshop.write(
          "labels.nrrd", turned::nrrdOf(grid, turned::voxelsOf(grid, octantAt), space, signs));
      const auto map = readLabels(path, scan);
      ASSERT_TRUE(map) << sentence(map.error());
      ASSERT_EQ(map->structures().size(), 8U);
      ASSERT_EQ(numbersIn(*map), expected) << space << '\n' << axes;
      for (int n = 1; n <= 8; ++n)
        EXPECT_EQ(map->structures()[std::size_t(n - 1)].voxels, counted[n]);
      ++files;
    }
  EXPECT_EQ(files, 96);
}

/// A .seg.nrrd of 4 x 3 x 2 voxels of 1 mm at the origin, its layers counted by the first axis as
/// 3D Slicer writes them.
std::string segOf(const std::string& keys, const std::vector<std::vector<int>>& layers) {
  std::string text = "NRRD0004\ntype: unsigned char\nspace: left-posterior-superior\n";
  if (layers.size() == 1)
    text +=
        "dimension: 3\nsizes: 4 3 2\nkinds: domain domain domain\n"
        "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
  else
    text += "dimension: 4\nsizes: " + std::to_string(layers.size()) +
            " 4 3 2\nkinds: list domain domain domain\n"
            "space directions: none (1,0,0) (0,1,0) (0,0,1)\n";
  text += "space origin: (0,0,0)\nencoding: raw\n" + keys + "\n";
  for (std::size_t n = 0; n < 24; ++n)
    for (const auto& layer : layers) text += char(layer[n]);
  return text;
}

/// 24 voxels of which some have a label.
std::vector<int> marked(std::initializer_list<int> at, int label = 1) {
  std::vector<int> voxels(24, 0);
  for (const int n : at) voxels[std::size_t(n)] = label;
  return voxels;
}

TEST(Labels, SegmentsOverlapInLayersAndKeepNamesAndColours) {
  Workshop workshop;
  auto first = marked({0, 1, 2, 3}, 5);
  first[7] = 9;
  const auto path = workshop.write(
      "a.seg.nrrd", segOf("Segment0_ID:=Segment_1\nSegment0_Name:=Facial nerve: N. VII\n"
                          "Segment0_Color:=1 0.5 0.25\nSegment0_LabelValue:=5\nSegment0_Layer:=0\n"
                          "Segment1_ID:=Segment_2\nSegment1_Name:=\xC3\xA4\\n\x1B[31mred\xFF\n"
                          "Segment1_LabelValue:=1\nSegment1_Layer:=1\n"
                          "Segment2_ID:=Segment_3\nSegment2_LabelValue:=9\nSegment2_Layer:=0\n",
                          {first, marked({2, 3, 20})}));
  const auto map = readLabels(path, scanOn(smallGrid()));
  ASSERT_TRUE(map) << sentence(map.error());
  ASSERT_EQ(map->structures().size(), 3U);
  EXPECT_EQ(map->structures()[0].name, "Facial nerve: N. VII");
  EXPECT_EQ(map->structures()[0].colour, (std::array{1.0, 0.5, 0.25}));
  EXPECT_EQ(map->structures()[1].name, "\xC3\xA4n [31mred");
  EXPECT_EQ(map->structures()[2].name, "");
  EXPECT_NE(map->structures()[1].colour, map->structures()[2].colour);
  using Set = std::vector<std::uint8_t>;
  EXPECT_EQ(setAt(*map, 0), Set{0});
  EXPECT_EQ(setAt(*map, 2), (Set{0, 1}));
  EXPECT_EQ(setAt(*map, 20), Set{1});
  EXPECT_EQ(setAt(*map, 7), Set{2});
  EXPECT_EQ(setAt(*map, 8), Set{});
  EXPECT_EQ(map->structures()[0].voxels, 4);
  EXPECT_EQ(map->structures()[1].voxels, 3);
  EXPECT_EQ(map->structures()[2].voxels, 1);
}

TEST(Labels, ANumberThatNoSegmentHasIsAStructureWithoutAName) {
  Workshop workshop;
  auto voxels = marked({0, 1}, 4);
  voxels[9] = 2;
  const auto map =
      readLabels(workshop.write("a.seg.nrrd",
                                segOf("Segment0_Name:=sinus\nSegment0_LabelValue:=2\n", {voxels})),
                 scanOn(smallGrid()));
  ASSERT_TRUE(map) << sentence(map.error());
  ASSERT_EQ(map->structures().size(), 2U);
  EXPECT_EQ(map->structures()[0].name, "sinus");
  EXPECT_EQ(map->structures()[0].voxels, 1);
  EXPECT_EQ(map->structures()[1].name, "");
  EXPECT_EQ(map->structures()[1].voxels, 2);
}

TEST(Labels, BeforeThereWereLayersEachSegmentHadAVolume) {
  Workshop workshop;
  const std::string two = "Segment0_ID:=A\nSegment0_Name:=canal\nSegment1_ID:=B\n";
  const auto map =
      readLabels(workshop.write("old.seg.nrrd", segOf(two, {marked({4, 5}), marked({5, 6, 7})})),
                 scanOn(smallGrid()));
  ASSERT_TRUE(map) << sentence(map.error());
  ASSERT_EQ(map->structures().size(), 2U);
  EXPECT_EQ(map->structures()[0].voxels, 2);
  EXPECT_EQ(map->structures()[1].voxels, 3);
  EXPECT_EQ(setAt(*map, 5).size(), 2U);
}

TEST(Labels, WithoutNamesEachNumberIsAStructure) {
  Workshop workshop;
  auto voxels = marked({0, 1}, 200);
  voxels[9] = 3;
  const auto map =
      readLabels(workshop.write("plain.nrrd", segOf("", {voxels})), scanOn(smallGrid()));
  ASSERT_TRUE(map) << sentence(map.error());
  ASSERT_EQ(map->structures().size(), 2U);  // 3 and 200
  EXPECT_EQ(setAt(*map, 9), std::vector<std::uint8_t>{0});
  EXPECT_EQ(setAt(*map, 0), std::vector<std::uint8_t>{1});
}

TEST(Labels, WhatIsNoneOrDoesNotBelongToTheScanIsRefusedByName) {
  Workshop workshop;
  const haptics::Volume scan = scanOn(smallGrid());
  int number = 0;
  const auto reasonFor = [&](const std::string& bytes, const haptics::Volume& over) {
    return reasonOf(readLabels(workshop.write(std::to_string(++number) + ".nrrd", bytes), over));
  };
  EXPECT_EQ(reasonFor(segOf("", {marked({})}), scan), "labels-none");
  EXPECT_EQ(reasonFor(segOf("Segment0_ID:=a\nSegment1_ID:=b\nSegment0_LabelValue:=1\n"
                            "Segment1_LabelValue:=1\n",
                            {marked({1})}),
                      scan),
            "bad-header");
  for (const char* number_that_is_none : {"1.5", "one", "0", "-1", ""})
    EXPECT_EQ(
        reasonFor(
            segOf("Segment0_ID:=a\nSegment0_LabelValue:=" + std::string(number_that_is_none) + "\n",
                  {marked({1})}),
            scan),
        "bad-header")
        << number_that_is_none;
  Grid away = smallGrid();
  away.origin = {0.5, 0.0, 0.0};
  EXPECT_EQ(reasonFor(segOf("", {marked({1})}), scanOn(away)), "labels-elsewhere");
  EXPECT_EQ(reasonFor(segOf("", {marked({1})}), scanOn(away, false)), "orientation-unknown");

  // with the same voxels nothing has to be known of where they lie
  EXPECT_EQ(reasonFor(segOf("", {marked({1})}), scanOn(smallGrid(), false)), "");
  const auto made = [&](const std::string& type, const std::string& voxels) {
    return "NRRD0004\ntype: " + type +
           "\ndimension: 3\nspace: left-posterior-superior\nsizes: 4 3 100\n"
           "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nendian: little\n"
           "encoding: ascii\n\n" +
           voxels;
  };
  std::string many, halves;
  for (int n = 0; n < 1200; ++n) {
    many += std::to_string(n % 300) + " ";
    halves += n == 700 ? "0.5 " : "1 ";
  }
  EXPECT_EQ(reasonFor(made("short", many), scan), "labels-too-many");
  EXPECT_EQ(reasonFor(made("float", halves), scan), "not-labels");
  for (const char* odd : {"nan ", "1e20 "}) {
    std::string voxels = odd;
    for (int n = 1; n < 1200; ++n) voxels += "1 ";
    EXPECT_EQ(reasonFor(made("float", voxels), scan), "not-labels") << odd;
  }
  EXPECT_EQ(reasonFor("no volume", scan), "bad-header");
  EXPECT_EQ(reasonOf(readLabels(workshop.write("solid.off", "solid"), scan)), "not-labels");
  EXPECT_EQ(reasonOf(readLabels(workshop.write("solid.stl", "solid").parent_path(), scan)),
            "not-labels");
  EXPECT_EQ(reasonOf(readLabels(workshop.write("x", "").parent_path() / "none.nrrd", scan)),
            "unreadable");
  EXPECT_EQ(
      reasonFor(segOf("Segment0_ID:=a\nSegment0_LabelValue:=1\nSegment0_Layer:=1\n", {marked({1})}),
                scan),
      "bad-header");
}

TEST(Labels, ATableNamesNumbers) {
  Workshop workshop;
  auto voxels = marked({0, 1}, 17);
  voxels[9] = 3;
  voxels[10] = 5;
  const auto labels = workshop.write("plain.nrrd", segOf("", {voxels}));
  // each from its own program's manual, with a name that has a blank where it may have one
  const std::map<std::string, std::string> tables{
      {"a.ctbl",
       "# Color table file C:\\x.ctbl\n# 3 values\n0 Background 0 0 0 0\n3 facial nerve 255 51 0 "
       "255\n"
       "17 sinus 0 102 255 255\n"},
      {"b.label",
       "################\n# ITK-SnAP Label Description File\n# IDX   -R-  -G-  -B-  -A--  VIS MSH "
       " LABEL\n    0     0    0    0        0  0  0    \"Clear Label\"\n    3   255   51    0     "
       " "
       "  1  1  1    \"facial nerve\"\n   17     0  102  255     0.5  0  1    \"sinus\"\n"},
      {"LUT.txt",
       "\xEF\xBB\xBF#No. Label Name:   R   G   B   A\r\n\r\n0   Unknown    0   0   0   0\r\n3   "
       "facial "
       "nerve   255 51  0 0\r\n17  sinus   0 102 255  0\r\n"}};
  for (const auto& [name, text] : tables) {
    const auto map =
        readLabels(labels, scanOn(smallGrid()), {}, {.table = workshop.write(name, text)});
    ASSERT_TRUE(map) << sentence(map.error());
    ASSERT_EQ(map->structures().size(), 3U);
    EXPECT_EQ(map->structures()[0].name, "facial nerve") << name;
    EXPECT_EQ(map->structures()[0].colour, (std::array{1.0, 0.2, 0.0})) << name;
    EXPECT_EQ(map->structures()[1].name, "") << name;  // 5
    EXPECT_EQ(map->structures()[2].name, "sinus") << name;
    EXPECT_EQ(map->structures()[2].colour, (std::array{0.0, 0.4, 1.0})) << name;
    EXPECT_EQ(map->structures()[2].voxels, 2) << name;
  }
  // what the file names itself keeps its name
  const auto named = workshop.write(
      "named.seg.nrrd", segOf("Segment0_Name:=canal\nSegment0_LabelValue:=3\n", {voxels}));
  const auto map = readLabels(named, scanOn(smallGrid()), {},
                              {.table = workshop.write("c.ctbl", tables.at("a.ctbl"))});
  ASSERT_TRUE(map) << sentence(map.error());
  EXPECT_EQ(map->structures()[0].name, "canal");
  EXPECT_EQ(map->structures()[2].name, "sinus");
}

TEST(Labels, ATableThatIsNoneIsRefusedByItsLine) {
  Workshop workshop;
  const auto labels = workshop.write("plain.nrrd", segOf("", {marked({1})}));
  const auto said = [&](const std::string& text) {
    const auto map =
        readLabels(labels, scanOn(smallGrid()), {}, {.table = workshop.write("t.ctbl", text)});
    return map ? "" : map.error().reason + ": " + sentence(map.error());
  };
  for (const char* line :
       {"x", "1 nerve", "1 nerve 255 0 0", "1.5 nerve 255 0 0 255", "-1 nerve 255 0 0 255",
        "1 nerve 256 0 0 255", "1 nerve 255 -1 0 255", "1 nerve 255 0 nan 255",
        "nerve 1 255 0 0 255", "1 255 0 0 255 1 \"nerve\"", "1 \"nerve 255 0 0 255",
        "0x1 nerve 255 0 0 255", "1 nerve 255,0,0,255", "\x1B\x01\x02"}) {
    const std::string sentence = said("# a\n0 none 0 0 0 0\n" + std::string(line) + "\n");
    EXPECT_TRUE(sentence.starts_with("bad-header") && sentence.find("Line 3 of") != sentence.npos)
        << line << " -> " << sentence;
  }
  EXPECT_TRUE(
      said("1 a 0 0 0 0\n2 b 0 0 0 0\n1 c 0 0 0 0").find("Line 3 of \"t.ctbl\" names a number") !=
      std::string::npos);
  EXPECT_TRUE(said("# nothing\n").starts_with("bad-header"));
  EXPECT_TRUE(said(std::string(1'100'000, '#')).starts_with("too-large"));
  EXPECT_EQ(reasonOf(readLabels(labels, scanOn(smallGrid()), {}, {.table = workshop.folder()})),
            "unreadable");
}

TEST(Labels, ASegmentationIsNoScanAndIsFoundBesideOne) {
  Workshop workshop;
  const std::string segments =
      segOf("Segment0_ID:=a\nSegment1_ID:=b\n", {marked({1}), marked({2})});
  const auto alone = workshop.write("alone/a.seg.nrrd", segments);
  for (const auto& path : {alone, alone.parent_path()}) {
    const auto refused = survey(path);
    ASSERT_FALSE(refused) << path;
    EXPECT_EQ(refused.error().reason, "no-pixels");
    EXPECT_NE(sentence(refused.error()).find("open the scan first"), std::string::npos);
    EXPECT_FALSE(readVolume(path));
  }
  EXPECT_TRUE(isStructures(alone));
  ASSERT_TRUE(survey(alone, {}, true));
  EXPECT_EQ(survey(alone, {}, true)->series.size(), 2U);

  const auto scan = workshop.write("both/scan.nrrd", segOf("", {marked({3})}));
  workshop.write("both/below/a.seg.nrrd", segments);
  EXPECT_FALSE(isStructures(scan));
  const auto both = survey(scan.parent_path());
  ASSERT_TRUE(both) << sentence(both.error());
  EXPECT_EQ(both->series.size(), 1U);
  ASSERT_EQ(both->structures.size(), 1U);
  EXPECT_EQ(both->structures[0].name, "below/a.seg.nrrd");
  EXPECT_EQ(both->structures[0].kind, StructuresFound::Kind::Segments);
  const auto map = readLabels(both->structures[0].path, scanOn(smallGrid()));
  ASSERT_TRUE(map) << sentence(map.error());
  EXPECT_EQ(map->structures().size(), 2U);
}

TEST(Labels, ATableOfTheirNameIsUsedByItself) {
  const std::string nerve = "3 nerve 255 51 0 255\n", canal = "3 canal 0 0 255 255\n";
  Nifti nifti;
  nifti.dim = {3, 4, 3, 2, 1, 1, 1, 1};
  nifti.quaternion_code = 1;
  nifti.quaternion = {0, 0, 1};
  nifti.voxels = std::string(48, '\0');
  nifti.voxels[8] = 3;
  struct Said {
    std::string name;
    std::size_t notes;
    bool operator==(const Said&) const = default;
  };
  using Files = std::vector<std::pair<std::string, std::string>>;
  const auto said = [&](const std::string& labels, const Files& beside, const char* table = "") {
    Workshop workshop;
    for (const auto& [name, text] : beside) workshop.write(name, text);
    const auto map = readLabels(
        workshop.write(labels, labels.ends_with(".nrrd")
                                   ? segOf(labels.find(".seg") == labels.npos
                                               ? ""
                                               : "Segment0_Name:=sinus\nSegment0_LabelValue:=3\n",
                                           {marked({4}, 3)})
                                   : bytesOf(nifti)),
        scanOn(smallGrid()), {}, {.table = *table == '\0' ? "" : workshop.folder() / table});
    if (!map) return Said{sentence(map.error()), 99};
    for (const haptics::Message& note : map->notes())
      EXPECT_NE(sentence(note).find("Line 1 of \"l.ctbl\""), std::string::npos) << sentence(note);
    return Said{map->structures().at(0).name, map->notes().size()};
  };
  EXPECT_EQ(said("l.nrrd", {{"l.ctbl", nerve}}), (Said{"nerve", 0}));
  EXPECT_EQ(said("l.nii", {{"l.label", "3 255 51 0 1 1 1 \"nerve\"\n"}}), (Said{"nerve", 0}));
  EXPECT_EQ(said("l.nrrd", {{"l.txt", nerve}}), (Said{"nerve", 0}));
  EXPECT_EQ(said("l.nrrd", {{"l.ctbl", canal}, {"l.txt", nerve}}), (Said{"canal", 0}));
  // what is of another file, what was asked for, and what the file says itself
  EXPECT_EQ(said("l.nrrd", {{"k.ctbl", nerve}}), (Said{"", 0}));
  EXPECT_EQ(said("l.nrrd", {{"k.ctbl", nerve}, {"l.ctbl", canal}}, "k.ctbl"), (Said{"nerve", 0}));
  EXPECT_EQ(said("l.seg.nrrd", {{"l.seg.ctbl", nerve}, {"l.ctbl", nerve}}), (Said{"sinus", 0}));
  // one that cannot be read prevents nothing; any text may be called .txt
  EXPECT_EQ(said("l.nrrd", {{"l.ctbl", "none\n"}}), (Said{"", 1}));
  EXPECT_EQ(said("l.nrrd", {{"l.txt", "seen on Monday\n"}}), (Said{"", 0}));
  EXPECT_EQ(said("l.nrrd", {{"l.ctbl", "none\n"}, {"l.label", nerve}}), (Said{"nerve", 1}));
  EXPECT_EQ(said("l.nrrd", {{"l.ctbl/in", ""}}), (Said{"", 0}));
}

TEST(Labels, WhatLiesOutsideTheScanIsCountedAndNoted) {
  Workshop workshop;
  auto voxels = marked({0, 4, 8, 12, 16, 20});  // all of the first column
  voxels[2] = voxels[6] = 2;
  const auto path = workshop.write("l.nrrd", segOf("", {voxels}));
  for (const auto& [shift_mm, outside] :
       {std::pair{0.0, 0}, std::pair{0.4, 0}, std::pair{-0.4, 0}, std::pair{1.0, 6}}) {
    Grid grid = smallGrid();
    grid.origin.x() += 1e-3 * shift_mm;
    const auto map = readLabels(path, scanOn(grid));
    ASSERT_TRUE(map) << sentence(map.error());
    EXPECT_EQ(map->structures()[0].outside, outside) << shift_mm;
    EXPECT_EQ(map->structures()[1].outside, 0) << shift_mm;
    std::string said;
    for (const haptics::Message& note : map->notes()) said += sentence(note);
    EXPECT_EQ(said, outside == 0 ? ""
                                 : "75 % of what \"l.nrrd\" marks lies outside the scan; is it of "
                                   "this scan?");
  }
}

TEST(Labels, DamagedOnesAreRefusedWithASentence) {
  const std::string keys =
      "Segment0_ID:=Segment_1\nSegment0_Name:=nerve\nSegment0_Color:=1 0.5 0.25\n"
      "Segment0_Extent:=0 3 0 2 0 1\nSegment0_LabelValue:=5\nSegment0_Layer:=0\n";
  Nifti nifti;
  nifti.dim = {3, 4, 3, 2, 1, 1, 1, 1};
  nifti.quaternion_code = 1;
  nifti.quaternion = {0, 0, 1};  // to the left and back, as the scan
  nifti.voxels = std::string(48, '\0');
  nifti.voxels[8] = 3;
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.seg.nrrd", segOf(keys, {marked({0, 1}, 5)})},
      {"b.seg.nrrd", segOf(keys, {marked({0, 1}, 5), marked({2, 20})})},
      {"a.nii", bytesOf(nifti)}};
  Workshop workshop;
  for (const auto& [name, bytes] : files) {
    const auto map = readLabels(workshop.write(name, bytes), scanOn(smallGrid()));
    ASSERT_TRUE(map) << sentence(map.error());
  }
  expectDamagedRefused(files, 0);
}

TEST(Labels, AreCancelledWhileTheyArePut) {
  Workshop workshop;
  const auto path = workshop.write("plain.nrrd", segOf("", {marked({1})}));
  std::atomic<bool> cancel = false;
  double last = 0.0;
  const auto map = readLabels(path, scanOn(smallGrid()),
                              {[&](double f) {
                                 EXPECT_GE(f, last);
                                 last = f;
                                 cancel = f > 0.75;
                               },
                               &cancel});
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().kind, haptics::Error::Kind::Cancelled);
  EXPECT_LT(last, 0.9);
}

TEST(Labels, ANameIsPlainBoundedText) {
  EXPECT_EQ(shownName("  sigmoid\tsinus \n"), "sigmoid sinus");
  EXPECT_EQ(shownName("a\xC0\x80"      // overlong
                      "b\xED\xA0\x80"  // half of a pair
                      "c\xE2\x80\xAE"  // turns the direction
                      "d"),
            "a b c d");
  EXPECT_EQ(shownName("\xE2\x82\xAC\xF0\x9F\x9A\x80"), "\xE2\x82\xAC\xF0\x9F\x9A\x80");
  const std::string long_name = shownName(std::string(127, 'x') + "\xC3\xA4" + "y");
  EXPECT_EQ(long_name, std::string(127, 'x'));
}

}  // namespace
}  // namespace datasets
