// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <iostream>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/servo/step.h"
#include "haptics/simulation/closed_loop.h"
#include "tests/scenario/trial.h"
#include "tests/support/millimetre.h"

namespace {

using datasets::Random;
using haptics::ClosedLoop;
using haptics::Hand;
using haptics::HandMotion;
using haptics::Pose;
using haptics::Quat;
using haptics::TraceRow;
using haptics::Vec3;
using haptics::Wrench;
using made::at;
using millimetre::h;

// penetration exactly 0 at every tick, by an evaluator that shares no code with the field
TEST(Outside, NoHandEverBringsAPointOfTheToolInside) {
  for (const char* phantom : {"sphere", "gyroid", "demo"}) {
    datasets::Phantom made = datasets::makePhantom(phantom).value();
    const double isovalue = made.isovalue;
    const auto volume = made::shared(std::move(made.volume));
    const auto scene = haptics::makeScene(volume, namedTool(made.tool)).value();
    for (const HandMotion motion : {HandMotion::Tap, HandMotion::Slide, HandMotion::Jerk}) {
      auto hand = Hand::aimed(motion, *scene, isovalue, Hand::reachFor(4e-3, 1000.0, 500.0), 3);
      ASSERT_TRUE(hand);
      ClosedLoop loop;
      loop.scene = scene;
      loop.settings.isovalue = isovalue;
      loop.grip.gyration = std::sqrt(scene->tool.shell.inertia.trace() / 3.0);
      int contact = 0, illegal = 0, ticks = 0;
      bool finite = true;
      double deepest = 0.0;
      const auto each = [&](const TraceRow& row) {
        ++ticks;
        contact += row.contacts > 0;
        finite = finite && row.X_WP.matrix().allFinite() && row.sent_W.force.allFinite();
        illegal += !evaluator::isLegal(*volume, isovalue, scene->tool.shell.points, row.X_WP);
        deepest = std::max(deepest, (row.X_WP.translation() - row.X_WD.translation()).norm());
        return true;
      };
      ASSERT_TRUE(loop.run(*hand, 2500, each));
      std::cout << phantom << " " << int(motion) << ": " << ticks << " ticks, " << contact
                << " in contact, device up to " << 1e3 * deepest << " mm from the proxy\n";
      EXPECT_EQ(illegal, 0);
      EXPECT_TRUE(finite);
      EXPECT_GT(contact, ticks / 20);  // a jerk is half the time in the air
      EXPECT_GT(deepest, 2e-3);
    }
  }
}

TEST(Outside, TwoRunsAreTheSameToTheBit) {
  const Stage stage = stageOf("gyroid", namedTool("probe"));
  const auto hand = Hand::aimed(HandMotion::Jerk, *stage.scene, stage.isovalue, 0.01, 5);
  ASSERT_TRUE(hand);
  std::vector<TraceRow> rows[2];
  for (auto& trace : rows) {
    ClosedLoop loop;
    loop.scene = stage.scene;
    loop.settings.isovalue = stage.isovalue;
    ASSERT_TRUE(loop.run(*hand, 1500, [&](const TraceRow& row) {
      trace.push_back(row);
      return true;
    }));
  }
  ASSERT_EQ(rows[0].size(), rows[1].size());
  for (std::size_t n = 0; n < rows[0].size(); ++n) {
    ASSERT_TRUE((rows[0][n].X_WP.matrix().array() == rows[1][n].X_WP.matrix().array()).all());
    ASSERT_EQ(rows[0][n].sent_W.torque, rows[1][n].sent_W.torque);
  }
}

// what a study says is of the code that drives a motor: the loop's own device poses, given to
// servoTick, come to the same, with all of a device's limits, a ramp and a guard
TEST(ClosedLoop, IsServoTickToTheBit) {
  const Stage stage = stageOf("gyroid", namedTool("probe"));
  ClosedLoop loop;
  loop.scene = stage.scene;
  loop.settings = {.isovalue = stage.isovalue, .stiffness = 30'000.0, .friction = 0.3};
  loop.limits = haptics::limitsOf(*haptics::findRating("sigma.7"));
  loop.grip.gyration = std::sqrt(stage.scene->tool.shell.inertia.trace() / 3.0);
  const double reach = Hand::reachFor(2e-4, 30'000.0, loop.grip.stiffness);
  const auto hand = Hand::aimed(HandMotion::Tap, *stage.scene, stage.isovalue, reach, 5);
  ASSERT_TRUE(hand);
  haptics::Safety safety{loop.limits};
  std::optional<haptics::Proxy> proxy;
  loop.on_start = [&](const Pose& X_WP) { proxy.emplace(*stage.scene, X_WP); };
  int felt = 0, differ = 0;
  double share = 1.0;
  ASSERT_TRUE(loop.run(*hand, 3000, [&](const TraceRow& row) {
    haptics::Budget budget = haptics::Budget::counted(haptics::kTickWork);
    const haptics::ServoResult live =
        haptics::servoTick({row.X_WD, loop.settings, haptics::StepFlags::kArmed}, stage.scene.get(),
                           &*proxy, safety, loop.rate.period(), budget);
    differ += live.sent_W.force != row.sent_W.force || live.sent_W.torque != row.sent_W.torque ||
              (proxy->X_WP.matrix().array() != row.X_WP.matrix().array()).any();
    felt += !row.sent_W.force.isZero(0.0);
    share = row.stiffness_share;
    return true;
  }));
  EXPECT_EQ(differ, 0);
  EXPECT_GT(felt, 300);
  EXPECT_LT(share, 1.0);  // or the guard's place among the steps would not be seen
}

/// Asks for more than any device has, and keeps what it is told.
struct Greedy final : haptics::WrenchHook {
  Wrench shaped(const Wrench& wanted, const Pose&, double) HAPTICS_RT override {
    wanted_W = wanted;
    return {{0.0, 0.0, 1e3}, haptics::Vec3::Zero()};
  }
  void sent(const Wrench& wrench) HAPTICS_RT override { sent_W = wrench; }

  Wrench wanted_W, sent_W;
};

TEST(WrenchHook, StandsBeforeTheGateAndIsToldWhatTheGateMadeOfIt) {
  const Stage stage = stageOf("halfspace", made::point());
  haptics::Proxy proxy{*stage.scene, at(0, 0, 1e-3)};
  haptics::Safety safety{{.force = 8.0}};
  const haptics::Settings settings{.isovalue = stage.isovalue, .stiffness = 1000.0};
  Greedy hook;
  for (int n = 0; n < 20; ++n) {
    const Pose D = at(0, 0, 1e-3 - 1e-4 * n);
    haptics::Budget budget = haptics::Budget::counted(haptics::kTickWork);
    const haptics::ServoResult result =
        haptics::servoTick({D, settings, haptics::StepFlags::kArmed, &hook}, stage.scene.get(),
                           &proxy, safety, 1e-3, budget);
    EXPECT_EQ(hook.wanted_W.force, result.tick.wrench_W.force);
    EXPECT_EQ(hook.sent_W.force, result.sent_W.force);
    EXPECT_LE(result.sent_W.force.norm(), 8.0 + 1e-9);
  }
  EXPECT_NEAR(hook.wanted_W.force.z(), 0.9, 0.05);  // N: 0.9 mm in
  EXPECT_NEAR(hook.sent_W.force.z(), 8.0, 1e-9);
}

/// Moves the isovalue and watches: never deeper than the change left it, and out in 20 ticks.
void moveIsovalue(Trial& trial, const Pose& D, double isovalue, int& inside) {
  trial.isovalue = isovalue;
  double depth = trial.penetration_mm();
  inside += depth > 0.0;
  for (int n = 1; n <= 20; ++n) {
    trial.step(D);
    const double now = trial.penetration_mm();
    ASSERT_LE(now, depth) << "tick " << n << " after the isovalue went to " << isovalue;
    depth = now;
  }
  ASSERT_TRUE(trial.isLegal()) << "20 ticks after the isovalue went to " << isovalue;
}

TEST(Outside, AMovedIsovalueNeverDeepensThePenetrationAndItIsGoneIn20Ticks) {
  int inside = 0;
  for (const char* phantom : {"sphere", "gyroid", "slot", "demo"}) {
    const Stage stage = stageOf(phantom, namedTool("probe"));
    Random random{121};
    const double least = stage.scene->volume->least, greatest = stage.scene->volume->greatest;
    const Pose from = at(0, 0, 0.15);
    const Pose start = haptics::legalPoseNear(*stage.scene, stage.isovalue, from).value();
    Trial trial{stage.scene, stage.isovalue, start};
    trial.judged = false;
    for (int n = 0; n < made::trials(40); ++n) {
      const Pose D = at(random.box(0.025), random.rotation());
      trial.hold(D, 60);
      ASSERT_TRUE(trial.isLegal());
      const double s = least + (greatest - least) * random.in(0.02, 0.98);
      moveIsovalue(trial, D, s, inside);
      if (HasFatalFailure()) return;
    }
  }
  std::cout << inside << " changes left the tool inside\n";
  EXPECT_GT(inside, made::trials(20));
}

// deep in a plateau there is no slope to follow out
TEST(Outside, AnIsovalueThatBuriesTheToolInAPlateauIsLeftIn20Ticks) {
  const auto scene = made::scene(
      datasets::solid(datasets::centredGrid(64, h), [](const Vec3& p) { return p.norm() - 0.008; }),
      ballTool(100, 1.5e-3));
  const auto volume = scene->volume;
  // outside the small ball at 1000, and everything but the corners inside at -10,999
  Trial trial{scene, datasets::kSolidIso, at(0.016, 0, 0)};
  trial.hold(at(0.016, 0, 0), 5);
  int inside = 0;
  moveIsovalue(trial, at(0.016, 0, 0), volume->least + 1.0, inside);
  EXPECT_TRUE(trial.isLegal());
  const auto buried = made::scene(
      datasets::filled(datasets::centredGrid(64, h), haptics::ScalarType::UInt8,
                       [](auto i, auto, auto) { return i < 2    ? 0.0
                                                       : i < 32 ? 100.0
                                                                : 200.0; }),
      ballTool(100, 1.5e-3));
  Trial other{buried, 150.0, at(-0.016, 0, 0)};
  other.hold(at(-0.016, 0, 0), 5);
  ASSERT_TRUE(other.isLegal());
  moveIsovalue(other, at(-0.016, 0, 0), 90.0, inside);
  EXPECT_GT(inside, 0);
}

TEST(Outside, AStartInsideIsMovedToALegalPoseNearByOrRefused) {
  const Stage stage = stageOf("sphere", ballTool(100, 2e-3));
  Random random{122};
  for (int n = 0; n < 20; ++n) {
    const Pose X = at(0.015 * random.direction());
    const auto legal = haptics::legalPoseNear(*stage.scene, stage.isovalue, X);
    ASSERT_TRUE(legal);
    EXPECT_TRUE(evaluator::isLegal(*stage.scene->volume, stage.isovalue,
                                   stage.scene->tool.shell.points, *legal));
    EXPECT_LE((legal->translation() - X.translation()).norm(), 0.050);
    // 7 mm to go; the search goes on in steps of a quarter, along 26 directions
    EXPECT_LE((legal->translation() - X.translation()).norm(), 0.0125);
  }
  const Pose outside = at(0, 0, 0.04);
  EXPECT_EQ(haptics::legalPoseNear(*stage.scene, stage.isovalue, outside)->matrix(),
            outside.matrix());
  const auto solid = made::scene(
      datasets::filled(datasets::centredGrid(128, 2e-3), haptics::ScalarType::Int16,
                       [](auto i, auto j, auto k) { return i + j + k == 0 ? 0.0 : 500.0; }),
      made::point());
  EXPECT_FALSE(haptics::legalPoseNear(*solid, 100.0, Pose::Identity()));
}

TEST(Outside, HoldsForVoxelsTenTimesAsDeepAsWide) {
  const haptics::Grid grid = datasets::centredGrid(80, 80, 12, Vec3{3e-4, 3e-4, 3e-3});
  const auto scene = made::scene(
      datasets::sampledFloat(
          grid,
          [](const Vec3& p) { return 1000.0 - 2e6 * std::clamp(p.norm() - 0.008, -4e-3, 4e-3); }),
      ballTool(150, 2e-3));
  Trial trial{scene, 1000.0, at(0.03, 0, 0)};
  trial.drag(grid.worldOf({40, 40, 6}), 0.01, 126, made::trials(300) / 10 + 3);
  EXPECT_EQ(trial.illegal, 0);
  EXPECT_EQ(trial.non_finite, 0);
  EXPECT_GT(trial.contact, 0);
  // pressed along x it settles where the sphere is, to the interpolation along z
  trial.hold(at(0.03, 0, 0), 60);
  trial.carry(at(0.03, 0, 0), at(0.006, 0, 0), 60);
  trial.hold(at(0.006, 0, 0));
  EXPECT_NEAR(trial.place().x(), 0.010, 5e-4);
}

}  // namespace
