// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/study/stability/cuts.h"
#include "app/study/stability/failures.h"
#include "app/study/stability/loops.h"
#include "app/study/stability/rivals.h"
#include "datasets/phantoms/making.h"
#include "tests/support/made.h"

namespace {

using haptics::DeviceModel;
using haptics::findDeviceModel;
using study::Depth;
using study::Job;
using study::Outcome;
using study::Study;
using study::stability::Wall;

/// A handle that swings in a sampled spring of `share` of its limit, and a proxy that steps
/// `carried` [m] away from it before each way back, so that it is pulled harder than it pulled.
study::stability::EnergyBalance swung(double share, double carried = 0.0) {
  const haptics::Grip grip;
  const double T = 1e-3, K = share * 2.0 * grip.damping / T;
  study::stability::EnergyBalance balance{K, grip, T};
  haptics::Vector6 stretch = haptics::Vector6::Zero();
  double x = 0.0, given = 0.0;
  haptics::Wrench held;
  for (int n = 1; n <= 2000; ++n) {
    const double before = x;
    x = 2e-3 * std::sin(0.3 * n);
    given += held.force.z() * (x - before);
    const bool way_back = std::abs(x) < std::abs(before);
    stretch[2] = x + (way_back ? std::copysign(carried, x) : 0.0);
    balance.add(given, held, {{0, 0, x - before}, haptics::Vec3::Zero()}, stretch);
    held.force.z() = -K * stretch[2];
  }
  return balance;
}

// up to the limit damping takes what sampling gives; beyond it no longer, at any amplitude
TEST(EnergyBalance, TellsALoopThatShakesFromOneThatGivesALittleAtEachStroke) {
  const study::stability::EnergyBalance calm = swung(0.45), shaking = swung(1.2);
  EXPECT_GT(calm.most_given, 1e-3);
  EXPECT_LT(calm.most_left, 1e-3);
  EXPECT_GT(shaking.most_left, 1e-3);
  // both are a sampled spring, and nothing but that
  EXPECT_LT(calm.most_own, 1e-9);
  EXPECT_LT(shaking.most_own, 1e-9);
}

// what it tells is exact: given and stored together are what sampling gave
TEST(EnergyBalance, TellsWhatALateSpringGivesWhateverItsDelay) {
  constexpr double kStiffness = 2000.0;  // N/m
  for (const double delay : {0.0, 0.5, 1.0, 1.75}) {
    haptics::Linkage link;
    link.delay = delay;
    study::stability::EnergyBalance balance{kStiffness, {}, 1e-3, delay};
    datasets::Random random{5};
    double given = 0.0;
    haptics::Vec3 x = haptics::Vec3::Zero();
    for (int tick = 0; tick < 200; ++tick) {
      const haptics::Wrench held = link.late({-kStiffness * x, haptics::Vec3::Zero()});
      const haptics::Vec3 way = random.box(1e-4);
      x += way;
      given += held.force.dot(way);
      haptics::Vector6 stretch = haptics::Vector6::Zero();
      stretch.head<3>() = x;
      balance.add(given, held, {way, haptics::Vec3::Zero()}, stretch);
    }
    const double stored = 0.5 * kStiffness * x.squaredNorm();
    EXPECT_NEAR(given + stored, balance.sampled, 1e-9 * stored) << delay;
    EXPECT_GT(balance.sampled, 1e-6);
  }
}

TEST(EnergyBalance, SeesAProxyThatPaysTheHand) {
  EXPECT_GT(swung(0.1, 1e-4).most_own, 1e-3);
  // damping hides it from the other figure
  EXPECT_LT(swung(0.1, 1e-4).most_left, 1e-3);
}

TEST(Wall, TheMeasuredLimitOfAWellDampedDeviceIsThatOfTheory) {
  for (const char* name : {"falcon", "sigma.7", "touch", "delta.3"})
    for (const double period : {1e-3, 0.25e-3}) {
      const Wall wall{findDeviceModel(name).value(), {}, period};
      ASSERT_GE(wall.totalDamping(), 5.0);
      EXPECT_DOUBLE_EQ(wall.theory(), 2.0 * 5.0 / period);
      const double measured = study::stability::measuredLimit(wall).stiffness;
      EXPECT_NEAR(measured / wall.theory(), 1.0, 0.15) << name;
      EXPECT_NEAR(measured / study::stability::linearLimit(wall).stiffness, 1.0, 0.15) << name;
    }
}

// two ways to one figure: bisection on presses, and eigenvalues
TEST(Wall, DelayAndVirtualDampingMoveTheMeasuredLimitAsTheyMoveTheLinearOne) {
  Wall wall{findDeviceModel("falcon").value(), {}, 1e-3};
  wall.device.linkage.encoder = 1e-6;
  for (const double delay : {0.0, 0.2, 1.0, 1.5, 3.0})
    for (const double damping : {0.0, 4.0}) {
      wall.device.linkage.delay = delay;
      wall.damping = damping;
      EXPECT_NEAR(study::stability::measuredLimit(wall).stiffness /
                      study::stability::linearLimit(wall).stiffness,
                  1.0, 0.06)
          << delay << " periods, " << damping << " N s/m";
    }
}

// what a lead makes good is as if it came at once, through the tick as well
TEST(Wall, ALeadTakesTheDelayAway) {
  double limits[2];
  for (const int hz : {1000, 4000}) {
    Wall wall = study::stability::drivenAt(findDeviceModel("omega.3").value(), {hz});
    ASSERT_EQ(wall.lateness(), 0.0);
    const double measured = study::stability::measuredLimit(wall).stiffness;
    EXPECT_NEAR(measured / wall.theory(), 1.0, 0.15) << hz;
    EXPECT_NEAR(measured / study::stability::linearLimit(wall).stiffness, 1.0, 0.06) << hz;
    const double through_tick = limits[hz == 4000] = study::stability::planeLimit(wall).stiffness;
    wall.lead = 0.0;
    EXPECT_LT(study::stability::planeLimit(wall).stiffness, 0.85 * through_tick) << hz;
  }
  EXPECT_GT(limits[1], 3.0 * limits[0]);
}

// a link that is earlier or later than the lead: as stiff as without it at least
TEST(Wall, ALeadThatIsNotTheDelayDoesNoHarm) {
  for (const int hz : {1000, 2000, 4000})
    for (const double delay : {0.0, 0.0625e-3, 0.25e-3, 0.5e-3}) {
      Wall wall = study::stability::drivenAt(findDeviceModel("omega.3").value(), {hz});
      wall.device.linkage.delay = delay / wall.period;
      Wall plain = wall;
      plain.lead = 0.0;
      const double limit = study::stability::measuredLimit(plain).stiffness;
      EXPECT_FALSE(study::stability::pressOn(wall, 0.95 * limit).fed)
          << hz << ", " << delay << " s";
    }
}

// a lead that is wrong by a share of each step of the encoder keeps this one circling by 40 um, and
// one without a lead rests within 5
TEST(Press, AHandleThatIsLedRestsOnTopOfABall) {
  const Wall wall = study::stability::asShipped(findDeviceModel("lambda.7").value());
  ASSERT_GT(wall.lead, 0.0);
  const study::stability::Stage ball = study::stability::makeStage("ball", 0.0, 302);
  for (const double stiffness : {3500.0, 8000.0}) {
    const auto pressed = study::stability::press({wall, stiffness, true, ""}, ball);
    EXPECT_LT(pressed.amplitude, 0.6 * wall.device.linkage.encoder) << stiffness;
    EXPECT_GT(pressed.contact, 5000);
  }
}

TEST(Wall, WhatIsLightlyDampedRingsLongAndIsStable) {
  Wall wall{findDeviceModel("delta.3").value(), {}, 1e-3};
  wall.device.damping = 0.3;
  wall.hand.damping = 0.2;
  // m / b is 0.7 s; a verdict by what still shakes at the end would be wrong
  const auto pressed = study::stability::pressOn(wall, 0.5 * wall.theory());
  EXPECT_FALSE(pressed.fed);
  EXPECT_GT(pressed.amplitude, 4.0 * wall.device.linkage.encoder);
  EXPECT_TRUE(study::stability::pressOn(wall, 1.5 * wall.theory()).fed);
}

TEST(Wall, DryFrictionAndTheControllerRaiseTheLimit) {
  Wall wall{findDeviceModel("sigma.7").value(), {}, 1e-3};
  const double plain = study::stability::measuredLimit(wall).stiffness;
  wall.controller = 30.0;
  EXPECT_GT(study::stability::measuredLimit(wall).stiffness, 1.2 * plain);
  wall.controller = 0.0;
  wall.device.coulomb = 0.2;
  EXPECT_GT(study::stability::measuredLimit(wall).stiffness, 1.2 * plain);
}

TEST(Wall, AboveItsLimitItGivesEnergyAndBelowHardlyAny) {
  const Wall wall{findDeviceModel("sigma.7").value(), {}, 1e-3};
  EXPECT_GT(study::stability::pressOn(wall, 1.3 * wall.theory()).energy, 20e-3);  // J
  EXPECT_LT(study::stability::pressOn(wall, 0.5 * wall.theory()).energy, 1e-3);
}

TEST(PlantedError, AForceThatLagsATickFailsTheLimitOfEveryDevice) {
  for (const DeviceModel& device : haptics::deviceModels()) {
    if (!device.linkage.arm.isZero(0.0)) continue;
    Wall wall{device, {}, 1e-3};
    const double theory = wall.theory();
    const double sound = study::stability::measuredLimit(wall).stiffness / theory;
    wall.device.linkage.delay += 1;
    const double lags = study::stability::measuredLimit(wall).stiffness / theory;
    EXPECT_GE(sound, study::stability::kLeastOfTheory) << device.name;
    EXPECT_LT(lags, 0.5) << device.name;
  }
}

TEST(Plane, TheLimitThroughTheTickIsThatOfTheWall) {
  Wall wall{findDeviceModel("falcon").value(), {}, 1e-3};
  EXPECT_NEAR(study::stability::planeLimit(wall).stiffness / wall.theory(), 1.0, 0.15);
  EXPECT_NEAR(study::stability::planeLimit(wall).stiffness /
                  study::stability::measuredLimit(wall).stiffness,
              1.0, 0.15);
  wall.damping = 5.0;
  EXPECT_NEAR(study::stability::planeLimit(wall).stiffness /
                  study::stability::measuredLimit(wall).stiffness,
              1.0, 0.15);
}

TEST(PlantedError, AForceThatLagsATickLowersTheLimitThroughTheTick) {
  Wall wall{findDeviceModel("falcon").value(), {}, 1e-3};
  const double theory = wall.theory();
  wall.device.linkage.delay = 1;
  EXPECT_LT(study::stability::planeLimit(wall).stiffness / theory, 0.5);
}

TEST(PlantedError, AControllerThatIsOffIsSeenThroughTheTick) {
  Wall wall{findDeviceModel("sigma.7").value(), {}, 1e-3};
  const double beyond = 1.5 * wall.theory();
  EXPECT_TRUE(study::stability::pressOnPlane(wall, beyond).fed);
  wall.controller = wall.device.rating.damping;
  const auto controlled = study::stability::pressOnPlane(wall, beyond);
  EXPECT_FALSE(controlled.fed);
  EXPECT_LT(controlled.energy, 1e-3);  // J
}

TEST(PlantedError, AForceThatLagsATickGivesEnergyInAPress) {
  DeviceModel device = findDeviceModel("lambda.7").value();
  const auto stage = study::stability::makeStage("ball", 0.0, 1);
  const double stiffness = study::stability::allowedFor({device}, *stage.scene);
  const auto sound = study::stability::press({{device}, stiffness}, stage);
  device.linkage.delay = 1;
  const auto lags = study::stability::press({{device}, stiffness}, stage);
  EXPECT_GT(sound.contact, 400);
  EXPECT_LT(sound.energy, 1e-3);  // J
  EXPECT_GT(lags.energy, 10e-3);
  EXPECT_GT(lags.amplitude, 10.0 * sound.amplitude);
}

// five times as stiff as is allowed: the guard is in the loop that cases are about
TEST(Press, AsShippedIsGuarded) {
  const DeviceModel device = findDeviceModel("sigma.7").value();
  const auto stage = study::stability::makeStage("ball", 0.0, 1);
  const double allowed = study::stability::allowedFor({device}, *stage.scene);
  EXPECT_EQ(study::stability::press({{device}, allowed, true}, stage).share, 1.0);
  EXPECT_LT(study::stability::press({{device}, 5.0 * allowed, true}, stage).share, 0.7);
  EXPECT_EQ(study::stability::press({{device}, 5.0 * allowed}, stage).share, 1.0);
}

/// A method whose force is that of the tick before.
class ATickLate final : public comparison::Method {
 public:
  explicit ATickLate(comparison::Method& method) : method_{method} {}
  const char* name() const override { return "late"; }
  void start(const haptics::Pose& X_WP) override { method_.start(X_WP); }

 private:
  void step(const haptics::Pose& X_WD, comparison::Tick& tick) override {
    tick = method_.tick(X_WD);
    std::swap(tick.force, force_);
  }
  comparison::Method& method_;
  haptics::Vec3 force_ = haptics::Vec3::Zero();
};

TEST(Rivals, InTheLoopEnterWhereOursDoesNotAndLateForcesGiveEnergy) {
  const comparison::Touched touched = comparison::phantomScene("sphere");
  const auto scene = haptics::makeScene(touched.volume, toolOf(touched)).value();
  constexpr double kHere = 8000.0;  // N/m
  const auto hand =
      haptics::Hand::aimed(haptics::HandMotion::Tap, *scene, touched.isovalue, 0.01, 1).value();
  const auto run = [&](comparison::Method& method) {
    return study::stability::runRival(method, findDeviceModel("lambda.7").value(), hand, touched,
                                      scene->tool.shell, {}, kHere, 900);
  };
  const auto ours = comparison::ours(scene, touched.isovalue, {0, haptics::kTickWork}, kHere);
  // with no layer outside that pushes, it must be inside to push at all
  rivals::PenaltySettings settings;
  settings.layer = 0.0;
  const auto penalty = comparison::penalty(touched, scene->tool.shell, settings, {}, kHere);
  const auto own = run(*ours), other = run(*penalty);
  EXPECT_GT(own.contact, 50);
  EXPECT_GT(other.contact, 50);
  EXPECT_EQ(own.penetration, 0.0);
  EXPECT_GT(other.penetration, 1e-6);
  ATickLate late{*ours};
  const auto planted = run(late);
  EXPECT_GT(planted.beyond_damping, own.beyond_damping + 1e-4);
  EXPECT_GT(planted.shaking, own.shaking);
}

TEST(PressJobs, JudgeWhatIsAllowedAndShowTheRestAsRows) {
  for (const Job& job : study::stability::pressJobs(Depth::Quick)) {
    if (job.name != "press/touch/ball") continue;
    const Outcome outcome = job.run(1);
    ASSERT_EQ(outcome.tables.size(), 2u);
    const auto& head = outcome.tables[0].head;
    const auto share = std::size_t(std::ranges::find(head, "of what is allowed") - head.begin());
    ASSERT_LT(share, head.size());
    double most = 0.0;
    for (const auto& row : outcome.tables[0].rows) most = std::max(most, std::stod(row[share]));
    EXPECT_EQ(most, 1.0);
    EXPECT_FALSE(outcome.tables[1].rows.empty());
    for (const auto& row : outcome.tables[1].rows) EXPECT_GT(std::stod(row[share]), 1.0);
    return;
  }
  FAIL() << "no such job";
}

TEST(StabilityStudy, HasEveryDeviceAndNamesEachJobOnce) {
  for (const Depth depth : {Depth::Quick, Depth::Full}) {
    const Study study = study::stability::stabilityStudy(depth);
    std::set<std::string> names;
    for (const Job& job : study.jobs) {
      EXPECT_TRUE(names.insert(job.name).second) << job.name;
      EXPECT_GT(job.cost, 0.0);
      EXPECT_FALSE(job.section.empty());
    }
    for (const DeviceModel& device : haptics::deviceModels()) {
      if (device.linkage.arm.isZero(0.0)) {
        EXPECT_TRUE(names.contains("limit/" + device.name + "/1 kHz")) << device.name;
      }
      if (depth == Depth::Full) {
        EXPECT_TRUE(names.contains("press/" + device.name + "/groove")) << device.name;
        if (device.linkage.arm.isZero(0.0)) {
          EXPECT_TRUE(names.contains("limit/" + device.name + "/4 kHz")) << device.name;
          EXPECT_TRUE(names.contains("limit in 6-DOF/" + device.name + "/4 kHz")) << device.name;
        }
      }
    }
    if (depth == Depth::Full) {
      for (const char* scene : {"bunny", "engine", "hole", "bone"})
        EXPECT_TRUE(names.contains(std::string{"hands/"} + scene)) << scene;
      for (const std::string& stage : study::stability::cutStages())
        EXPECT_TRUE(names.contains("cuts/lambda.7/" + stage)) << stage;
      EXPECT_TRUE(names.contains("press/lambda.7/ball/4 kHz"));
      EXPECT_TRUE(names.contains("press/touch/plane/4 kHz"));
    }
  }
}

// of one kind a trial lags by 1 and then 3 mm, another by 2 mm for a tick; one of another kind by 4
TEST(DistancePlot, GivesMeanLeastAndGreatestOfTheTrialsOfAName) {
  const study::stability::Trial still{study::stability::makeStage("ball", 0.0, 1).scene, 0.0,
                                      made::at(0, 0, 0.03)};
  std::deque<study::stability::Trial> trials(3, still);
  trials[0].behind = {1e-3f, 3e-3f};
  trials[1].behind = {2e-3f};
  trials[2].behind = {4e-3f};
  trials[2].name = "other";
  const auto plot = study::stability::distancePlot("some", trials);
  ASSERT_EQ(plot.series.size(), 2u);
  const auto& points = plot.series[0].points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_FLOAT_EQ(points[0].low, 1.0);
  EXPECT_FLOAT_EQ(points[0].y, 1.5);
  EXPECT_FLOAT_EQ(points[0].high, 2.0);
  EXPECT_FLOAT_EQ(points[1].y, 3.0);
  EXPECT_DOUBLE_EQ(points[1].x, 1e-3);
  EXPECT_EQ(plot.series[1].name, "other");
  ASSERT_EQ(plot.series[1].points.size(), 1u);
  EXPECT_FLOAT_EQ(plot.series[1].points[0].y, 4.0);
}

// a trial records what its proxy did
TEST(DistancePlot, ATrialIsBehindWhereItsDeviceIsInside) {
  study::stability::Trial trial{study::stability::makeStage("ball", 0.0, 1).scene, 0.0,
                                made::at(0, 0, 0.03)};
  trial.carry(made::at(0, 0, 0.03), made::at(0, 0, 0.015), 50);
  ASSERT_EQ(trial.behind.size(), 50u);
  EXPECT_EQ(trial.behind.front(), 0.0f);
  EXPECT_NEAR(trial.behind.back(), 3e-3, 0.2e-3);  // the ball of 3 mm rests on that of 15
}

// each pose in the voxels that its tick found, which at the end are those of the recorded cuts
TEST(Cuts, LeaveTheToolOutsideAndAreThoseThatWereTold) {
  const Wall wall{findDeviceModel("falcon").value()};
  for (const auto isovalue :
       {study::stability::IsovalueWay::Still, study::stability::IsovalueWay::Rising}) {
    const study::stability::CutWay way{"thin wall", wall, 1500.0, 3, false, isovalue};
    const auto cut = study::stability::runCut(way, study::stability::softBone());
    EXPECT_EQ(cut.inside, 0);
    EXPECT_EQ(cut.loop.inside, 0);
    EXPECT_EQ(cut.loop.non_finite, 0);
    EXPECT_GT(cut.removed, 5e-9);
    EXPECT_GT(cut.cuts.size(), 100u);
    EXPECT_EQ(cut.left, cut.carved_anew);
    const auto again = study::stability::runCut(way, study::stability::softBone(), false);
    EXPECT_EQ(cut.trace, again.trace);
    EXPECT_EQ(cut.left, again.left);
  }
}

// what grows over the tool as the isovalue falls is seen, and is over soon
TEST(Cuts, AreJudgedAtTheIsovalueOfTheTick) {
  const study::stability::CutWay way{"plate", Wall{findDeviceModel("falcon").value()}, 20'000.0, 3,
                                     false,   study::stability::IsovalueWay::ToAndFro};
  const auto cut = study::stability::runCut(way, study::stability::softBone());
  EXPECT_GT(cut.inside, 0);
  EXPECT_EQ(cut.entered, 0);
  EXPECT_LE(cut.longest_inside, 20);
}

// a short form of the study: one job of each kind, twice
TEST(StabilityStudy, IsTheSameForTheSameSeedAndPasses) {
  const Study study = study::stability::stabilityStudy(Depth::Quick);
  std::set<std::string> names;
  int jobs = 0;
  for (const Job& job : study.jobs) {
    if (job.name != "press/touch/groove" && job.name != "limit/touch/1 kHz" &&
        job.name != "limit in 6-DOF/touch/1 kHz" && job.name != "hands/turned arm" &&
        job.name != "hands/slot" && job.name != "failures/saturation" &&
        job.name != "cuts/falcon/edge")
      continue;
    ++jobs;
    const Outcome first = job.run(1), second = job.run(1);
    ASSERT_FALSE(first.cases.empty());
    ASSERT_EQ(first.cases.size(), second.cases.size());
    for (std::size_t n = 0; n < first.cases.size(); ++n) {
      EXPECT_EQ(first.cases[n].value, second.cases[n].value) << first.cases[n].name;
      // on noise of 10 % a detour may go farther than is asked, and the study says so
      const std::string& name = first.cases[n].name;
      EXPECT_TRUE(first.cases[n].pass() || name.ends_with("/proxy's farthest rise"))
          << name << ": " << first.cases[n].value;
      EXPECT_TRUE(names.insert(first.cases[n].name).second) << first.cases[n].name;
    }
    EXPECT_FALSE(first.plots.empty() && first.tables.empty()) << job.name;
    for (const study::Table& table : first.tables)
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.head.size());
  }
  EXPECT_EQ(jobs, 7);
}

}  // namespace
