// SPDX-License-Identifier: BSD-3-Clause
// Folders of DICOM files made here: order, places, refusals by name, encodings, enhanced frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "datasets/readers/volume_reader.h"
#include "tests/support/codestreams.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/packed.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::Vec3;
using testing::asBigEndian;
using testing::asImplicit;
using testing::dataSetOf;
using testing::decimals;
using testing::DicomSlice;
using testing::differing;
using testing::edited;
using testing::Element;
using testing::element;
using testing::encapsulated;
using testing::number;
using testing::reasonFor;
using testing::sequence;
using testing::voxelAt;
using testing::Workshop;

/// The k-th slice of a stack of 2 mm, of 9 x 8 pixels that are all different.
DicomSlice sliceOfStack(int k) {
  DicomSlice slice;
  slice.instance += "." + std::to_string(k + 1);
  slice.position_mm = {-10, 20, 2.0 * k};
  slice.columns = 9;
  slice.rows = 8;
  slice.column_step_mm = 0.5;
  slice.row_step_mm = 0.75;
  for (int n = 0; n < 72; ++n) slice.pixels.push_back(std::int16_t(100 * k + n - 300));
  return slice;
}

/// A folder of these slices, each changed like this.
fs::path folderOf(const Workshop& workshop, const std::string& name, int count,
                  const std::function<void(int, DicomSlice&)>& change = {},
                  const std::vector<Element>& elements = {}) {
  for (int k = 0; k < count; ++k) {
    DicomSlice slice = sliceOfStack(k);
    if (change) change(k, slice);
    workshop.write(name + "/" + std::to_string(k), edited(bytesOf(slice), elements));
  }
  return workshop.folder() / name;
}

TEST(DicomFolder, NamesDoNotOrderTheSlicesAndOneFileStandsForAll) {
  Workshop workshop;
  constexpr int kSlices = 11;
  for (int k = 0; k < kSlices; ++k)
    workshop.write(std::to_string(100 + k * 7 % kSlices), bytesOf(sliceOfStack(k)));
  const auto v = readVolume(workshop.folder());
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_LT((1e3 * v->grid.origin - Vec3(-10, 20, 0)).norm(), 1e-9);
  EXPECT_LT((1e3 * v->grid.spacing - Vec3(0.5, 0.75, 2)).norm(), 1e-12);
  EXPECT_EQ(v->modality, "CT");
  for (int k = 0; k < kSlices; ++k)
    for (int n = 0; n < 72; ++n) ASSERT_EQ(voxelAt(*v, n % 9, n / 9, k), 100 * k + n - 300);
  const auto by_file = readVolume(workshop.folder() / "104");
  ASSERT_TRUE(by_file) << sentence(by_file.error());
  EXPECT_EQ(differing(*v, *by_file), 0);
  EXPECT_FALSE(survey(workshop.folder() / "104")->several);
  const auto said = survey(workshop.folder());
  EXPECT_TRUE(said->several);
  ASSERT_EQ(said->series.size(), 1u);
  EXPECT_EQ(said->series[0].verdict, Verdict::Sound);
}

TEST(DicomFolder, UnequalPixelsAndFractionalRescale) {
  Workshop workshop;
  const auto folder = folderOf(workshop, "s", 3,
                               [](int, DicomSlice& slice) {
                                 slice.column_step_mm = 6.4;
                                 slice.row_step_mm = 4.0;
                                 slice.slope = 0.1875;
                                 slice.intercept = -7.5;
                               },
                               {{8, 0x60, "CS", "MR"}});
  const auto v = readVolume(folder);
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_NEAR(1e3 * v->grid.spacing.x(), 6.4, 1e-9);
  EXPECT_NEAR(1e3 * v->grid.spacing.y(), 4.0, 1e-9);
  EXPECT_EQ(v->type, haptics::ScalarType::Float32);
  EXPECT_EQ(v->unit, "");
  EXPECT_EQ(voxelAt(*v, 3, 2, 1), 0.1875 * (100 + 21 - 300) - 7.5);
}

TEST(DicomFolder, RefusesByName) {
  Workshop workshop;
  const auto turned = [](int k, DicomSlice& slice) {
    if (k == 2) slice.along_column = {0, std::cos(0.2), std::sin(0.2)};
  };
  const auto gap = [](int k, DicomSlice& slice) { slice.position_mm.z() += k > 2 ? 2 : 0; };
  const auto tilted = [](int k, DicomSlice& slice) { slice.position_mm.y() += 0.6 * k; };
  const std::map<std::string, fs::path> expected{
      {"gantry-tilt", folderOf(workshop, "tilted", 5, tilted)},
      {"missing-slices", folderOf(workshop, "gap", 6, gap)},
      {"mixed-orientation", folderOf(workshop, "turned", 4, turned)},
      {"bad-header", folderOf(workshop, "unplaced", 2, {}, {{0x20, 0x32, "", ""}})},
      {"not-scalar", folderOf(workshop, "colour", 1, {},
                              {{0x28, 2, "US", number(3, 2)}, {0x28, 4, "CS", "RGB"}})},
      {"no-pixels", folderOf(workshop, "report", 1, {}, {{0x7fe0, 0x10, "", ""}})},
      {"localizer",
       folderOf(workshop, "scout", 1, {}, {{8, 8, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER"}})},
      {"unreadable", workshop.write("letter/letter.txt", "no scan").parent_path()}};
  for (const auto& [reason, path] : expected) {
    EXPECT_EQ(reasonFor(path), reason) << path.filename();
    const auto said = survey(path);
    if (!said) continue;
    for (const SeriesVerdict& s : said->series)
      EXPECT_EQ(sentence(s.message).find("1.2."), std::string::npos) << sentence(s.message);
  }
  EXPECT_NE(sentence(readVolume(workshop.folder() / "gap").error()).find("1 slice is missing"),
            std::string::npos);
  fs::create_directories(workshop.folder() / "empty");
  EXPECT_EQ(reasonFor(workshop.folder() / "empty"), "unreadable");
  EXPECT_EQ(reasonFor("/no/such/folder"), "unreadable");
}

// its values are linear in the patient, and linear interpolation keeps them so
TEST(DicomFolder, ATiltedSeriesIsStraightenedIfTheUserAgrees) {
  Workshop workshop;
  const double along = std::sin(16.5 * std::numbers::pi / 180.0),
               up = std::cos(16.5 * std::numbers::pi / 180.0);
  const auto linear = [](const Vec3& p_mm) { return 500.0 + p_mm.dot(Vec3(3, -20, 40)); };
  const auto folder = folderOf(workshop, "tilted", 6, [&](int k, DicomSlice& slice) {
    slice.rows = slice.columns = 24;
    slice.position_mm = 2.5 * k * Vec3(0, along, up);
    slice.pixels.clear();
    for (int n = 0; n < 24 * 24; ++n)
      slice.pixels.push_back(std::int16_t(
          std::lround(linear(slice.position_mm + Vec3(0.5 * (n % 24), 0.75 * (n / 24), 0)))));
  });
  const auto said = survey(folder);
  ASSERT_TRUE(said);
  ASSERT_EQ(said->series.size(), 1u);
  EXPECT_EQ(said->series[0].verdict, Verdict::Correctable);
  EXPECT_EQ(said->series[0].reasons, std::vector<std::string>{"gantry-tilt"});
  EXPECT_NE(sentence(said->series[0].message).find("16.5 degrees"), std::string::npos);
  const auto as_stored = readVolume(folder);
  ASSERT_FALSE(as_stored);
  EXPECT_EQ(as_stored.error().kind, haptics::Error::Kind::Correctable);

  const auto v = readVolume(folder, {.geometry = Geometry::Corrected});
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_TRUE(v->resampled);
  EXPECT_EQ(v->grid.dims[0], 24);
  EXPECT_GT(v->grid.dims[1], 24);
  EXPECT_EQ(v->grid.dims[2], 6);
  EXPECT_NEAR(1e3 * v->grid.spacing.z(), 2.5 * up, 1e-6);
  std::int64_t reached = 0;
  for (std::int64_t k = 0; k < 6; ++k)
    for (std::int64_t j = 0; j < v->grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < 24; ++i) {
        const Vec3 p_mm = 1e3 * v->grid.worldOf({double(i), double(j), double(k)});
        const double from = p_mm.y() - 2.5 * double(k) * along;
        if (from < 0.0 || from > 0.75 * 23) continue;
        ++reached;
        // the slices' values are rounded, and so is what lies between them
        EXPECT_NEAR(voxelAt(*v, i, j, k), linear(p_mm), 1.01) << i << " " << j << " " << k;
      }
  EXPECT_GE(reached, 24 * 23 * 6);
}

// against the order of the file; in a private group, copies that are half a pixel off
TEST(DicomFolder, EnhancedFramesLieWhereTheirGroupsSay) {
  constexpr int kFrames = 4;
  const auto placeOf = [](int frame) { return Vec3(-10, 20, 30 - 1.25 * frame); };
  DicomSlice all;
  all.columns = 9;
  all.rows = 8;
  for (int n = 0; n < kFrames * 72; ++n) all.pixels.push_back(std::int16_t(n));
  std::string bytes = edited(bytesOf(all), {{0x20, 0x32, "", ""},
                                            {0x20, 0x37, "", ""},
                                            {0x28, 0x30, "", ""},
                                            {0x28, 0x1052, "", ""},
                                            {0x28, 0x1053, "", ""},
                                            {0x28, 8, "IS", std::to_string(kFrames)}});
  const std::string shared =
      sequence(0x20, 0x9116, {element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")}) +
      sequence(
          0x28, 0x9110,
          {element(0x18, 0x50, "DS", "1.25") + element(0x28, 0x30, "DS", decimals({0.75, 0.5}))});
  std::vector<std::string> frames;
  for (int frame = 0; frame < kFrames; ++frame) {
    const Vec3 p = placeOf(frame), beside = p + Vec3(0.25, 0.375, 0);
    const auto place = [](const Vec3& at) {
      return element(0x20, 0x32, "DS", decimals({at.x(), at.y(), at.z()}));
    };
    // a slope of each frame's own
    frames.push_back(sequence(0x20, 0x9113, {place(p)}) +
                     sequence(0x28, 0x9145,
                              {element(0x28, 0x1052, "DS", "-24") +
                               element(0x28, 0x1053, "DS", std::to_string(frame + 1)) +
                               element(0x28, 0x1054, "LO", "HU")}) +
                     element(0x2005, 0x10, "LO", "SOMEBODY") +
                     sequence(0x2005, 0x100f, {place(beside)}));
  }
  const auto pixels = bytes.rfind(number(0x7fe0, 2) + number(0x10, 2));
  bytes.insert(pixels, sequence(0x5200, 0x9229, {shared}) + sequence(0x5200, 0x9230, frames));
  Workshop workshop;
  const auto v = readVolume(workshop.write("enhanced", bytes));
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_EQ(v->grid.dims, (std::array<std::int64_t, 3>{9, 8, kFrames}));
  EXPECT_LT((1e3 * v->grid.spacing - Vec3(0.5, 0.75, 1.25)).norm(), 1e-9);
  EXPECT_EQ(v->unit, "HU");
  for (int frame = 0; frame < kFrames; ++frame) {
    const Vec3 index = v->grid.indexOf(1e-3 * placeOf(frame));
    const auto k = std::lround(index.z());
    EXPECT_LT((index - Vec3(0, 0, double(k))).norm(), 1e-9) << index.transpose();
    for (int n = 0; n < 72; ++n)
      ASSERT_EQ(voxelAt(*v, n % 9, n / 9, k), (frame + 1) * (72 * frame + n) - 24);
  }
}

TEST(DicomFolder, EnhancedFramesAreVolumesByTheDimensionsThatTheirFileDeclares) {
  constexpr int kSlices = 4, kVolumes = 2;
  DicomSlice all;
  for (int n = 0; n < kSlices * kVolumes; ++n) all.pixels.push_back(std::int16_t(n));
  std::string bytes = edited(
      bytesOf(all), {{0x20, 0x32, "", ""}, {0x28, 8, "IS", std::to_string(kSlices * kVolumes)}});
  const auto pointer = [](unsigned group, unsigned tag) {
    return element(0x20, 0x9165, "AT", number(group, 2) + number(tag, 2));
  };
  std::vector<std::string> frames;
  for (int n = 0; n < kSlices * kVolumes; ++n)
    frames.push_back(
        sequence(0x20, 0x9111,
                 {element(0x20, 0x9157, "UL",
                          number(std::size_t(n / kSlices + 1), 4) +
                              number(std::size_t(n % kSlices + 1), 4))}) +
        sequence(0x20, 0x9113, {element(0x20, 0x32, "DS", decimals({0, 0, 1.0 * (n % kSlices)}))}));
  bytes.insert(bytes.find(element(0x28, 2, "US", number(1, 2))),
               sequence(0x20, 0x9222, {pointer(0x18, 0x9074), pointer(0x20, 0x9057)}));
  bytes.insert(bytes.rfind(number(0x7fe0, 2) + number(0x10, 2)), sequence(0x5200, 0x9230, frames));
  Workshop workshop;
  const auto path = workshop.write("enhanced", bytes);
  for (int volume = 0; volume < kVolumes; ++volume) {
    const auto v = readVolume(path, {.series = volume});
    ASSERT_TRUE(v) << sentence(v.error());
    ASSERT_EQ(v->grid.dims[2], kSlices);
    EXPECT_EQ(voxelAt(*v, 0, 0, 1), kSlices * volume + 1);
  }
}

TEST(DicomFolder, EveryTransferSyntaxGivesEqualVoxels) {
  const DicomSlice slice = sliceOfStack(2);
  const std::string plain = bytesOf(slice), data = plain.substr(dataSetOf(plain));
  const auto withMeta = [&](const std::string& syntax, const std::string& data_set) {
    const std::string meta = element(2, 1, "OB", std::string{'\0', '\1'}) +
                             element(2, 2, "UI", "1.2.840.10008.5.1.4.1.1.2") +
                             element(2, 0x10, "UI", syntax);
    return std::string(128, '\0') + "DICM" + element(2, 0, "UL", number(meta.size(), 4)) + meta +
           data_set;
  };
  const auto deflatedBare = [](const std::string& bytes) {
    const std::string out = testing::deflatedWith(-MAX_WBITS, bytes);
    return out + (out.size() % 2 == 1 ? std::string(1, '\0') : "");
  };
  // a codec of unsigned values sees the bits
  const std::vector<std::uint16_t> bits(slice.pixels.begin(), slice.pixels.end());
  const support::Raster raster{slice.columns, slice.rows, 16, 1, bits};
  struct Form {
    const char* name;
    std::string bytes;
    double off;  // how far its voxels may be
  };
  const std::string lossy = "1.2.840.10008.1.2.4.81";
  const Form forms[] = {
      {"implicit", withMeta("1.2.840.10008.1.2", asImplicit(data)), 0},
      {"big endian", withMeta("1.2.840.10008.1.2.2", asBigEndian(data)), 0},
      {"deflated", withMeta("1.2.840.10008.1.2.1.99", deflatedBare(data)), 0},
      {"JPEG", encapsulated(plain, "1.2.840.10008.1.2.4.57", {support::asLosslessJpeg(raster)}), 0},
      {"JPEG 2000",
       encapsulated(plain, "1.2.840.10008.1.2.4.91",
                    {support::asJpeg2000(raster, {.is_signed = true})}),
       0},
      {"RLE", encapsulated(plain, "1.2.840.10008.1.2.5", {support::asRle(raster)}), 0},
      {"JPEG-LS", encapsulated(plain, "1.2.840.10008.1.2.4.80", {support::asJpegLs(raster)}), 0},
      {"JPEG-LS with loss", encapsulated(plain, lossy, {support::asJpegLs(raster, 2)}), 2}};
  Workshop workshop;
  const auto expected = readVolume(workshop.write("plain/0", plain));
  ASSERT_TRUE(expected) << sentence(expected.error());
  for (const Form& form : forms) {
    const auto v = readVolume(workshop.write(std::string(form.name) + "/0", form.bytes));
    ASSERT_TRUE(v) << form.name << ": " << sentence(v.error());
    EXPECT_EQ(differing(*expected, *v, form.off), 0) << form.name;
  }
  for (const char* retired : {"1.2.840.10008.1.2.4.55", "1.2.840.10008.1.2.4.53"})
    EXPECT_EQ(reasonFor(workshop.write(std::string(retired) + "/0",
                                       encapsulated(plain, retired, {std::string(64, 'a')}))),
              "unsupported-syntax");
}

TEST(DicomFolder, OfSeveralSeriesListsThem) {
  Workshop workshop;
  const auto series = [&](int n, int count, std::int16_t more, std::vector<Element> elements) {
    const std::string uid = "1.2.3." + std::to_string(n);
    elements.push_back({0x20, 0xe, "UI", uid});
    for (int k = 0; k < count; ++k) {
      DicomSlice slice = sliceOfStack(k);
      for (std::int16_t& pixel : slice.pixels) pixel = std::int16_t(pixel + more);
      elements.push_back({8, 0x18, "UI", uid + "." + std::to_string(k)});
      workshop.write("IM" + std::to_string(100 * k + n), edited(bytesOf(slice), elements));
    }
  };
  // two kernels at the same positions, a scout, and a picture in colour
  series(1, 4, 0, {});
  series(2, 4, 7, {});
  series(3, 1, 0, {{8, 8, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER"}});
  series(4, 1, 0, {{0x28, 2, "US", number(3, 2)}, {0x28, 4, "CS", "RGB"}});
  const auto said = survey(workshop.folder());
  ASSERT_TRUE(said) << sentence(said.error());
  std::map<std::string, int> verdicts;
  std::vector<int> sound;
  for (const SeriesVerdict& s : said->series) {
    if (s.verdict == Verdict::Sound) sound.push_back(s.index);
    ++verdicts[s.verdict == Verdict::Sound ? "sound" : s.reasons.at(0)];
    EXPECT_EQ(s.dims[2], s.verdict == Verdict::Sound ? 4 : 1);
  }
  EXPECT_EQ(verdicts,
            (std::map<std::string, int>{{"sound", 2}, {"localizer", 1}, {"not-scalar", 1}}));
  EXPECT_EQ(reasonFor(workshop.folder()), "which-series");
  EXPECT_EQ(reasonFor(workshop.folder() / "IM1"), "");
  ASSERT_EQ(sound.size(), 2u);
  const auto first = readVolume(workshop.folder(), {.series = sound[0]}),
             second = readVolume(workshop.folder(), {.series = sound[1]});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->grid.origin, second->grid.origin);
  EXPECT_EQ(std::abs(voxelAt(*first, 3, 2, 1) - voxelAt(*second, 3, 2, 1)), 7);
  EXPECT_EQ(readVolume(workshop.folder(), {.series = 99}).error().reason, "no-such-series");
}

TEST(DicomFolder, CancelEndsTheRead) {
  Workshop workshop;
  const auto folder = folderOf(workshop, "s", 60, [](int, DicomSlice& slice) {
    slice.rows = slice.columns = 128;
    slice.pixels.assign(128 * 128, 7);
  });
  std::atomic<bool> cancel = false;
  // where all slices are read before the reading thread looks, nobody is told of them
  for (int n = 0; n < 100 && !cancel; ++n) {
    const auto v = readVolume(folder, {}, {[&](double f) { cancel = f > 0.4; }, &cancel});
    EXPECT_EQ(v.has_value(), !cancel);
    if (!v) {
      EXPECT_EQ(v.error().kind, haptics::Error::Kind::Cancelled);
    }
  }
  EXPECT_TRUE(cancel);
}

TEST(DicomFolder, CancelEndsTheStraightening) {
  Workshop workshop;
  const auto folder = folderOf(workshop, "tilted", 20,
                               [](int k, DicomSlice& slice) { slice.position_mm.y() += 0.6 * k; });
  std::atomic<bool> cancel = false;
  double last = 0.0;
  const auto v = readVolume(folder, {.geometry = Geometry::Corrected},
                            {[&](double f) {
                               last = f;
                               cancel = f > 0.85;
                             },
                             &cancel});
  ASSERT_FALSE(v);
  EXPECT_EQ(v.error().kind, haptics::Error::Kind::Cancelled);
  EXPECT_LT(last, 0.95);
}

}  // namespace
}  // namespace datasets
