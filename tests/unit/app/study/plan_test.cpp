// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/plan/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "app/study/plan/courses.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/support/made.h"

namespace {

using haptics::FieldKind;
using haptics::Hand;
using haptics::NormalKind;
using haptics::Plan;
using haptics::PlanLine;
using haptics::Pose;
using haptics::Scene;
using haptics::Vec3;
using haptics::Volume;
using made::at;
using study::Case;
using study::Outcome;
using study::plan::Course;

constexpr double h = 1e-3;  // m: the voxel

/// A hand that goes down through z = 0 within 0.3 s, and a little aside.
Hand downwards() {
  return Hand::along({0.0, 0.3, 0.4}, {at(0, 0, 0.010), at(0, 0, -0.010), at(0.003, 0, -0.010)})
      .value();
}

/// Solid between z = -2 mm and 0.
Volume plate() {
  return datasets::solid(datasets::centredGrid(40, h),
                         [](const Vec3& p) { return std::abs(p.z() + 0.001) - 0.001; });
}

Course pressing(std::shared_ptr<const Scene> scene) {
  return {"plate", std::move(scene), datasets::kSolidIso, {}, downwards(), 400};
}

std::vector<std::string> failing(const Outcome& outcome) {
  std::vector<std::string> names;
  for (const Case& c : outcome.cases)
    if (!c.pass()) names.push_back(c.name);
  return names;
}
bool fails(const Outcome& outcome, const std::string& name) {
  const std::vector<std::string> names = failing(outcome);
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(PlanStudy, FindsPosesAndForcesTheSameToTheBit) {
  for (const study::plan::Planned& planned : study::plan::courses(study::Depth::Quick)) {
    if (planned.phantom == "demo" || planned.phantom == "hole" || planned.brief) continue;
    SCOPED_TRACE(planned.name);
    const Course course = study::plan::made(planned, 700, 1).value();
    const Outcome outcome = study::plan::examined(course, 1);
    EXPECT_EQ(failing(outcome), std::vector<std::string>{});
    // three measures of each omission that is made, three of all, and whether it touched
    const auto lines = course.scene->planned;
    const auto left_out =
        std::count_if(lines.begin(), lines.end(), [](const PlanLine& l) { return l.left_out; });
    EXPECT_EQ(outcome.cases.size(), std::size_t(3 * left_out + 3 + (course.touches ? 1 : 0)));
    // what is not left out is listed as well, with the reason
    EXPECT_EQ(outcome.tables.front().rows.size(), lines.size() + 1);
  }
}

// in a tick the hand goes several bands: the room must be that of the step, too
TEST(PlanStudy, FindsNoDifferenceWhereTheHandStrikes) {
  Course course = pressing(made::scene(plate(), made::tool(datasets::ballPoints(300, 4e-3))));
  std::vector<double> times;
  std::vector<Pose> poses;
  for (int n = 0; n < 40; ++n) {
    times.insert(times.end(), {0.05 * n, 0.05 * n + 0.005});
    const double z = n % 2 == 0 ? 0.015 : -0.030;
    poses.insert(poses.end(), {at(1e-4 * n, 0, -0.015 - z), at(1e-4 * n, 0, z)});
  }
  course.hand = Hand::along(times, poses).value();
  course.ticks = 2000;
  EXPECT_EQ(failing(study::plan::examined(course, 1)), std::vector<std::string>{});
}

// or the sides would be alike for want of a difference
TEST(PlanStudy, DoesMoreWorkForWhatIsSwitchedOff) {
  const auto scene = made::scene(plate(), made::tool(datasets::ballPoints(300, 4e-3)));
  const Course course = pressing(scene);
  for (bool Plan::*omission :
       {&Plan::empty_space, &Plan::unspent_room, &Plan::far_gradients, &Plan::still_rows}) {
    const auto other = study::plan::without(*scene, omission);
    EXPECT_FALSE(other->plan.*omission);
    const study::plan::Comparison found = study::plan::compared(course, *scene, *other, 1);
    EXPECT_GT(found.contact_ticks, 100);
    EXPECT_GT(found.second_work, found.first_work);
    EXPECT_EQ(found.pose, 0.0);
  }
  const auto cell =
      haptics::makeScene(scene->volume, scene->tool, {FieldKind::Trilinear, NormalKind::Cell, {}})
          .value();
  const study::plan::Comparison found = study::plan::compared(
      pressing(cell), *cell, *study::plan::without(*cell, &Plan::central_differences), 1);
  EXPECT_GT(found.second_work, found.first_work);
  EXPECT_EQ(found.pose, 0.0);
}

/// The scene with a field whose bounds are those of another volume.
std::shared_ptr<const Scene> withBoundsOf(const Volume& other, const Scene& scene) {
  const auto field = std::make_shared<const haptics::ScalarField>(
      scene.volume, FieldKind::Trilinear, haptics::MaxPyramid{other});
  return std::make_shared<const Scene>(Scene{scene.id, scene.volume, scene.tool, scene.tree, field,
                                             *field, scene.metric, scene.lengths, scene.normal,
                                             scene.structures, scene.plan, scene.planned});
}

// bounds that are too low for some blocks: the plan leaves out a plate that is there
TEST(PlanStudy, ShowsAPlanThatLeavesOutWhatWasNeeded) {
  for (const int points : {1, 300}) {
    SCOPED_TRACE(points);
    const auto sound = made::scene(
        plate(), points == 1 ? made::point() : made::tool(datasets::ballPoints(points, 4e-3)));
    const Volume empty =
        datasets::solid(datasets::centredGrid(40, h), [](const Vec3&) { return 1.0; });
    const auto faulty = withBoundsOf(empty, *sound);
    EXPECT_EQ(failing(study::plan::examined(pressing(sound), 1)), std::vector<std::string>{});
    const Outcome outcome = study::plan::examined(pressing(faulty), 1);
    for (const char* measure : {"pose", "force"}) {
      EXPECT_TRUE(fails(outcome,
                        "plate: sampling where the pyramid's bounds prove the volume "
                        "free: " +
                            std::string{measure}));
      EXPECT_TRUE(fails(outcome, "plate: all of these: " + std::string{measure}));
    }
    // that the hand fell through is told as well
    EXPECT_TRUE(fails(outcome, "plate: ticks in contact"));
  }
}

// bounds that are right but for one side of the grid: found where the tool slides onto it
TEST(PlanStudy, ShowsBoundsThatAreWrongInAPartOfTheVolume) {
  const auto sound = made::scene(plate(), made::tool(datasets::ballPoints(100, 2e-3)));
  const Volume half = datasets::solid(datasets::centredGrid(40, h), [](const Vec3& p) {
    return p.x() > 0.0 ? 1.0 : std::abs(p.z() + 0.001) - 0.001;
  });
  Course course = pressing(withBoundsOf(half, *sound));
  course.hand = Hand::along({0.0, 0.2, 0.6},
                            {at(-0.013, 0, 0.010), at(-0.013, 0, -0.001), at(0.013, 0, -0.001)})
                    .value();
  course.ticks = 600;
  const Outcome outcome = study::plan::examined(course, 1);
  EXPECT_TRUE(
      fails(outcome, "plate: sampling where the pyramid's bounds prove the volume free: pose"));
  EXPECT_FALSE(fails(outcome, "plate: ticks in contact"));
}

TEST(PlanStudy, FindsThatABurrThatIsNotHeldChangesNothingAndSeesOneThatTurns) {
  std::vector<Vec3> ball = datasets::ballPoints(300, 2e-3);
  ball.push_back({0.0, 0.0, -2e-3});  // the tip, by which the burr is found
  const Course course = pressing(made::scene(plate(), made::tool(ball)));
  const Outcome ready = study::plan::uncut(course, 1);
  EXPECT_EQ(ready.cases.size(), 5u);
  EXPECT_EQ(failing(ready), std::vector<std::string>{});
  const Outcome turns = study::plan::uncut(course, 1, study::plan::Burr::Held);
  for (const char* measure : {"pose apart", "force apart", "work of a tick, more"})
    EXPECT_TRUE(fails(turns, "plate: a burr that is not held: " + std::string{measure}));
}

TEST(PlanStudy, IsMadeOfJobsWithNamesOfTheirOwn) {
  const study::Study quick = study::plan::planStudy(study::Depth::Quick),
                     full = study::plan::planStudy(study::Depth::Full);
  EXPECT_GT(full.jobs.size(), quick.jobs.size());
  std::set<std::string> names;
  for (const study::Job& job : full.jobs) names.insert(job.name);
  EXPECT_EQ(names.size(), full.jobs.size());
}

TEST(PlanStudy, ProvesNothingWhereTheToolHasNoRoom) {
  // solid for 80 mm on every side
  const auto scene =
      made::scene(datasets::filled(datasets::centredGrid(80, 2e-3), haptics::ScalarType::UInt8,
                                   [](auto i, auto, auto) { return i == 0 ? 0.0 : 200.0; }),
                  made::point());
  Course course{"solid", scene, 100.0, {}, downwards(), 10};
  EXPECT_EQ(study::plan::compared(course, *scene, *study::plan::withEverything(*scene), 1).ticks,
            0);
  const Outcome outcome = study::plan::examined(course, 1);
  EXPECT_FALSE(outcome.cases.empty());
  for (const Case& c : outcome.cases) EXPECT_FALSE(c.pass()) << c.name;
}

}  // namespace
