// SPDX-License-Identifier: BSD-3-Clause
// The files of one volume: differing attributes part nothing that is one even stack.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

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

/// An attribute and how its n-th value is written.
struct Soft {
  const char* name;
  unsigned group, element;
  const char* representation;
  std::function<std::string(int)> value;
  bool timed = false;
};

std::vector<Soft> softAttributes() {
  const auto number = [](int n) { return std::to_string(n + 1); };
  const auto tens = [](int n) { return std::to_string(10 * n + 10); };
  const auto clock = [](int n) { return std::to_string(101500 + n); };
  return {
      {"acquisition", 0x20, 0x12, "IS", number},
      {"kernel", 0x18, 0x1210, "SH", [](int n) { return "H" + std::to_string(n); }},
      {"image type", 8, 8, "CS", [](int n) { return "DERIVED\\PRIMARY\\T" + std::to_string(n); }},
      {"frame of reference", 0x20, 0x52, "UI", [](int n) { return "1.2." + std::to_string(n); }},
      {"phase", 0x20, 0x9241, "DS", tens},
      {"trigger time", 0x18, 0x1060, "DS", tens, true},
      {"temporal position", 0x20, 0x100, "IS", number, true},
      {"echo time", 0x18, 0x81, "DS", tens},
      {"b-value", 0x18, 0x9087, "DS", tens},
      {"voltage", 0x18, 0x60, "DS", tens},
      {"thickness", 0x18, 0x50, "DS", number},
      {"content time", 8, 0x33, "TM", clock, true},
      {"acquisition time", 8, 0x32, "TM", clock, true},
      {"exposure", 0x18, 0x1152, "IS", tens},
  };
}

enum class Pattern { Constant, Alternating, Halves, Unique };

int valueAt(Pattern pattern, int n, int count) {
  switch (pattern) {
    case Pattern::Constant:
      return 0;
    case Pattern::Alternating:
      return n % 2;
    case Pattern::Halves:
      return n < count / 2 ? 0 : 1;
    case Pattern::Unique:
      break;
  }
  return n;
}

Element elementFor(const Soft& soft, Pattern pattern, int n, int count) {
  return {soft.group, soft.element, soft.representation, soft.value(valueAt(pattern, n, count))};
}

/// One image at each of these heights in the order of the files, with these elements.
void write(const Workshop& workshop, const std::vector<double>& heights_mm,
           const std::function<std::vector<Element>(int)>& elements) {
  for (int n = 0; n < int(heights_mm.size()); ++n) {
    DicomSlice slice;
    slice.columns = slice.rows = 2;
    slice.instance += "." + std::to_string(n + 1);
    slice.position_mm = {0, 0, heights_mm[std::size_t(n)]};
    slice.pixels = {1, 2, 3, std::int16_t(n)};
    std::vector<Element> changes{{0x10, 0x20, "LO", "A1"}, {0x20, 0xd, "UI", "1.7"}};
    std::ranges::copy(elements(n), std::back_inserter(changes));
    workshop.write("s" + std::to_string(100 + n), edited(bytesOf(slice), changes));
  }
}

/// The entries of a folder: "4" a sound stack of four, "4?" one that can be corrected, else the
/// reason.
std::string listOf(const fs::path& folder) {
  const auto found = survey(folder);
  if (!found) return found.error().reason;
  std::string list;
  for (const SeriesVerdict& series : found->series) {
    if (!list.empty()) list += ' ';
    if (series.verdict == Verdict::Refused)
      list += series.reasons.front();
    else
      list +=
          std::to_string(series.file_count) + (series.verdict == Verdict::Correctable ? "?" : "");
  }
  return list;
}

std::string messageOf(const fs::path& folder, std::size_t entry = 0) {
  const auto found = survey(folder);
  return found && entry < found->series.size() ? sentence(found->series[entry].message) : "";
}

// planted: an attribute that parts before all are judged together
TEST(DicomGrouping, NothingThatDiffersPartsOneEvenStack) {
  for (const Soft& soft : softAttributes())
    for (const Pattern pattern :
         {Pattern::Constant, Pattern::Alternating, Pattern::Halves, Pattern::Unique}) {
      Workshop workshop;
      write(workshop, {0, 1, 2, 3, 4, 5, 6, 7},
            [&](int n) { return std::vector{elementFor(soft, pattern, n, 8)}; });
      EXPECT_EQ(listOf(workshop.folder()), "8") << soft.name << " " << int(pattern);
    }
}

TEST(DicomGrouping, NorDoTwoThatDiffer) {
  const std::vector<Soft> all = softAttributes();
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      Workshop workshop;
      write(workshop, {0, 1, 2, 3, 4, 5}, [&](int n) {
        return std::vector{elementFor(all[a], Pattern::Alternating, n, 6),
                           elementFor(all[b], Pattern::Halves, n, 6)};
      });
      EXPECT_EQ(listOf(workshop.folder()), "6") << all[a].name << ", " << all[b].name;
    }
}

TEST(DicomGrouping, WhatLiesAtTheSamePlacesIsPartedByWhatTellsItApart) {
  for (const Soft& soft : softAttributes()) {
    const auto listed = [&](Pattern pattern) {
      Workshop workshop;
      write(workshop, {0, 1, 2, 3, 0, 1, 2, 3},
            [&](int n) { return std::vector{elementFor(soft, pattern, n, 8)}; });
      return listOf(workshop.folder());
    };
    EXPECT_EQ(listed(Pattern::Constant), "duplicate") << soft.name;
    EXPECT_EQ(listed(Pattern::Alternating), "duplicate") << soft.name;
    EXPECT_EQ(listed(Pattern::Halves), "4 4") << soft.name;
    EXPECT_EQ(listed(Pattern::Unique), soft.timed ? "4 4" : "duplicate") << soft.name;
  }
}

TEST(DicomGrouping, PassesThatOverlapAreNeverOne) {
  for (const Soft& soft : softAttributes()) {
    const auto listed = [&](Pattern pattern) {
      Workshop workshop;
      write(workshop, {0, 1, 2, 3, 2.5, 3.5, 4.5, 5.5},
            [&](int n) { return std::vector{elementFor(soft, pattern, n, 8)}; });
      return listOf(workshop.folder());
    };
    // their places alone tell them apart
    for (const Pattern pattern : {Pattern::Halves, Pattern::Constant, Pattern::Alternating})
      EXPECT_EQ(listed(pattern), "4 4") << soft.name << " " << int(pattern);
  }
}

TEST(DicomGrouping, UnevenStacksAreNoPasses) {
  const std::vector<std::pair<std::vector<double>, const char*>> stacks{
      {{0, 1, 2, 3.5, 4.5, 5.5}, "6?"},      // one behind the other
      {{0, 1, 2, 2.5, 3, 4}, "6?"},          // one slice more
      {{0, 2, 4, 6, 8, 12, 16, 20}, "8?"}};  // two regular steps
  for (const auto& [heights_mm, expected] : stacks) {
    Workshop workshop;
    write(workshop, heights_mm, [](int) { return std::vector<Element>(); });
    EXPECT_EQ(listOf(workshop.folder()), expected) << heights_mm.size();
  }
}

TEST(DicomGrouping, PassesOneAfterTheOtherInTimeAreTwo) {
  const std::vector<std::vector<double>> passes{
      {0, 1.5, 3, 4.5, 6, 4, 5.5, 7, 8.5, 10},  // up, and up again
      {0, 1.5, 3, 4.5, 6, 10, 8.5, 7, 5.5, 4},  // up and down
      {0, 1.5, 3, 4.5, 6, 3, 4.5, 6, 7.5, 9}};  // some at the same places
  for (const std::vector<double>& heights_mm : passes) {
    Workshop workshop;
    write(workshop, heights_mm, [](int n) {
      return std::vector{Element{8, 0x33, "TM", std::to_string(101000 + n + (n < 5 ? 0 : 500))}};
    });
    EXPECT_EQ(listOf(workshop.folder()), "5 5");
    EXPECT_NE(messageOf(workshop.folder(), 1).find("pass 2 of 2"), std::string::npos);
  }
}

TEST(DicomGrouping, VolumesThatLackSlicesAreToldApartAllTheSame) {
  Workshop workshop;
  write(workshop, {0, 1, 3, 4, 5, 0, 1, 3, 4, 5}, [](int n) {
    return std::vector{Element{0x20, 0x9241, "DS", n < 5 ? "10" : "40"}};
  });
  EXPECT_EQ(listOf(workshop.folder()), "missing-slices missing-slices");
  EXPECT_NE(messageOf(workshop.folder(), 1).find("phase 2 of 2 (40 %)"), std::string::npos);
}

TEST(DicomGrouping, ABlankIdentifierIsNoOtherOne) {
  const std::vector<Element> identifiers{
      {0x10, 0x20, "LO", ""}, {0x20, 0xd, "UI", ""}, {8, 0x60, "CS", ""}, {0x20, 0xe, "UI", ""}};
  for (const Element& blank : identifiers) {
    Workshop workshop;
    write(workshop, {0, 1, 2, 3, 4, 5},
          [&](int n) { return n % 2 == 1 ? std::vector{blank} : std::vector<Element>(); });
    EXPECT_EQ(listOf(workshop.folder()), "6") << blank.group << "," << blank.number;
    EXPECT_NE(messageOf(workshop.folder()).find("several values of"), std::string::npos);
  }
}

TEST(DicomGrouping, StoredTypesThatDifferAreOneStack) {
  Workshop workshop;
  write(workshop, {0, 1, 2, 3, 4}, [](int n) {
    return std::vector{Element{0x28, 0x103, "US", number(std::size_t(n % 2), 2)}};
  });
  EXPECT_EQ(listOf(workshop.folder()), "5");
  const auto v = readVolume(workshop.folder());
  ASSERT_TRUE(v) << sentence(v.error());
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(voxelAt(*v, 0, 1, k), 3.0);
    EXPECT_EQ(voxelAt(*v, 1, 1, k), k);
  }
}

TEST(DicomGrouping, TwoTogetherPartWhatOneDoesNot) {
  Workshop workshop;
  const std::vector<Soft> all = softAttributes();
  write(workshop, {0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}, [&](int n) {
    return std::vector{Element{0x18, 0x1210, "SH", n < 6 ? "soft" : "hard"},
                       Element{0x20, 0x12, "IS", n / 3 % 2 == 0 ? "1" : "2"}};
  });
  EXPECT_EQ(listOf(workshop.folder()), "3 3 3 3");
  EXPECT_NE(messageOf(workshop.folder(), 1).find("acquisition 1 of 2 (1), kernel 2 of 2"),
            std::string::npos)
      << messageOf(workshop.folder(), 1);
}

TEST(DicomGrouping, VolumesInTimeAreListedInTheirOrder) {
  Workshop workshop;
  write(workshop, {0, 1, 2, 0, 1, 2, 0, 1, 2}, [&](int n) {
    const char* phase[] = {"40", "5", "100"};
    return std::vector{Element{0x20, 0x9241, "DS", phase[n / 3]}};
  });
  ASSERT_EQ(listOf(workshop.folder()), "3 3 3");
  EXPECT_NE(messageOf(workshop.folder(), 1).find("phase 2 of 3 (40 %)"), std::string::npos)
      << messageOf(workshop.folder(), 1);
  const auto first = readVolume(workshop.folder(), {.series = 0});
  ASSERT_TRUE(first) << sentence(first.error());
  EXPECT_EQ(voxelAt(*first, 1, 1, 0), 3.0);  // of 5 %
  // one file stands for its own phase
  const auto third = readVolume(workshop.folder() / "s107");
  ASSERT_TRUE(third) << sentence(third.error());
  EXPECT_EQ(voxelAt(*third, 1, 1, 0), 6.0);
}

TEST(DicomGrouping, WhatNothingTellsApartIsCounted) {
  Workshop workshop;
  write(workshop, {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}, [](int) { return std::vector<Element>(); });
  EXPECT_NE(messageOf(workshop.folder()).find("3 volumes of 4 slices"), std::string::npos)
      << messageOf(workshop.folder());
}

TEST(DicomGrouping, TheVerdictSaysWhatDiffered) {
  Workshop workshop;
  write(workshop, {0, 1, 2, 3}, [](int n) {
    return std::vector{Element{0x20, 0x12, "IS", n % 2 == 0 ? "1" : "2"},
                       Element{0x10, 0x10, "PN", n == 0 ? "Probe^Paula" : "PROBE^PAULA"},
                       Element{0x20, 0x52, "UI", "1.2." + std::to_string(n)}};
  });
  EXPECT_EQ(messageOf(workshop.folder()),
            "One evenly spaced stack of 4 slices; its files state several values of acquisition "
            "(2), frame of reference (4), patient's name (2).");
}

TEST(DicomGrouping, SeriesOfOneSliceAreOneStack) {
  const auto series = [](int n) { return Element{0x20, 0xe, "UI", "1.3." + std::to_string(n)}; };
  {
    Workshop workshop;
    write(workshop, {0, 1, 2, 3}, [&](int n) { return std::vector{series(n)}; });
    EXPECT_EQ(listOf(workshop.folder()), "4");
    EXPECT_NE(messageOf(workshop.folder()).find("series (4)"), std::string::npos);
    EXPECT_EQ(reasonFor(workshop.folder() / "s102"), "");
  }
  {
    Workshop workshop;  // no stack
    write(workshop, {0, 1, 2.6, 3}, [&](int n) { return std::vector{series(n)}; });
    EXPECT_EQ(listOf(workshop.folder()), "1 1 1 1");
  }
  {
    Workshop workshop;  // of two patients, one after the other
    write(workshop, {0, 1, 2, 3, 4, 5}, [&](int n) {
      return std::vector{series(n), Element{0x10, 0x20, "LO", n < 3 ? "A1" : "B2"}};
    });
    EXPECT_EQ(listOf(workshop.folder()), "3 3");
  }
}

TEST(DicomGrouping, WhatHasNoIdentifierInCommonIsAskedAbout) {
  for (const bool one_patient : {false, true}) {
    Workshop workshop;
    write(workshop, {0, 1, 2, 3, 4}, [&](int n) {
      const std::string own = std::to_string(n);
      return std::vector{Element{0x20, 0xe, "UI", "1.3." + own},
                         Element{0x20, 0xd, "UI", "1.4." + own},
                         Element{0x10, 0x20, "LO", one_patient ? "A1" : "A" + own}};
    });
    EXPECT_EQ(listOf(workshop.folder()), "5?");
    EXPECT_NE(messageOf(workshop.folder()).find("5 files of 5 studies fit together"),
              std::string::npos);
    EXPECT_EQ(reasonFor(workshop.folder()), "identifiers-differ");
    const auto v = readVolume(workshop.folder(), {.geometry = Geometry::Corrected});
    ASSERT_TRUE(v) << sentence(v.error());
    EXPECT_EQ(v->grid.dims[2], 5);
    EXPECT_FALSE(v->resampled);
  }
  {
    Workshop workshop;  // of two patients
    write(workshop, {0, 1, 2, 3, 4, 5, 6, 7}, [&](int n) {
      const std::string own = std::to_string(n);
      return std::vector{Element{0x20, 0xe, "UI", "1.3." + own},
                         Element{0x20, 0xd, "UI", "1.4." + own},
                         Element{0x10, 0x20, "LO", n < 4 ? "A1" : "B2"}};
    });
    EXPECT_EQ(listOf(workshop.folder()), "4? 4?");
  }
  Workshop workshop;  // two studies of several slices
  write(workshop, {0, 1, 2, 3, 4, 5}, [&](int n) {
    return std::vector{Element{0x20, 0xd, "UI", n < 3 ? "1.4.1" : "1.4.2"}};
  });
  EXPECT_EQ(listOf(workshop.folder()), "3 3");
}

TEST(DicomGrouping, AFileThatIsNamedCountsInsteadOfOthersAtItsPlace) {
  Workshop workshop;
  write(workshop, {0, 0}, [](int n) {
    return std::vector{
        Element{8, 8, "CS", n == 0 ? "ORIGINAL\\PRIMARY\\AXIAL" : "DERIVED\\PRIMARY\\AXIAL"}};
  });
  for (int n = 0; n < 2; ++n) {
    const auto v = readVolume(workshop.folder() / ("s10" + std::to_string(n)));
    ASSERT_TRUE(v) << sentence(v.error());
    EXPECT_EQ(voxelAt(*v, 1, 1, 0), n);
  }
}

TEST(DicomGrouping, WhatIsNoImageIsLeftOutAndNamed) {
  const auto with = [](std::vector<Element> changes) {
    Workshop workshop;
    write(workshop, {0, 1, 2, 3}, [](int) { return std::vector<Element>(); });
    DicomSlice odd;
    odd.columns = odd.rows = 2;
    odd.instance += ".odd";
    odd.position_mm = {0, 0, 9};
    odd.pixels = {1, 2, 3, 4};
    changes.insert(changes.begin(), {{0x10, 0x20, "LO", "A1"}, {0x20, 0xd, "UI", "1.7"}});
    workshop.write("odd", edited(bytesOf(odd), changes));
    const std::string said = messageOf(workshop.folder());
    EXPECT_NE(said.find("\"odd\""), std::string::npos) << said;
    return listOf(workshop.folder());
  };
  const Element no_pixels{0x7fe0, 0x10, "", ""}, no_place{0x20, 0x32, "", ""},
      wide{0x28, 0x11, "US", number(1, 2)}, tall{0x28, 0x10, "US", number(4, 2)};
  EXPECT_EQ(with({no_pixels, no_place}), "4");
  EXPECT_EQ(with({no_pixels, {0x28, 0x10, "", ""}, {0x28, 0x11, "", ""}}), "4");
  EXPECT_EQ(with({{8, 8, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER"}}), "4");
  EXPECT_EQ(with({{0x28, 2, "US", number(3, 2)}, {0x28, 4, "CS", "RGB"}}), "4");
  EXPECT_EQ(with({no_place, {8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.7"}}), "4");
  EXPECT_EQ(with({no_place, {8, 8, "CS", "DERIVED\\SECONDARY\\SCREEN SAVE"}}), "4");
  EXPECT_EQ(with({wide, tall}), "4");                               // a scout without its mark
  EXPECT_EQ(with({{0x20, 0x37, "DS", "1\\0\\0\\0\\0\\-1"}}), "4");  // likewise
  // the last slice, whose pixels are lost, is none of these
  Workshop workshop;
  write(workshop, {0, 1, 2, 3},
        [&](int n) { return n == 3 ? std::vector{no_pixels} : std::vector<Element>(); });
  EXPECT_EQ(listOf(workshop.folder()), "no-pixels");
}

TEST(DicomGrouping, StacksOfOneSeriesThatFaceElsewhereAreParted) {
  Workshop workshop;
  write(workshop, {0, 1, 2, 0, 2, 4, 6}, [](int n) {
    if (n < 3) return std::vector<Element>();
    return std::vector{Element{0x20, 0x37, "DS", "1\\0\\0\\0\\0.965926\\0.258819"}};
  });
  EXPECT_EQ(listOf(workshop.folder()), "4? 3");
  EXPECT_NE(messageOf(workshop.folder(), 1).find("orientation 2 of 2 (turned by 15 degrees)"),
            std::string::npos)
      << messageOf(workshop.folder(), 1);
}

}  // namespace
}  // namespace datasets
