// SPDX-License-Identifier: BSD-3-Clause
// DICOM that lies quietly: numbers, bits, copies, and slices that only look as if they belonged
// together.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "datasets/readers/dicom/numbers.h"
#include "datasets/readers/dicom/values.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using testing::DicomSlice;
using testing::edited;
using testing::Element;
using testing::element;
using testing::number;
using testing::reasonFor;
using testing::voxelAt;
using testing::Workshop;

/// Slices of 2 x 2 pixels, 1 mm apart from `first_mm` on, with these elements changed.
void writeStack(const Workshop& workshop, const std::string& name, int count, double first_mm,
                const std::vector<Element>& changes = {}, double step_mm = 1.0) {
  for (int k = 0; k < count; ++k) {
    DicomSlice slice;
    slice.columns = slice.rows = 2;
    slice.instance += "." + name + std::to_string(k + 1);
    slice.position_mm = {0, 0, first_mm + step_mm * k};
    slice.pixels = {1, 2, 3, std::int16_t(k)};
    workshop.write(name + std::to_string(k), edited(bytesOf(slice), changes));
  }
}

/// The slices of each series of a folder that can be loaded, fewest first.
std::vector<std::int64_t> soundSeries(const fs::path& folder) {
  std::vector<std::int64_t> slices;
  const auto found = survey(folder);
  if (!found) return slices;
  for (const SeriesVerdict& series : found->series)
    if (series.verdict == Verdict::Sound) slices.push_back(series.dims[2]);
  std::ranges::sort(slices);
  return slices;
}

TEST(DicomNumbers, AreThoseOfTheStandardAndNoOthers) {
  for (const auto& [text, value] :
       {std::pair{"1", 1.0}, std::pair{" -1.5 ", -1.5}, std::pair{"+2.5E3", 2500.0},
        std::pair{".5", 0.5}, std::pair{"7.", 7.0}, std::pair{"1e-3", 0.001},
        std::pair{"0.70710678118654752", 0.70710678118654752}})
    EXPECT_EQ(decimalString(text), value) << text;
  for (const char* text :
       {"",      " ",     "1,5", "1.5mm", "abc", "nan", "inf",   "-inf", "0x10", "1;5",
        "1 000", "1.2.3", "--1", "+-1",   "1e",  "e5",  "1e999", "1\\2", "1d3",  "'1"})
    EXPECT_FALSE(decimalString(text)) << text;
  EXPECT_EQ(integerString(" 12 "), 12);
  EXPECT_EQ(integerString("-3"), -3);
  for (const char* text : {"", "1.0", "1e3", "4294967296", "x", "1 2"})
    EXPECT_FALSE(integerString(text)) << text;
}

// planted: numbers read by prefix
TEST(DicomStrict, NumbersInAnotherNotationAreRefused) {
  const auto refused = [](unsigned group, unsigned tag, const std::string& text) {
    Workshop workshop;
    writeStack(workshop, "s", 2, 0.0, {{group, tag, "DS", text}});
    const auto v = readVolume(workshop.folder());
    return !v && v.error().reason == "bad-header" &&
           sentence(v.error()).find('"') != std::string::npos;
  };
  for (const char* spacing : {"1,5\\1,5", "1.5", "1.5\\", "1.5\\1.5\\1.5", "nan\\1", "1 .5\\1.5"})
    EXPECT_TRUE(refused(0x28, 0x30, spacing)) << spacing;
  for (const char* one : {"1,5", "abc", "nan", "0x10", "1;5", "1 000", "1\\2"}) {
    EXPECT_TRUE(refused(0x28, 0x1053, one)) << "slope " << one;
    EXPECT_TRUE(refused(0x28, 0x1052, one)) << "intercept " << one;
    EXPECT_FALSE(refused(0x18, 0x50, one)) << "thickness, which nobody needs: " << one;
    EXPECT_TRUE(refused(0x20, 0x32, "0\\0\\" + std::string(one))) << "position " << one;
    EXPECT_TRUE(refused(0x20, 0x37, "1\\0\\0\\0\\1\\" + std::string(one))) << "direction " << one;
  }
  EXPECT_TRUE(refused(0x28, 8, "1,0")) << "frames";
}

TEST(DicomStrict, PlacesThatNoScanHasAreRefused) {
  for (const auto& [tag, text] :
       {std::pair{0x30u, "900000\\900000"}, std::pair{0x32u, "0\\0\\1e15"}}) {
    Workshop workshop;
    writeStack(workshop, "s", 1, 0.0, {{tag == 0x30u ? 0x28u : 0x20u, tag, "DS", text}});
    EXPECT_EQ(reasonFor(workshop.folder()), "bad-header");
    EXPECT_TRUE(soundSeries(workshop.folder()).empty());
  }
}

TEST(DicomStrict, ASlopeWithoutAnInterceptIsRefused) {
  Workshop workshop;
  writeStack(workshop, "s", 2, 0.0, {{0x28, 0x1052, "", ""}});
  EXPECT_EQ(reasonFor(workshop.folder()), "bad-header");
}

TEST(DicomStrict, AModalityTableIsRefused) {
  Workshop workshop;
  // the sequence follows the pixels' description, in an item of no element
  DicomSlice slice;
  slice.pixels = {1};
  std::string bytes = edited(bytesOf(slice), {{0x28, 0x1052, "", ""}, {0x28, 0x1053, "", ""}});
  const auto pixels = bytes.rfind(number(0x7fe0, 2) + number(0x10, 2));
  const std::string item = number(0xe000fffe, 4) + number(0, 4);
  bytes.insert(pixels, number(0x28, 2) + number(0x3000, 2) + "SQ" + number(0, 2) +
                           number(item.size(), 4) + item);
  EXPECT_EQ(reasonFor(workshop.write("s", bytes)), "unsupported-type");
}

TEST(DicomStrict, ItIsKnownWhatTheBitsMean) {
  const auto reason = [](const std::vector<Element>& changes) {
    Workshop workshop;
    writeStack(workshop, "s", 2, 0.0, changes);
    return reasonFor(workshop.folder());
  };
  const auto us = [](unsigned tag, unsigned value) {
    return Element{0x28, tag, "US", number(value, 2)};
  };
  EXPECT_EQ(reason({}), "");
  EXPECT_EQ(reason({{0x28, 0x103, "", ""}}), "bad-header");  // with or without a sign
  EXPECT_EQ(reason({us(0x101, 0)}), "bad-header");
  EXPECT_EQ(reason({us(0x101, 17)}), "bad-header");
  EXPECT_EQ(reason({us(0x101, 12), us(0x102, 10)}), "bad-header");
  EXPECT_EQ(reason({us(0x101, 12), us(0x102, 16)}), "bad-header");
}

TEST(DicomStrict, TheStoredBitsAreTakenFromTheirPlace) {
  // 12 bits from bit 4 on, and from bit 0 on with rubbish above
  const auto values = [](int high_bit, bool is_signed, const std::vector<std::int16_t>& pixels) {
    Workshop workshop;
    DicomSlice slice;
    slice.columns = 4;
    slice.pixels = pixels;
    slice.padding = {-32768};
    const auto path = workshop.write(
        "s", edited(bytesOf(slice), {{0x28, 0x101, "US", number(12, 2)},
                                     {0x28, 0x102, "US", number(std::size_t(high_bit), 2)},
                                     {0x28, 0x103, "US", number(is_signed ? 1 : 0, 2)}}));
    std::vector<double> read;
    const auto v = readVolume(path);
    for (int i = 0; v && i < 4; ++i) read.push_back(voxelAt(*v, i, 0, 0));
    return read;
  };
  using V = std::vector<double>;
  EXPECT_EQ(values(15, false, {0x0010, 0x7ff0, std::int16_t(0xfff0), 0x00ff}),
            (V{1, 0x7ff, 0xfff, 15}));
  EXPECT_EQ(values(15, true, {0x0010, 0x7ff0, std::int16_t(0xfff0), std::int16_t(0x8010)}),
            (V{1, 0x7ff, -1, -2047}));
  EXPECT_EQ(values(11, false, {0x0001, 0x0fff, std::int16_t(0xf001), 0x7001}), (V{1, 0xfff, 1, 1}));
  EXPECT_EQ(values(11, true, {0x0001, 0x0fff, 0x7001, -5}), (V{1, -1, 1, -5}));
  // padding is a word as a whole: it is the least of the others
  EXPECT_EQ(values(11, true, {0x0001, -100, 7, -32768}), (V{1, -100, 7, -100}));
}

// planted: bits above the stored ones that nobody looks at
TEST(DicomStrict, ValuesBeyondTheStoredBitsAreCounted) {
  const auto beyond = [](const char* name, std::vector<std::int16_t> pixels, bool with_sign) {
    Workshop workshop;
    DicomSlice slice;
    slice.columns = int(pixels.size());
    slice.pixels = std::move(pixels);
    const auto path = workshop.write(
        name, edited(bytesOf(slice), {{0x28, 0x101, "US", number(12, 2)},
                                      {0x28, 0x102, "US", number(11, 2)},
                                      {0x28, 0x103, "US", number(with_sign ? 1 : 0, 2)}}));
    const auto v = readVolume(path);
    EXPECT_TRUE(v) << sentence(v.error());
    return v ? v->beyond_bits : -1;
  };
  EXPECT_EQ(beyond("enamel", {-1024, 0, 2900, 3000, 2047}, true), 2);
  EXPECT_EQ(beyond("sound", {-1024, 0, 2047, -2048}, true), 0);
  EXPECT_EQ(beyond("bare", {0x0c00, 0, 0x0fff}, true), 0);  // a file that extends no sign
  EXPECT_EQ(beyond("unsigned", {4095, 4096, 5000, 0}, false), 2);
}

TEST(DicomStrict, PaddingThatIsEmptyIsNone) {
  Workshop workshop;
  writeStack(workshop, "s", 2, 0.0, {{0x28, 0x120, "SS", ""}, {0x28, 0x103, "US", number(1, 2)}});
  const auto v = readVolume(workshop.folder());
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->padded, 0);
  EXPECT_EQ(voxelAt(*v, 1, 1, 0), 0.0);
  // nor does an empty sign mean none
  writeStack(workshop, "s", 2, 0.0, {{0x28, 0x103, "US", ""}});
  EXPECT_EQ(reasonFor(workshop.folder()), "bad-header");
}

TEST(DicomStrict, WhatLossSwingsBeyondTheStoredBitsStaysAtTheirEnd) {
  DicomFile file;
  file.plane.columns = 3;
  file.plane.rows = 1;
  file.bits_allocated = 16;
  file.bits_stored = 12;
  file.high_bit = 11;
  const std::array<std::uint16_t, 3> decoded{4095, 4097, 0};
  const Pixels pixels{haptics::ScalarType::UInt16, decoded.data()};
  std::vector<std::byte> room;
  const auto second = [&] {
    UpperBits upper;
    return static_cast<const std::uint16_t*>(settled(pixels, file, room, upper).first)[1];
  };
  file.syntax = "1.2.840.10008.1.2.4.81";
  EXPECT_EQ(second(), 4095);
  file.syntax = "1.2.840.10008.1.2.4.80";
  EXPECT_EQ(second(), 1);  // without loss, bits above mean something else
}

TEST(DicomStrict, OneIdentifierForAllImagesLosesNone) {
  Workshop workshop;
  writeStack(workshop, "s", 3, 0.0, {{8, 0x18, "UI", "1.2.3.4.5"}});
  for (const fs::path& path : {workshop.folder(), workshop.folder() / "s1"}) {
    const auto v = readVolume(path);
    ASSERT_TRUE(v) << sentence(v.error());
    EXPECT_EQ(v->grid.dims[2], 3);
  }
  // nor is one that is damaged a copy of another
  const auto last = workshop.folder() / "s2";
  fs::resize_file(last, fs::file_size(last) - 4);
  EXPECT_EQ(reasonFor(workshop.folder()), "truncated");
}

// planted: a patient that is not compared
TEST(DicomStrict, SlicesOfTwoAreNoStackOfOne) {
  const Element modality_mr{8, 0x60, "CS", "MR"};
  const std::vector<std::pair<const char*, std::pair<Element, Element>>> kinds{
      {"patient", {{0x10, 0x20, "LO", "A1"}, {0x10, 0x20, "LO", "B2"}}},
      {"name", {{0x10, 0x10, "PN", "A^A"}, {0x10, 0x10, "PN", "B^B"}}},
      {"study", {{0x20, 0xd, "UI", "1.2"}, {0x20, 0xd, "UI", "1.3"}}},
      {"modality", {{8, 0x60, "CS", "CT"}, modality_mr}}};
  for (const bool blank_series : {false, true})
    for (const auto& [kind, pair] : kinds) {
      Workshop workshop;
      const Element series{0x20, 0xe, "UI", blank_series ? "" : "1.2.3"};
      // one after the other, and between each other
      writeStack(workshop, "a", 3, 0.0, {series, pair.first});
      writeStack(workshop, "b", 4, 3.0, {series, pair.second});
      EXPECT_EQ(soundSeries(workshop.folder()), (std::vector<std::int64_t>{3, 4})) << kind;
      EXPECT_EQ(reasonFor(workshop.folder()), "which-series") << kind;
      if (!blank_series) {
        const auto v = readVolume(workshop.folder() / "b0");
        ASSERT_TRUE(v) << sentence(v.error());
        EXPECT_EQ(v->grid.dims[2], 4) << kind;
      }
    }
}

TEST(DicomStrict, AcquisitionsAreOneStackOrApart) {
  const auto taken = [](const char* number) { return Element{0x20, 0x12, "IS", number}; };
  {
    Workshop workshop;  // interleaved: even together
    writeStack(workshop, "a", 4, 0.0, {taken("1")}, 2.0);
    writeStack(workshop, "b", 3, 1.0, {taken("2")}, 2.0);
    EXPECT_EQ(soundSeries(workshop.folder()), std::vector<std::int64_t>{7});
  }
  {
    Workshop workshop;  // between each other, even alone
    writeStack(workshop, "a", 4, 0.0, {taken("1")}, 2.0);
    writeStack(workshop, "b", 3, 0.6, {taken("2")}, 2.0);
    EXPECT_EQ(soundSeries(workshop.folder()), (std::vector<std::int64_t>{3, 4}));
  }
  {
    Workshop workshop;  // at the same places
    writeStack(workshop, "a", 4, 0.0, {taken("1")});
    writeStack(workshop, "b", 4, 0.0, {taken("2")});
    EXPECT_EQ(soundSeries(workshop.folder()), (std::vector<std::int64_t>{4, 4}));
  }
  {
    Workshop workshop;  // turns of a sequential scanner, one after the other
    for (int turn = 0; turn < 4; ++turn)
      writeStack(workshop, std::string(1, char('a' + turn)), 2, 2.0 * turn,
                 {taken(std::to_string(turn + 1).c_str())});
    EXPECT_EQ(soundSeries(workshop.folder()), std::vector<std::int64_t>{8});
  }
  {
    Workshop workshop;  // two regions: too much lies between them for lost slices
    writeStack(workshop, "a", 4, 0.0, {taken("1")});
    writeStack(workshop, "b", 5, 20.0, {taken("2")});
    EXPECT_EQ(soundSeries(workshop.folder()), (std::vector<std::int64_t>{4, 5}));
  }
  {
    Workshop workshop;  // a slice is lost where turns meet
    writeStack(workshop, "a", 4, 0.0, {taken("1")});
    writeStack(workshop, "b", 5, 5.0, {taken("2")});
    EXPECT_EQ(reasonFor(workshop.folder()), "missing-slices");
  }
  {
    Workshop workshop;  // between each other, and no even stacks
    writeStack(workshop, "a", 3, 0.0, {taken("1")});
    writeStack(workshop, "b", 2, 3.3, {taken("2")});
    writeStack(workshop, "c", 1, 5.0, {taken("1")});
    EXPECT_EQ(reasonFor(workshop.folder()), "mixed-acquisitions");
  }
}

TEST(DicomStrict, ABrokenSliceIsMissedByItsSeries) {
  Workshop workshop;
  writeStack(workshop, "s", 4, 0.0, {{0x10, 0x20, "LO", "A1"}});
  // the last of the stack: without it, the rest would be even
  const auto last = workshop.folder() / "s3";
  fs::resize_file(last, fs::file_size(last) - 4);
  EXPECT_EQ(reasonFor(workshop.folder()), "truncated");
}

TEST(DicomStrict, ACopyInTextModeIsRefused) {
  Workshop workshop;
  DicomSlice slice;
  slice.columns = 4;
  slice.pixels = {0x0a01, 0x0a0a, 5, 0x0a00};
  std::string bytes = bytesOf(slice), copy;
  EXPECT_EQ(reasonFor(workshop.write("binary/s", bytes)), "");
  const std::size_t pixels = bytes.size() - 8;
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    if (n >= pixels && bytes[n] == '\n') copy += '\r';
    copy += bytes[n];
  }
  const auto v = readVolume(workshop.write("text/s", copy));
  ASSERT_FALSE(v);
  EXPECT_NE(sentence(v.error()).find("as if it were text"), std::string::npos)
      << sentence(v.error());
  EXPECT_EQ(reasonFor(workshop.write("more/s", bytes + "junk")), "truncated");
  EXPECT_EQ(reasonFor(workshop.write("zeros/s", bytes + std::string(2, '\0'))), "");
}

TEST(DicomStrict, ADamagedFileBesideASeriesIsToldFromThatSeries) {
  Workshop workshop;
  writeStack(workshop, "s", 3, 0.0);
  std::string damaged = bytesOf(DicomSlice{});
  // a header that breaks off before it names its series
  workshop.write("torn", damaged.substr(0, damaged.rfind("1.2.840.10008.5.1.4.1.1.2") + 12));
  const auto counts = [](const SeriesVerdict& series) {
    return sentence(series.message)
               .find("Damaged DICOM files beside the slices, which may belong to them: 1;") !=
           std::string::npos;
  };
  const auto all = survey(workshop.folder());
  ASSERT_TRUE(all) << sentence(all.error());
  ASSERT_EQ(all->series.size(), 2u);
  int sound = 0;
  for (const SeriesVerdict& series : all->series) {
    sound += series.verdict == Verdict::Sound ? 1 : 0;
    EXPECT_EQ(counts(series), series.verdict == Verdict::Sound) << sentence(series.message);
  }
  EXPECT_EQ(sound, 1);
  const auto named = survey(workshop.folder() / "s1");
  ASSERT_TRUE(named) << sentence(named.error());
  EXPECT_TRUE(counts(named->series.front())) << sentence(named->series.front().message);
}

TEST(DicomStrict, AnIndexStandsForItsFolder) {
  Workshop workshop;
  writeStack(workshop, "images/s", 3, 0.0);
  std::string index = bytesOf(DicomSlice{});
  index.replace(index.find("1.2.840.10008.5.1.4.1.1.2"), 25,
                std::string("1.2.840.10008.1.3.10") + std::string(5, '\0'));
  workshop.write("DICOMDIR", index);
  const auto v = readVolume(workshop.folder() / "DICOMDIR");
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->grid.dims[2], 3);
}

TEST(DicomStrict, AFileThatMayNotBeReadIsSaidToBeThat) {
  Workshop workshop;
  writeStack(workshop, "s", 3, 0.0);
  fs::permissions(workshop.folder(), fs::perms::all);
  for (int k = 0; k < 3; ++k)
    fs::permissions(workshop.folder() / ("s" + std::to_string(k)), fs::perms::all);
  fs::permissions(workshop.folder() / "s2", fs::perms::none);
  // root may read all: a child without its rights looks
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr uid_t kNobody = 65'534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(9);
    const auto one = readVolume(workshop.folder() / "s2");
    const auto all = survey(workshop.folder());
    const bool said = !one && sentence(one.error()).find("may not be read") != std::string::npos;
    const bool warned =
        all && all->series.size() == 1 &&
        sentence(all->series.front().message)
                .find("Files beside the slices that may not be read: 1;") != std::string::npos;
    _exit((said ? 0 : 1) + (warned ? 0 : 2));
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace datasets
