// SPDX-License-Identifier: BSD-3-Clause
// The grey windows that DICOM files state.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "datasets/readers/volume_reader.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using testing::DicomSlice;
using testing::edited;
using testing::element;
using testing::Workshop;

/// The k-th slice of a series of CT, whose values begin at -1024 HU.
DicomSlice windowSlice(int k) {
  DicomSlice slice;
  slice.instance += "." + std::to_string(k + 1);
  slice.position_mm = {0.0, 0.0, double(k)};
  slice.rows = slice.columns = 2;
  slice.intercept = -1024.0;
  slice.pixels = {0, 1000, 1064, 2000};
  return slice;
}

std::string withWindow(const DicomSlice& slice, const std::string& level, const std::string& width,
                       const std::string& names = {}) {
  return edited(
      bytesOf(slice),
      {{0x28, 0x1050, "DS", level}, {0x28, 0x1051, "DS", width}, {0x28, 0x1055, "LO", names}});
}

/// The windows of the one series in a folder, which must be sound and readable.
std::vector<StatedWindow> windowsIn(const Workshop& workshop) {
  const auto found = survey(workshop.folder());
  EXPECT_TRUE(found) << sentence(found.error());
  if (!found || found->series.size() != 1) return {};
  EXPECT_EQ(found->series[0].verdict, Verdict::Sound);
  EXPECT_TRUE(readVolume(found->series[0], {}));
  return found->series[0].windows;
}

std::vector<StatedWindow> windowsOf(const std::string& level, const std::string& width,
                                    const std::string& names = {}) {
  const Workshop workshop;
  workshop.write("slice", withWindow(windowSlice(0), level, width, names));
  return windowsIn(workshop);
}

void expectWindow(const StatedWindow& window, double level, double width,
                  const std::string& name = {}) {
  EXPECT_EQ(window.level, level);
  EXPECT_EQ(window.width, width);
  EXPECT_EQ(window.name, name);
}

TEST(StatedWindow, IsInHounsfieldUnitsAsTheFileHasIt) {
  const auto one = windowsOf("40 ", "400");
  ASSERT_EQ(one.size(), 1U);
  expectWindow(one[0], 40.0, 400.0);
  const auto two = windowsOf("-600\\ 40.5", "1.5E3\\350", "LUNG \\WEICHTEIL");
  ASSERT_EQ(two.size(), 2U);
  expectWindow(two[0], -600.0, 1500.0, "LUNG");
  expectWindow(two[1], 40.5, 350.0, "WEICHTEIL");
}

TEST(StatedWindow, ThatIsNoSoundNumberIsLeftOutAndRefusesNothing) {
  for (const auto& [level, width] :
       std::vector<std::pair<std::string, std::string>>{{"", ""},
                                                        {"40", ""},
                                                        {"", "400"},
                                                        {"40", "0"},
                                                        {"40", "-400"},
                                                        {"nan", "400"},
                                                        {"40", "inf"},
                                                        {"40,5", "400"},
                                                        {"40", "400 HU"},
                                                        {"0x28", "400"},
                                                        {"40", "1e999"},
                                                        {"1e300", "400"},
                                                        {"40", "1e-300"},
                                                        {"\\", "\\"}})
    EXPECT_TRUE(windowsOf(level, width).empty()) << level << ", " << width;
  // of several, the sound ones; a number too many has no partner
  const auto some = windowsOf("x\\50\\60", "400\\500", "A\\B\\C");
  ASSERT_EQ(some.size(), 1U);
  expectWindow(some[0], 50.0, 500.0, "B");
  std::string many = "1";
  for (int n = 2; n < 1000; ++n) many += "\\" + std::to_string(n);
  EXPECT_EQ(windowsOf(many, many).size(), 8U);
}

TEST(StatedWindow, OfSlicesThatDifferIsThatOfTheMiddleOne) {
  const Workshop workshop;
  // the names of the files and the order of the slices run against each other
  for (int k = 0; k < 5; ++k)
    workshop.write(std::to_string(9 - k), withWindow(windowSlice(k), std::to_string(10 * k), "80"));
  const auto windows = windowsIn(workshop);
  ASSERT_EQ(windows.size(), 1U);
  expectWindow(windows[0], 20.0, 80.0);
}

/// A sequence of explicit length with one item.
std::string sequenceOf(unsigned group, unsigned number, const std::vector<std::string>& items) {
  std::string value;
  for (const std::string& item : items)
    value += testing::number(0xe000fffe, 4) + testing::number(item.size(), 4) + item;
  return testing::number(group, 2) + testing::number(number, 2) + "SQ" + testing::number(0, 2) +
         testing::number(value.size(), 4) + value;
}

std::string voiOf(const std::string& level, const std::string& width) {
  return sequenceOf(0x28, 0x9132,
                    {element(0x28, 0x1050, "DS", level) + element(0x28, 0x1051, "DS", width)});
}

/// An enhanced file of five frames, with these functional groups besides their places.
std::string framesWith(const std::string& shared, const std::vector<std::string>& of_each) {
  DicomSlice all = windowSlice(0);
  all.pixels.assign(4 * of_each.size(), 0);
  std::string bytes = edited(bytesOf(all), {{0x20, 0x32, "", ""},
                                            {0x28, 8, "IS", std::to_string(of_each.size())},
                                            {0x28, 0x1050, "DS", "1"},
                                            {0x28, 0x1051, "DS", "2"}});
  std::vector<std::string> frames;
  for (std::size_t n = 0; n < of_each.size(); ++n)
    frames.push_back(
        sequenceOf(0x20, 0x9113, {element(0x20, 0x32, "DS", "0\\0\\" + std::to_string(n))}) +
        of_each[n]);
  const auto pixels = bytes.rfind(testing::number(0x7fe0, 2) + testing::number(0x10, 2));
  return bytes.insert(pixels,
                      sequenceOf(0x5200, 0x9229, {shared}) + sequenceOf(0x5200, 0x9230, frames));
}

TEST(StatedWindow, OfAnEnhancedFileIsThatOfItsFrames) {
  std::vector<std::string> own;
  for (int n = 0; n < 5; ++n) own.push_back(voiOf(std::to_string(100 * n), "300"));
  {
    const Workshop workshop;
    workshop.write("frames", framesWith(voiOf("7", "8"), own));
    const auto windows = windowsIn(workshop);
    ASSERT_EQ(windows.size(), 1U);
    expectWindow(windows[0], 200.0, 300.0);
  }
  const Workshop workshop;
  workshop.write("frames", framesWith(voiOf("7", "8"), std::vector<std::string>(5)));
  const auto windows = windowsIn(workshop);
  ASSERT_EQ(windows.size(), 1U);
  expectWindow(windows[0], 7.0, 8.0);
}

}  // namespace
}  // namespace datasets
