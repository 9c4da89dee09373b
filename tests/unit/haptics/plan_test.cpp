// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/omissions.h"

#include <gtest/gtest.h>

#include <set>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/proxy/tick.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"
#include "tests/support/sentence.h"

namespace {

using haptics::FieldKind;
using haptics::makeScene;
using haptics::NormalKind;
using haptics::Plan;
using haptics::PlanLine;
using haptics::Scene;
using haptics::SceneOptions;
using haptics::Vec3;
using made::at;
using millimetre::h;

std::shared_ptr<const Scene> sceneOf(haptics::Tool tool, const SceneOptions& options = {}) {
  return makeScene(made::shared(datasets::solid(datasets::centredGrid(40, h),
                                                [](const Vec3& p) { return p.z(); })),
                   std::move(tool), options)
      .value();
}
const PlanLine& lineOf(const Scene& scene, bool Plan::*omission) {
  for (const PlanLine& line : scene.planned)
    if (line.omission == omission) return line;
  throw std::logic_error{"no line"};
}
std::string whyOf(const Scene& scene, bool Plan::*omission) {
  return sentence(lineOf(scene, omission).why);
}

TEST(Plan, HasALineWithAReasonForEachOmission) {
  for (const NormalKind normal : {NormalKind::Central, NormalKind::Cell, NormalKind::Spline}) {
    const auto scene =
        sceneOf(made::tool(datasets::ballPoints(200, 3e-3)), {FieldKind::Trilinear, normal, {}});
    std::set<std::string> what;
    for (const PlanLine& line : scene->planned) {
      EXPECT_EQ(line.left_out, scene->plan.*line.omission) << line.what.id;
      EXPECT_FALSE(line.why.empty()) << line.what.id;
      what.insert(line.what.id);
    }
    EXPECT_EQ(what.size(), scene->planned.size());
    EXPECT_EQ(scene->plan.central_differences, normal != NormalKind::Central);
  }
}

TEST(Plan, GivesTheReasonsOfThisScene) {
  const auto ball = sceneOf(made::tool(datasets::ballPoints(200, 3e-3))),
             point = sceneOf(made::point());
  EXPECT_NE(whyOf(*ball, &Plan::empty_space).find("200 points in 13 leaves"), std::string::npos);
  EXPECT_NE(whyOf(*point, &Plan::empty_space).find("one leaf of 1 point"), std::string::npos);
  // the greatest voxel: three voxels deep
  EXPECT_NE(whyOf(*ball, &Plan::free_space).find("above 13000"), std::string::npos);
}

TEST(Plan, SwitchesOffWhatRestsOnWhatIsSwitchedOff) {
  for (bool Plan::*omission : {&Plan::empty_space, &Plan::unspent_room}) {
    Plan plan;
    plan.*omission = false;
    const auto scene = sceneOf(made::point(), {FieldKind::Trilinear, NormalKind::Central, plan});
    EXPECT_FALSE(scene->plan.*omission);
    EXPECT_FALSE(scene->plan.free_space);
    EXPECT_NE(whyOf(*scene, omission).find("switched off"), std::string::npos);
    EXPECT_NE(whyOf(*scene, &Plan::free_space).find("rests on"), std::string::npos);
  }
}

// far from everything a tick asks for no work but the first proof, now and then
TEST(Plan, LooksAtNothingInFreeSpace) {
  const auto scene = sceneOf(made::tool(datasets::ballPoints(500, 3e-3)));
  haptics::Proxy proxy{*scene, at(0, 0, 0.5)};
  std::int64_t work = 0;
  for (int n = 1; n <= 400; ++n) {
    haptics::Budget budget = haptics::Budget::counted(haptics::kTickWork);
    const haptics::Pose X_WD = at(2e-4 * n, 0, 0.5 - 1e-4 * n);
    const auto result = haptics::tick(*scene, datasets::kSolidIso, {}, X_WD, proxy, budget, 1e-3);
    EXPECT_EQ((proxy.X_WP.matrix() - X_WD.matrix()).norm(), 0.0);
    EXPECT_EQ(result.wrench_W.force.norm(), 0.0);
    work += budget.spent();
  }
  EXPECT_LT(work, 40);
  EXPECT_GT(work, 0);
}

}  // namespace
