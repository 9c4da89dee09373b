// SPDX-License-Identifier: BSD-3-Clause
// An edit comes back from its text to the bit, and nothing else is taken for one.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "datasets/edits/edit_history.h"
#include "datasets/phantoms/making.h"
#include "tests/support/made.h"
#include "tests/support/sentence.h"

namespace {

using namespace datasets;
using namespace haptics;

LassoCut triangle() {
  LassoCut cut;
  cut.outline = {{0.1, 0.2}, {1.0 / 3.0, -0.25}, {-0.1, 1e-17}};
  cut.X_WC = poseOf({0.1, -0.2, 0.3}, Quat{0.5, 0.1, -0.7, 0.2});
  cut.parallel = true;
  cut.from = -0.01;
  cut.until = 0.2;
  cut.inside = false;
  cut.isovalue = 300.1;
  return cut;
}

/// Two ways, the second of them at two isovalues.
Stroke stroke() {
  const Vec3 a{0.1, 1.0 / 3.0, -0.2}, b = a + Vec3{1e-5, 0.0, 1.0 / 7e5}, c = b + Vec3{0, 1e-4, 0};
  const Vec3 d{-0.1, 0.0, 0.0};
  return Stroke{{{a, a, 2e-3, 300.0},
                 {a, b, 2e-3, 300.0},
                 {b, c, 2e-3, 300.0},
                 {d, d, 2e-3, 300.0},
                 {d, d, 2e-3, 301.5}},
                1e-9 / 3.0};
}

/// In a scan of 7 x 5 x 3 voxels.
TissueTable tissues() {
  return TissueTable{{7, 5, 3},
                     {{.structure = 4, .energy = 1e9 / 3.0, .runs = {{0, 0, 0, 7}, {2, 4, 1, 1}}},
                      {.structure = 0, .runs = {{6, 4, 2, 1}}},
                      {.structure = 254}}};
}

std::vector<Edit> oneOfEach() {
  return {Crop{{{0, 1, 2}, {3, 4, 500}}},
          PlaneCut{{0.1, -0.2, 1.0 / 7.0}, Vec3{1, 2, 3}.normalized(), -299.7},
          triangle(),
          RemovePiece{{1e-3, 2e-3, -0.0}, 300.0},
          KeepPiece{{0.1, 0.2, 0.3}, -300.0},
          RemoveSmallPieces{128.5, 1e-8},
          RemoveHolder{412.0},
          stroke(),
          tissues()};
}

TEST(EditText, ComesBackToTheBit) {
  for (const Edit& edit : oneOfEach()) {
    const std::string text = textOf(edit);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const auto back = editFrom(text);
    ASSERT_TRUE(back) << text;
    EXPECT_EQ(back->index(), edit.index());
    EXPECT_EQ(textOf(*back), text);
  }
  const LassoCut before = triangle();
  const auto after = std::get<LassoCut>(editFrom(textOf(before)).value());
  EXPECT_EQ(after.outline, before.outline);
  EXPECT_EQ(after.X_WC.matrix(), before.X_WC.matrix());
  EXPECT_EQ(after.parallel, before.parallel);
  EXPECT_EQ(after.from, before.from);
  EXPECT_EQ(after.until, before.until);
  EXPECT_EQ(after.inside, before.inside);
  EXPECT_EQ(after.isovalue, before.isovalue);
  EXPECT_EQ(std::get<Stroke>(editFrom(textOf(stroke())).value()).cuts(), stroke().cuts());
  EXPECT_EQ(std::get<Stroke>(editFrom(textOf(stroke())).value()).removed(), stroke().removed());
  const auto table = std::get<TissueTable>(editFrom(textOf(tissues())).value());
  EXPECT_EQ(table.dims(), tissues().dims());
  ASSERT_EQ(table.parts().size(), 3U);
  EXPECT_EQ(table.parts()[0].energy, 1e9 / 3.0);
  EXPECT_EQ(table.parts()[1].energy, Tissues::kNever);
  EXPECT_EQ(voxelsOf(table.parts()[0]), 8);
  const VoxelRun& run = table.parts()[0].runs[1];
  EXPECT_EQ((std::array{run.i, run.j, run.k, run.count}), (std::array{2, 4, 1, 1}));
  datasets::Random random{19};
  for (int n = 0; n < 1000; ++n) {
    const PlaneCut cut{random.box(1.0), random.direction(), random.in(-1000.0, 3000.0)};
    const auto back = std::get<PlaneCut>(editFrom(textOf(cut)).value());
    ASSERT_EQ(back.point_W, cut.point_W);
    ASSERT_EQ(back.normal_W, cut.normal_W);
    ASSERT_EQ(back.isovalue, cut.isovalue);
  }
}

TEST(EditText, OfMostCornersIsRead) {
  LassoCut cut = triangle();
  while (cut.outline.size() < kMostCorners)
    cut.outline.push_back({1.0 / double(cut.outline.size()), -1.0 / 3.0});
  EXPECT_TRUE(editFrom(textOf(cut)));
  cut.outline.push_back({0.0, 0.0});
  EXPECT_FALSE(editFrom(textOf(cut)));
}

TEST(EditText, OfATableThatIsTooLongToBeReadIsNoEdit) {
  Grid grid;
  grid.dims = {128, 1024, 65};
  auto voxels = allocateVoxels(grid.voxelCount(), ScalarType::UInt8).value();
  static_cast<std::uint8_t*>(voxels.get())[0] = 1;
  const auto scan = std::make_shared<const Volume>(
      makeVolume(grid, ScalarType::UInt8, std::move(voxels)).value());
  EditHistory history{scan};
  const auto striped = [&](std::int32_t slices, std::size_t parts) {
    std::vector<TissueTable::Part> all(parts);
    for (std::int32_t k = 0; k < slices; ++k)
      for (std::int32_t j = 0; j < 1024; ++j)
        for (std::int32_t i = 0; i < 128; i += 2) all[0].runs.push_back({i, j, k, 1});
    return TissueTable{grid.dims, std::move(all)};
  };
  const auto told = [&](const TissueTable& table) {
    const auto made = history.apply(table);
    return made ? std::string{"made"} : made.error().reason;
  };
  EXPECT_EQ(told(striped(1, kMostParts)), "made");
  EXPECT_TRUE(editFrom(textOf(striped(1, kMostParts))));
  EXPECT_EQ(told(striped(1, kMostParts + 1)), "too-large");
  // 64 runs a row
  EXPECT_EQ(told(striped(64, 1)), "made");
  EXPECT_EQ(told(striped(65, 1)), "too-large");
}

TEST(EditText, OfMostCutsIsRead) {
  std::vector<BurrCut> cuts;
  for (std::size_t n = 0; n < kMostCuts; ++n) {
    // each on a way of its own, with long numbers
    const Vec3 from{-1e-6 * double(n) / 3.0, 1e-3 / 3.0, -1e-3 / 7.0};
    const Vec3 to{-1e-6 * double(n) / 7.0 - 1e-5, 1e-4 / 3.0, -1e-4 / 7.0};
    cuts.push_back({from, from + 0.01 * (to - from), 3e-3 + 1e-10 / 3.0, 1000.0 / 3.0});
  }
  const auto back = editFrom(textOf(Stroke{cuts}));
  ASSERT_TRUE(back);
  EXPECT_EQ(std::get<Stroke>(*back).cuts(), cuts);
  cuts.push_back(cuts.back());
  EXPECT_FALSE(editFrom(textOf(Stroke{cuts})));
}

/// The text with a part of it replaced.
std::string with(std::string text, const std::string& part, const std::string& other) {
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part << " in " << text;
  return at == std::string::npos ? text : text.replace(at, part.size(), other);
}

TEST(EditText, RefusesWhatIsNone) {
  const std::string crop = textOf(oneOfEach()[0]), plane = textOf(oneOfEach()[1]),
                    lasso = textOf(oneOfEach()[2]), small = textOf(oneOfEach()[5]),
                    holder = textOf(oneOfEach()[6]), cuts = textOf(stroke()),
                    table = textOf(tissues());
  std::vector<std::string> wrong{
      "",
      "null",
      "[]",
      "{}",
      "{\"edit\":\"drill\"}",
      "{\"edit\":7}",
      with(holder, "\"remove-holder\"", "\"crop\""),
      with(holder, "}", ",\"note\":1}"),        // an unknown key
      with(holder, ",\"isovalue\":412.0", ""),  // a missing one
      with(holder, "412.0", "\"412\""),
      with(holder, "412.0", "1e400"),
      with(holder, "412.0", "null"),
      with(holder, "412.0", "1e39"),
      holder + holder,
      holder.substr(0, holder.size() - 1),
      with(crop, "[3,4,500]", "[3,4]"),
      with(crop, "[3,4,500]", "[3,4,500,6]"),
      with(crop, "[3,4,500]", "[0,4,500]"),  // empty
      with(crop, "[3,4,500]", "[3,4,5e2]"),  // no whole number
      with(crop, "[3,4,500]", "[3,4,99999999999]"),
      with(crop, "[3,4,500]", "[3,4,18446744073709551615]"),
      with(crop, "[0,1,2]", "[-1,1,2]"),
      with(plane, "\"normal\":[", "\"normal\":[7.0,"),
      with(small, "1e-08", "-1e-08"),
      with(lasso, "\"until_m\":0.2", "\"until_m\":-0.2"),
      with(lasso, "true", "1"),
      with(lasso, "\"camera\":[", "\"camera\":[0.0,"),
      with(lasso, "\"outline\":[0.1,", "\"outline\":["),      // an odd number
      with(lasso, "\"outline\":[0.1,0.2,", "\"outline\":["),  // two corners
      std::string(datasets::kLongestText + 1, ' ') + holder,
      with(cuts, "\"radius_m\":0.002", "\"radius_m\":0.0"),
      with(cuts, "\"radius_m\":0.002", "\"radius_m\":0.06"),
      with(cuts, "\"radius_m\":0.002", "\"radius_m\":9e-05"),  // it would leave gaps
      with(cuts, "\"places_m\":[", "\"places_m\":[0.1,"),
      with(cuts, ",\"radius_m\":0.002", ""),
      with(cuts, "\"removed_m3\":", "\"removed_m3\":-"),
      with(table, "[0,7,58,1]", "[0,8,57,1]"),  // beyond a row
      with(table, "[0,7,58,1]", "[0,7,58]"),
      with(table, "[0,7,58,1]", "[0,7,-58,1]"),
      with(table, "[0,7,58,1]", "[0,7,58,0]"),
      with(table, "[104,1]", "[105,1]"),  // beyond the scan
      with(table, "\"structure\":254", "\"structure\":256"),
      with(table, "[7,5,3]", "[7,5,0]"),
      with(table, "[7,5,3]", "[7,5,99999999999]"),
      with(table, "\"energy_J_m3\":", "\"energy_J_m3\":-"),
      "{\"edit\":\"stroke\",\"removed_m3\":0.0,\"ways\":[]}",
      "{\"edit\":\"stroke\",\"removed_m3\":0.0,\"ways\":[{\"isovalue\":1.0,\"places_m\":[0.1,0.1,0."
      "1],\"radius_m\":0."
      "1}]}",
  };
  PlaneCut slanted = std::get<PlaneCut>(oneOfEach()[1]);
  slanted.normal_W *= 1.01;
  wrong.push_back(textOf(slanted));
  slanted = std::get<PlaneCut>(oneOfEach()[1]);
  slanted.point_W.x() = 1e9;
  wrong.push_back(textOf(slanted));
  LassoCut skew = triangle();
  skew.X_WC.linear().col(0) *= -1.0;
  wrong.push_back(textOf(skew));
  skew = triangle();
  skew.X_WC.linear()(0, 1) += 0.01;
  wrong.push_back(textOf(skew));
  skew = triangle();
  skew.outline[1][0] = std::numeric_limits<double>::quiet_NaN();
  wrong.push_back(textOf(skew));
  for (const std::string& text : wrong) {
    const auto edit = editFrom(text);
    ASSERT_FALSE(edit) << text.substr(0, 300);
    EXPECT_EQ(edit.error().reason, "damaged");
    EXPECT_FALSE(sentence(edit.error()).empty());
  }
}

}  // namespace
