// SPDX-License-Identifier: BSD-3-Clause

// The same hand on the same scan, felt by Palpate and by the paper's words: the literal method
// stands still while the device moves on; accept-inside moves, and enters the surface. The made
// scan has the noise of a scanner.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string_view>

#include "app/study/reference/run.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/simulation/closed_loop.h"
#include "resources/named_tools.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"

namespace {

struct Case {
  const char* path;  ///< of a real scan, or the name of a phantom
  double isovalue;
  const char* tool;
  haptics::HandMotion motion;
  double most_frozen;  ///< of ours, share of contact ticks
};

void PrintTo(const Case& scan, std::ostream* out) { *out << scan.path << " with " << scan.tool; }

bool isMade(const Case& scan) { return scan.path == std::string_view{"demo"}; }

haptics::Expected<haptics::Volume> volumeOf(const Case& scan) {
  if (!isMade(scan)) return datasets::readVolume(places::scan(scan.path));
  auto made = datasets::makePhantom(scan.path);
  if (!made) return tl::unexpected(made.error());
  return std::move(made->volume);
}

class Rivals : public testing::TestWithParam<Case> {};

TEST_P(Rivals, LiteralFreezesWhereOursMovesAndAcceptInsideEnters) {
  const Case& scan = GetParam();
  if (!isMade(scan) && !std::filesystem::exists(places::scan(scan.path)))
    GTEST_SKIP() << "NOT CHECKED: the scan " << scan.path << " is not here";
  auto read = volumeOf(scan);
  ASSERT_TRUE(read) << sentence(read.error());
  const auto volume = std::make_shared<const haptics::Volume>(std::move(*read));
  auto tool = haptics::makeTool(scan.tool, *resources::namedToolMesh(scan.tool));
  ASSERT_TRUE(tool);
  auto scene = haptics::makeScene(volume, *tool);
  ASSERT_TRUE(scene);

  // ours, with the hand in its grip; the rivals are given the device's path as it came out
  haptics::ClosedLoop loop{*scene, {.isovalue = scan.isovalue}, {}, {}};
  auto hand = haptics::Hand::aimed(scan.motion, **scene, scan.isovalue, 0.018, 1);
  ASSERT_TRUE(hand) << sentence(hand.error());
  std::vector<haptics::Pose> device;
  std::vector<reference::Record> ours;
  ASSERT_TRUE(loop.run(*hand, 2500, [&](const haptics::TraceRow& row) {
    device.push_back(row.X_WD);
    reference::Record record;
    record.X_WP = row.X_WP;
    record.contacts = row.contacts;
    ours.push_back(record);
    return true;
  }));
  const auto rival = [&](reference::Variant variant) {
    const reference::Scene theirs{
        {*volume, scan.isovalue, reference::choicesFor(volume->grid, variant)}, tool->shell};
    return reference::run(theirs, device);
  };
  const auto literal = rival(reference::Variant::Literal);
  const auto inside = rival(reference::Variant::AcceptInside);

  const double frozen = reference::frozenShare(ours, device, tool->shell);
  const double literal_frozen = reference::frozenShare(literal, device, tool->shell);
  double deepest = 0.0;
  for (const reference::Record& record : inside) deepest = std::max(deepest, record.penetration);
  std::printf("%s: frozen %.3f, literally %.3f, deepest %.3f voxels\n", scan.path, frozen,
              literal_frozen, deepest / volume->grid.spacing.minCoeff());
  EXPECT_LT(frozen, scan.most_frozen);
  EXPECT_GT(literal_frozen, 0.70);
  // a tenth of a voxel: far beyond what rounding or epsilon could explain
  EXPECT_GT(deepest, 0.1 * volume->grid.spacing.minCoeff());
}

INSTANTIATE_TEST_SUITE_P(MadeScan, Rivals,
                         testing::Values(Case{"demo", 300, "drill", haptics::HandMotion::Slide,
                                              0.30}));

INSTANTIATE_TEST_SUITE_P(RealScans, Rivals,
                         testing::Values(Case{"stanford_bunny/bunny_512x512x361_airflat.nrrd", 1500,
                                              "cane", haptics::HandMotion::Slide, 0.20},
                                         Case{"volvis_classics/engine.nhdr", 90, "wrench",
                                              haptics::HandMotion::Hook, 0.20},
                                         Case{"visible_human_female_head/vhf_head_512x512x234.nrrd",
                                              300, "drill", haptics::HandMotion::Slide, 0.30}));

}  // namespace
