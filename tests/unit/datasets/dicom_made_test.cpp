// SPDX-License-Identifier: BSD-3-Clause
// DICOM files made here, for what no scan at hand has.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using testing::asBigEndian;
using testing::asImplicit;
using testing::dataSetOf;
using testing::DicomSlice;
using testing::element;
using testing::reasonFor;
using testing::voxelAt;
using testing::Workshop;

/// Slices of one voxel, each its own image, at these heights; their value is their number.
void writeSlices(const Workshop& workshop, const std::vector<double>& heights_mm) {
  for (std::size_t k = 0; k < heights_mm.size(); ++k) {
    DicomSlice slice;
    slice.instance += "." + std::to_string(k + 1);
    slice.position_mm = {0, 0, heights_mm[k]};
    slice.pixels = {std::int16_t(k)};
    workshop.write(std::to_string(k), bytesOf(slice));
  }
}

TEST(DicomReader, ACopyOfASliceIsLeftOutAndSaid) {
  Workshop workshop;
  writeSlices(workshop, {0, 1, 2, 3});
  fs::copy_file(workshop.folder() / "2", workshop.folder() / "copy");
  const auto v = readVolume(workshop.folder());
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->grid.dims[2], 4);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(voxelAt(*v, 0, 0, k), k);
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said);
  EXPECT_EQ(said->series.at(0).verdict, Verdict::Sound);
  EXPECT_EQ(said->series.at(0).reasons, std::vector<std::string>{"duplicate"});
  EXPECT_NE(sentence(said->series.at(0).message)
                .find("copies of its slices in the folder are left out: 1."),
            std::string::npos);
  // of a copy that is cut off the other is taken, whichever comes first
  fs::resize_file(workshop.folder() / "2", fs::file_size(workshop.folder() / "2") - 1);
  EXPECT_EQ(reasonFor(workshop.folder()), "");
}

TEST(DicomReader, OfASeriesThatLacksSlicesTheLargestPartIsReadIfTheUserAgrees) {
  Workshop workshop;
  writeSlices(workshop, {10, 11, 12, 14, 15, 16, 17.004, 20, 21});
  EXPECT_EQ(reasonFor(workshop.folder()), "missing-slices");
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said);
  const SeriesVerdict& series = said->series.at(0);
  EXPECT_EQ(series.verdict, Verdict::Refused);
  ASSERT_TRUE(series.unbroken_part);
  EXPECT_EQ(series.unbroken_part->slices, 4);
  EXPECT_EQ(series.unbroken_part->of, 9);
  EXPECT_NEAR(series.unbroken_part->from_mm, 14.0, 1e-9);
  EXPECT_NEAR(series.unbroken_part->to_mm, 17.004, 1e-9);
  EXPECT_NE(sentence(series.message).find("4 of the 9 slices that are there, from 14.0 to 17.0 mm"),
            std::string::npos)
      << sentence(series.message);
  // never without being told to
  EXPECT_FALSE(readVolume(series));
  const auto v = readVolume(series, {.largest_part = true});
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->slices_left_out, 5);
  EXPECT_EQ(v->grid.dims[2], 4);
  // its own positions, and nothing made up
  EXPECT_NEAR(1e3 * v->grid.origin.z(), 14.0, 1e-9);
  EXPECT_NEAR(1e3 * v->grid.spacing.z(), 3.004 / 3.0, 1e-9);
  EXPECT_FALSE(v->resampled);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(voxelAt(*v, 0, 0, k), 3 + k);
  const auto by_path = readVolume(workshop.folder(), {.largest_part = true});
  ASSERT_TRUE(by_path) << sentence(by_path.error());
  EXPECT_EQ(by_path->grid.dims[2], 4);
}

TEST(DicomReader, OfASoundSeriesTheLargestPartIsAllOfIt) {
  Workshop workshop;
  writeSlices(workshop, {0, 1, 2});
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said);
  EXPECT_FALSE(said->series.at(0).unbroken_part);
  const auto v = readVolume(workshop.folder(), {.largest_part = true});
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->grid.dims[2], 3);
  EXPECT_EQ(v->slices_left_out, 0);
}

TEST(DicomReader, OfATiltedSeriesThatLacksSlicesNoPartIsOffered) {
  Workshop workshop;
  int number = 0;
  for (const double h : {0, 1, 2, 4, 5, 6}) {
    DicomSlice slice;
    slice.instance += "." + std::to_string(++number);
    slice.position_mm = {0, 0.2 * h, h};
    slice.pixels = {0};
    workshop.write(std::to_string(number), bytesOf(slice));
  }
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said);
  EXPECT_EQ(said->series.at(0).reasons, std::vector<std::string>{"missing-slices"});
  EXPECT_FALSE(said->series.at(0).unbroken_part);
  EXPECT_EQ(reasonFor(workshop.folder()), "missing-slices");
}

TEST(DicomReader, TwoImagesAtOnePlaceAreNoStack) {
  Workshop workshop;
  writeSlices(workshop, {0, 1, 1});
  EXPECT_EQ(reasonFor(workshop.folder()), "duplicate");
  // but a file that is named stands for itself
  const auto v = readVolume(workshop.folder() / "2");
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(voxelAt(*v, 0, 0, 1), 2.0);
}

TEST(DicomReader, PaddingCountsAsAir) {
  Workshop workshop;
  for (int k = 0; k < 2; ++k) {
    DicomSlice slice;
    slice.instance += "." + std::to_string(k + 1);
    slice.position_mm = {0, 0, double(k)};
    slice.columns = 3;
    slice.rows = 2;
    slice.intercept = -24.0;
    slice.pixels = {-1000, -2000, 50, -1990, 300, -2001};
    // a single value in one slice, a range in the other
    slice.padding =
        k == 0 ? std::vector<std::int16_t>{-2000} : std::vector<std::int16_t>{-2000, -1990};
    workshop.write(std::to_string(k), bytesOf(slice));
  }
  const auto v = readVolume(workshop.folder());
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->padded, 3);
  EXPECT_EQ(v->unit, "HU");
  // -2001 is no padding: what is left is the least, and so the air
  const std::vector<double> first{-1024, -2025, 26, -2014, 276, -2025},
      second{-1024, -2025, 26, -2025, 276, -2025};
  for (int n = 0; n < 6; ++n) {
    EXPECT_EQ(voxelAt(*v, n % 3, n / 3, 0), first[std::size_t(n)]) << n;
    EXPECT_EQ(voxelAt(*v, n % 3, n / 3, 1), second[std::size_t(n)]) << n;
  }
}

TEST(DicomReader, PaddingThatTheVoxelsCannotHoldIsNoVoxel) {
  Workshop workshop;
  DicomSlice slice;
  slice.columns = 2;
  slice.intercept = 10.0;
  slice.pixels = {-10, 32757};
  slice.padding = {32760};  // beyond int16 once it is rescaled, and its end is a voxel
  const auto v = readVolume(workshop.write("a", bytesOf(slice)));
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->padded, 0);
  EXPECT_EQ(voxelAt(*v, 1, 0, 0), 32767.0);
  // where all is padding nothing is known to be air
  slice.series += ".2";
  slice.pixels = {7, 7};
  slice.padding = {7};
  const auto all = readVolume(workshop.write("b", bytesOf(slice)));
  ASSERT_TRUE(all) << sentence(all.error());
  EXPECT_EQ(all->padded, 0);
  EXPECT_EQ(voxelAt(*all, 1, 0, 0), 17.0);
}

TEST(DicomReader, FilesWithoutPreambleOrMetaHeaderAreRead) {
  DicomSlice slice;
  slice.columns = 2;
  slice.position_mm = {1, 2, 3};
  slice.pixels = {-5, 700};
  const std::string whole = bytesOf(slice);
  const std::string data = whole.substr(dataSetOf(whole));
  const std::vector<std::pair<std::string, std::string>> files{
      {"no preamble", whole.substr(128)},
      {"no preamble, no mark", whole.substr(132)},
      {"no meta header", data},
      {"no meta header, implicit", asImplicit(data)},
      {"no meta header, big endian", asBigEndian(data)},
      {"preamble, no meta header", whole.substr(0, 132) + data}};
  for (const auto& [what, bytes] : files) {
    SCOPED_TRACE(what);
    Workshop workshop;
    for (const fs::path& path : {workshop.write("slice", bytes), workshop.folder()}) {
      const auto v = readVolume(path);
      ASSERT_TRUE(v) << sentence(v.error());
      EXPECT_EQ(voxelAt(*v, 0, 0, 0), -5.0);
      EXPECT_EQ(voxelAt(*v, 1, 0, 0), 700.0);
      EXPECT_NEAR(v->grid.origin.z(), 3e-3, 1e-12);
    }
  }
}

TEST(DicomReader, LabelsAreInUtf8WhateverTheFileWasWrittenIn) {
  const auto labelsOf = [](const std::string& character_set, const std::string& patient,
                           const std::string& description) {
    DicomSlice slice;
    slice.pixels = {0};
    std::string bytes = bytesOf(slice);
    const std::size_t data = dataSetOf(bytes),
                      series = bytes.find(element(0x20, 0xe, "UI", "1.2.3.4"));
    const std::string names =
        element(8, 0x103e, "LO", description) + element(0x10, 0x10, "PN", patient);
    bytes.insert(series, names);
    bytes.insert(data, element(8, 5, "CS", character_set));
    Workshop workshop;
    return survey(workshop.write("slice", bytes))->series.at(0).labels;
  };
  const Labels latin = labelsOf("ISO_IR 100", "M\xfcller^J\xf6rg",
                                "Sch\xe4"
                                "del");
  EXPECT_EQ(latin.patient, "Müller^Jörg");
  EXPECT_EQ(latin.series, "Schädel");
  EXPECT_EQ(labelsOf("ISO_IR 192", "Müller", "Kopf").patient, "Müller");
  const Labels japanese = labelsOf("\\ISO 2022 IR 87", "Yamada=\033$B;3ED\033(B", "CT");
  EXPECT_EQ(japanese.patient, "Yamada=山田");
  EXPECT_EQ(labelsOf("ISO_IR 144", "\xbb\xee\xda\xd5\xdd\xda\xde", "").patient, "Люкенко");
}

TEST(DicomReader, WhatIsMeantToBeShownInvertedKeepsItsValues) {
  DicomSlice slice;
  slice.columns = 2;
  slice.pixels = {-5, 700};
  std::string bytes = bytesOf(slice);
  bytes.replace(bytes.find("MONOCHROME2"), 11, "MONOCHROME1");
  Workshop workshop;
  const fs::path path = workshop.write("slice", bytes);
  const auto v = readVolume(path);
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(voxelAt(*v, 0, 0, 0), -5.0);
  EXPECT_EQ(voxelAt(*v, 1, 0, 0), 700.0);
  const auto picture = thumbnailOf(survey(path)->series.at(0), 2);
  ASSERT_TRUE(picture) << sentence(picture.error());
  EXPECT_EQ(picture->grey, (std::vector<std::uint8_t>{255, 0}));
}

TEST(DicomReader, AFolderIsSearchedWithAllFoldersInIt) {
  Workshop workshop;
  const fs::path disk = workshop.folder() / "disk";
  DicomSlice slice;
  for (int k = 0; k < 4; ++k) {
    slice.instance = "1.2.3.4." + std::to_string(k);
    slice.position_mm = {0, 0, double(k)};
    slice.pixels = {std::int16_t(k)};
    workshop.write((k % 2 == 0 ? "disk/" : "disk/a/b/") + std::to_string(k), bytesOf(slice));
  }
  slice.series = "1.2.9";
  slice.instance = "1.2.9.1";
  workshop.write("elsewhere/0", bytesOf(slice));
  fs::create_directory_symlink(workshop.folder() / "elsewhere", disk / "link");
  workshop.write("disk/readme.txt", "no scan");
  const auto v = readVolume(disk);
  ASSERT_TRUE(v) << sentence(v.error());
  ASSERT_EQ(v->grid.dims[2], 4);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(voxelAt(*v, 0, 0, k), k);
  // an NRRD beside it is another thing to load, and comes after the series
  ASSERT_TRUE(writeNrrd(*v, disk / "a/volume.nrrd"));
  EXPECT_EQ(reasonFor(disk), "which-series");
  const auto said = survey(disk);
  ASSERT_TRUE(said) << sentence(said.error());
  ASSERT_EQ(said->series.size(), 2u);
  EXPECT_EQ(said->series[0].file_count, 4);
  EXPECT_EQ(said->series[0].bytes, 4 * 2);
  const auto nrrd = readVolume(said->series[1]);
  ASSERT_TRUE(nrrd) << sentence(nrrd.error());
  EXPECT_EQ(nrrd->grid.dims, v->grid.dims);
}

TEST(DicomReader, AnImageThatWasChangedAndKeptItsIdentifierIsNoCopy) {
  Workshop workshop;
  DicomSlice slice;
  for (int k = 0; k < 4; ++k) {
    slice.instance = "1.2.3.4." + std::to_string(k);
    slice.position_mm = {0, 0, double(k)};
    slice.pixels = {std::int16_t(k)};
    workshop.write("original/" + std::to_string(k), bytesOf(slice));
    slice.pixels = {std::int16_t(k % 2 == 0 ? k : 500 + k)};
    workshop.write("changed/" + std::to_string(k), bytesOf(slice));
  }
  EXPECT_EQ(reasonFor(workshop.folder()), "duplicate");
  EXPECT_EQ(reasonFor(workshop.folder() / "changed"), "");
}

TEST(DicomReader, FilesWithoutASeriesBelongToTheirFolder) {
  Workshop workshop;
  DicomSlice slice;
  slice.series = slice.instance = "";
  slice.pixels = {0};
  for (int k = 0; k < 6; ++k) {
    slice.position_mm = {0, 0, double(k)};
    workshop.write((k < 3 ? "a/" : "b/") + std::to_string(k), bytesOf(slice));
  }
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said) << sentence(said.error());
  ASSERT_EQ(said->series.size(), 2u);
  for (const SeriesVerdict& series : said->series) EXPECT_EQ(series.dims[2], 3);
}

TEST(DicomReader, EmptyFilesBesideTheSlicesAreSaid) {
  Workshop workshop;
  writeSlices(workshop, {0, 1, 2, 3});
  workshop.write("4", "");
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said) << sentence(said.error());
  EXPECT_NE(sentence(said->series.at(0).message).find("Empty files beside the slices: 1;"),
            std::string::npos);
}

TEST(DicomReader, APartIsTheSameVoxelsAtTheSamePlaces) {
  Workshop workshop;
  DicomSlice slice;
  slice.columns = 7;
  slice.rows = 5;
  slice.row_step_mm = 2.0;
  slice.intercept = -24.0;
  slice.padding = {3};
  for (int k = 0; k < 6; ++k) {
    slice.instance = "1.2.3.4." + std::to_string(k);
    slice.position_mm = {4, 5, 3.0 * k};
    slice.pixels.clear();
    for (int n = 0; n < 35; ++n) slice.pixels.push_back(std::int16_t(100 * k + n));
    workshop.write(std::to_string(k), bytesOf(slice));
  }
  const auto whole = readVolume(workshop.folder());
  ASSERT_TRUE(whole) << sentence(whole.error());
  const Part::Box box{{1, 0, 2}, {7, 4, 6}};
  // the last has padding and, of its slice, not the least value that becomes of it
  for (const Part& part :
       {Part{2, {}}, Part{1, box}, Part{3, box}, Part{1, Part::Box{{3, 0, 0}, {7, 1, 1}}}}) {
    const auto v = readVolume(workshop.folder(), {.part = part});
    ASSERT_TRUE(v) << sentence(v.error());
    const auto from = part.box ? part.box->first : std::array<std::int64_t, 3>{};
    const auto to = part.box ? part.box->end : whole->grid.dims;
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_EQ(v->grid.dims[a], (to[a] - from[a] + part.step - 1) / part.step);
    for (std::int64_t k = 0; k < v->grid.dims[2]; ++k)
      for (std::int64_t j = 0; j < v->grid.dims[1]; ++j)
        for (std::int64_t i = 0; i < v->grid.dims[0]; ++i) {
          const std::int64_t x = from[0] + i * part.step, y = from[1] + j * part.step,
                             z = from[2] + k * part.step;
          EXPECT_EQ(voxelAt(*v, i, j, k), voxelAt(*whole, x, y, z));
          const haptics::Vec3 here = v->grid.worldOf({double(i), double(j), double(k)});
          EXPECT_LT((here - whole->grid.worldOf({double(x), double(y), double(z)})).norm(), 1e-12);
        }
  }
  for (const Part& wrong :
       {Part{0, {}}, Part{1, Part::Box{{0, 0, 0}, {8, 1, 1}}},
        Part{1, Part::Box{{2, 0, 0}, {2, 1, 1}}}, Part{1, Part::Box{{-1, 0, 0}, {2, 1, 1}}}}) {
    const auto v = readVolume(workshop.folder(), {.part = wrong});
    ASSERT_FALSE(v);
    EXPECT_EQ(v.error().reason, "no-voxels");
  }
}

TEST(DicomReader, WhatIsWrongWithSingleFilesIsListed) {
  Workshop workshop;
  writeSlices(workshop, {0, 1, 2, 3});
  for (const char* name : {"1", "3"})
    fs::resize_file(workshop.folder() / name, fs::file_size(workshop.folder() / name) - 1);
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said);
  const SeriesVerdict& series = said->series.at(0);
  EXPECT_EQ(series.verdict, Verdict::Refused);
  ASSERT_EQ(series.faults.size(), 2u);
  EXPECT_TRUE(sentence(series.faults[0]).starts_with("\"1\": ")) << sentence(series.faults[0]);
  EXPECT_TRUE(sentence(series.faults[1]).starts_with("\"3\": ")) << sentence(series.faults[1]);
}

/// Sequences in each other, each with one item, written between a slice's other elements.
std::string nested(int depth, bool with_lengths) {
  const auto tag = [](unsigned group, unsigned n) {
    return testing::number(group, 2) + testing::number(n, 2);
  };
  const auto length = [&](std::size_t inside) {
    return testing::number(with_lengths ? inside : 0xffffffffu, 4);
  };
  std::string bytes;
  for (int n = depth; n > 0; --n) {
    const std::string begin = tag(8, 0x1140) + std::string{"SQ\0\0", 4},
                      end = with_lengths ? ""
                                         : tag(0xfffe, 0xe00d) + std::string(4, '\0') +
                                               tag(0xfffe, 0xe0dd) + std::string(4, '\0');
    bytes =
        begin + length(bytes.size() + 8) + tag(0xfffe, 0xe000) + length(bytes.size()) + bytes + end;
  }
  return bytes;
}

/// A slice with these bytes before its modality.
std::string sliceWith(const std::string& bytes) {
  DicomSlice slice;
  slice.pixels = {7};
  std::string file = bytesOf(slice);
  const auto at = file.find(std::string{"\x08\0\x60\0", 4} + "CS");
  return file.insert(at, bytes);
}

// vtk-dicom alone takes a quarter of a minute for 10,000 of them, and its stack ends before 50,000
TEST(DicomReader, SequencesInSequencesWithoutEndAreRefused) {
  for (const bool with_lengths : {true, false}) {
    for (const int depth : {3, 20}) {
      Workshop workshop;
      const auto path = workshop.write("a", sliceWith(nested(depth, with_lengths)));
      EXPECT_EQ(reasonFor(path), "") << depth;
    }
    Workshop workshop;
    const auto path = workshop.write("a", sliceWith(nested(10'000, with_lengths)));
    EXPECT_EQ(reasonFor(path), "bad-header");
  }
}

TEST(DicomReader, AnItemOfElementsWithoutEndIsRefused) {
  std::string elements;
  for (unsigned n = 60'000; n > 0; --n)
    elements += testing::element(0x21, n, "US", testing::number(1, 2));
  const std::string item =
      testing::number(0xfffe, 2) + testing::number(0xe000, 2) + testing::number(elements.size(), 4);
  Workshop workshop;
  const auto path = workshop.write(
      "a", sliceWith(std::string{"\x08\0\x40\x11SQ\0\0", 8} +
                     testing::number(item.size() + elements.size(), 4) + item + elements));
  EXPECT_EQ(reasonFor(path), "bad-header");
}

TEST(DicomReader, AValueLongerThanTheFileAsksForNoMemory) {
  Workshop workshop;
  const std::string value =
      std::string{"\x08\0\x05\x10UN\0\0", 8} + testing::number(0xfffffff0u, 4);
  const auto path = workshop.write("a", sliceWith(value));
  EXPECT_EQ(reasonFor(path), "truncated");
  // what stands before it still tells whose series it is
  DicomSlice sound;
  sound.instance += ".2";
  sound.pixels = {7};
  workshop.write("b", bytesOf(sound));
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said);
  EXPECT_EQ(said->series.size(), 2U);
}

// vtk-dicom copies what it does not know by the lengths that stand there, until an assertion of its
// own ends the program
TEST(DicomReader, ValuesWithoutAStatedEndHoldItemsOrAreRefused) {
  const std::string open = testing::number(0xffffffffu, 4),
                    item = testing::number(0xfffe, 2) + testing::number(0xe000, 2),
                    end = testing::number(0xfffe, 2) + testing::number(0xe0dd, 2) +
                          testing::number(0, 4);
  for (const char* representation : {"OB", "UN"}) {
    const std::string begin =
        std::string{"\x09\0\x01\x10", 4} + representation + std::string(2, '\0') + open;
    Workshop workshop;
    const std::string whole = item + testing::number(4, 4) + std::string(4, '\1');
    EXPECT_EQ(reasonFor(workshop.write("a", sliceWith(begin + whole + end))), "") << representation;
    const std::string beyond = item + testing::number(0xfffffff0u, 4) + std::string(4, '\1');
    EXPECT_EQ(reasonFor(workshop.write("b", sliceWith(begin + beyond + end))), "truncated");
  }
}

}  // namespace
}  // namespace datasets
