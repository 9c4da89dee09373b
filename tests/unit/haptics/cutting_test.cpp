// SPDX-License-Identifier: BSD-3-Clause
// A burr takes away what its law says, follows the hand into what it cut, and never enters what is
// left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/proxy/tick.h"
#include "haptics/proxy/touch_constants.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/servo/step.h"
#include "haptics/simulation/closed_loop.h"
#include "haptics/simulation/penetration.h"
#include "tests/support/made.h"

namespace {

using haptics::Budget;
using haptics::CarvedScene;
using haptics::CutLaw;
using haptics::Cutting;
using haptics::Pose;
using haptics::Proxy;
using haptics::Safety;
using haptics::ScalarType;
using haptics::Settings;
using haptics::StepFlags;
using haptics::Tool;
using haptics::Vec3;
using haptics::Volume;

constexpr double kVoxel = 0.4e-3, kRadius = 2e-3, kSurface = 6e-3;

/// A half-space below z = kSurface, 1,200 over air.
Volume block(ScalarType type) {
  haptics::Grid grid;
  grid.dims = {60, 60, 50};
  grid.spacing = Vec3::Constant(kVoxel);
  grid.origin = Vec3(-30 * kVoxel, -30 * kVoxel, -40 * kVoxel + kSurface);
  const bool bytes = type == ScalarType::UInt8;
  const double least = bytes ? 0.0 : -1024.0, solid = bytes ? 220.0 : 1200.0;
  return datasets::filled(grid, type, [&](auto, auto, auto k) {
    // a ramp of three voxels, with its middle at the surface
    const double above = (double(k) - 40.0) / 3.0 + 0.5;
    return std::round(solid + (least - solid) * std::clamp(above, 0.0, 1.0));
  });
}

/// A ball of points on a stick, whose centre is the tool's origin but for the stick.
Tool ballTool() {
  std::vector<Vec3> points;
  constexpr int kPoints = 600;
  const double golden = M_PI * (3.0 - std::sqrt(5.0));
  for (int n = 0; n < kPoints; ++n) {
    const double z = 1.0 - (2.0 * n + 1.0) / kPoints, r = std::sqrt(1.0 - z * z);
    points.push_back(kRadius * Vec3(r * std::cos(golden * n), r * std::sin(golden * n), z));
  }
  return {"ball", {}, haptics::makeShell(std::move(points)).value()};
}

struct Press {
  ScalarType type = ScalarType::Int16;
  double force = 2.0, seconds = 1.0;
  int hz = 1000;
  haptics::ForceLimits limits = {};
};

struct Outcome {
  double volume = 0.0, given = 0.0;  ///< m3: removed, and what the law says of the pushes
  double depth = 0.0, radius = 0.0;  ///< m: of the ball that was cut
  double deepest = 0.0;              ///< m: penetration
  std::vector<double> wanted, sent;  ///< N up, in each tick: before the gate, and behind it
};

/// Presses the ball into the block by a device that is moved so that the coupling has this force.
Outcome press(const Press& how, const CutLaw& law) {
  const double s = how.type == ScalarType::UInt8 ? 110.0 : 88.0;
  const auto scene = haptics::makeScene(made::shared(block(how.type)), ballTool()).value();
  Cutting cutting{CarvedScene::of(*scene).value(), law};
  Pose X = Pose::Identity();
  X.translation().z() = kSurface + kRadius + 0.2e-3;
  Proxy proxy{*cutting.scene(), X};
  Safety safety{how.limits};
  const double period = 1.0 / how.hz;
  Settings settings;
  settings.isovalue = s;
  settings.stiffness = 5000.0;
  Outcome outcome;
  Pose X_WD = X;
  for (int n = 0; n < how.seconds * how.hz; ++n) {
    // as far before the proxy as the force wants
    X_WD.translation() = proxy.X_WP.translation() - Vec3(0.0, 0.0, how.force / settings.stiffness);
    Budget budget = Budget::counted(1'000'000);
    const auto result = haptics::servoTick(
        {X_WD, settings, StepFlags::kArmed | StepFlags::kCut, nullptr, nullptr, nullptr, &cutting},
        cutting.scene().get(), &proxy, safety, period, budget);
    outcome.wanted.push_back(result.tick.wrench_W.force.z());
    outcome.sent.push_back(result.sent_W.force.z());
    outcome.given += law.share * cutting.force() * law.speed * law.burr.radius * period /
                     law.material.energyAt(s);
    outcome.deepest =
        std::max(outcome.deepest, haptics::penetration(*cutting.scene(), s, proxy.X_WP));
    if (cutting.begun())
      outcome.depth = kSurface - cutting.begun()->to_W.z() + cutting.begun()->radius;
    outcome.radius = kRadius + cutting.scene()->lengths.epsilon;
  }
  outcome.volume = cutting.removed().volume;
  return outcome;
}

CutLaw lawOf() {
  CutLaw law;
  law.burr = {Vec3::Zero(), kRadius};
  law.material.bands[0].energy = 1e9;
  return law;
}

TEST(Cutting, TakesWhatTheLawSays) {
  for (const double force : {0.5, 2.0, 10.0}) {
    const Press how{.force = force, .seconds = 10.0 / (force * 3.77)};
    const Outcome cut = press(how, lawOf());
    const double law = 0.3 * force * 6283.0 * kRadius / 1e9 * how.seconds;
    const double h = cut.depth, cap = M_PI * h * h * (3.0 * cut.radius - h) / 3.0;
    EXPECT_NEAR(cut.volume / law, 1.0, 0.01) << force;
    EXPECT_NEAR(cap / law, 1.0, 0.01) << force;
    EXPECT_EQ(cut.deepest, 0.0);
  }
}

TEST(Cutting, LeavesNoContactOfWhatIsGone) {
  const auto scene = haptics::makeScene(made::shared(block(ScalarType::Int16)), ballTool()).value();
  Cutting cutting{CarvedScene::of(*scene).value(), lawOf()};
  Pose X = Pose::Identity();
  X.translation().z() = kSurface + kRadius - 0.1e-3;
  Proxy proxy{*cutting.scene(), X};
  haptics::Contact under, beside;
  under.r_W = Vec3(0.0, 0.0, -kRadius);
  beside.r_W = Vec3(0.02, 0.0, 0.0);
  // those of the search, and those that it may return to
  for (haptics::Contacts* contacts : {&proxy.contacts, &proxy.search.contacts_taken}) {
    contacts->push(under);
    contacts->push(beside);
  }
  proxy.bearing.push({under.r_W, Vec3::UnitZ(), 2.0});
  Budget budget = Budget::counted(1'000'000);
  cutting.go(true, proxy, X, 88.0, 1e-3, budget);
  EXPECT_GT(cutting.removed().voxels, 0);
  for (const haptics::Contacts* contacts : {&proxy.contacts, &proxy.search.contacts_taken}) {
    ASSERT_EQ(contacts->size(), 1U);
    EXPECT_EQ((*contacts)[0].r_W.x(), 0.02);
  }
}

TEST(Cutting, OutlivesAPoseThatIsNoNumber) {
  const auto scene = haptics::makeScene(made::shared(block(ScalarType::Int16)), ballTool()).value();
  Cutting cutting{CarvedScene::of(*scene).value(), lawOf()};
  Pose X = Pose::Identity();
  X.translation().z() = kSurface + kRadius + 0.2e-3;
  Proxy proxy{*cutting.scene(), X};
  Settings settings;
  settings.isovalue = 88.0;
  Safety safety{{}};
  haptics::ServoResult last;
  for (int n = 0; n < 400; ++n) {
    Pose X_WD = X;
    X_WD.translation() -= Vec3(1e-6 * n, 0.0, 1e-3);
    if (n == 200) X_WD.translation().x() = NAN;
    Budget budget = Budget::counted(1'000'000);
    last = haptics::servoTick(
        {X_WD, settings, StepFlags::kArmed | StepFlags::kCut, nullptr, nullptr, nullptr, &cutting},
        cutting.scene().get(), &proxy, safety, 1e-3, budget);
    if (n == 200) {
      EXPECT_EQ(last.sent_W.force.norm(), 0.0);
    }
  }
  EXPECT_TRUE(last.tick.wrench_W.force.allFinite());
  EXPECT_GT(last.tick.wrench_W.force.norm(), 0.1);
  EXPECT_GT(cutting.force(), 0.1);
}

// deeper than half of it, a ball goes down a hole of its own width, and is held by no wall
TEST(Cutting, BeginsAWayAnewAfterALift) {
  const auto scene = haptics::makeScene(made::shared(block(ScalarType::Int16)), ballTool()).value();
  Cutting cutting{CarvedScene::of(*scene).value(), lawOf()};
  Pose X_WD = Pose::Identity();
  X_WD.translation().z() = kSurface + kRadius + 0.2e-3;
  Proxy proxy{*cutting.scene(), X_WD};
  Safety safety{haptics::ForceLimits{}};
  Settings settings;
  settings.isovalue = 88.0;
  settings.stiffness = 1000.0;
  std::vector<haptics::BurrCut> cuts;
  const auto holdAt = [&](double x, double z, int ticks) {
    X_WD.translation() = Vec3(x, 0.0, kSurface + kRadius + z);
    cuts.clear();
    for (int n = 0; n < ticks; ++n) {
      Budget budget = Budget::counted(1'000'000);
      haptics::servoTick({X_WD, settings, StepFlags::kArmed | StepFlags::kCut, nullptr, nullptr,
                          nullptr, &cutting},
                         cutting.scene().get(), &proxy, safety, 1e-3, budget);
      if (cutting.begun()) cuts.push_back(*cutting.begun());
    }
  };
  const auto goOn = [&] {
    return std::ranges::count_if(
        cuts, [](const haptics::BurrCut& cut) { return cut.from_W != cut.to_W; });
  };
  holdAt(0.0, -1e-3, 100);
  EXPECT_GT(goOn(), 0);
  holdAt(0.0, 2e-3, 50);
  holdAt(0.5e-3, -1e-3, 100);
  ASSERT_FALSE(cuts.empty());
  EXPECT_EQ(cuts.front().from_W, cuts.front().to_W);
  EXPECT_GT(goOn(), 0);
}

TEST(Cutting, FitsIntoWhatItCut) {
  if (made::kSanitized) GTEST_SKIP() << "it is as long as all others together";
  const Press how{.force = 0.5, .seconds = 30.0 / (0.5 * 3.77)};
  const Outcome cut = press(how, lawOf());
  const double hole = 2.0 / 3.0 * M_PI * std::pow(cut.radius, 3) +
                      M_PI * cut.radius * cut.radius * (cut.depth - cut.radius);
  EXPECT_NEAR(cut.volume / 30e-9, 1.0, 0.02);
  EXPECT_NEAR(hole / 30e-9, 1.0, 0.04);
  EXPECT_EQ(cut.deepest, 0.0);
}

TEST(Cutting, TakesTheSameAtEveryRateAndInEveryType) {
  const Outcome at_1000 = press({}, lawOf());
  for (const int hz : {500, 4000}) {
    const Outcome other = press({.hz = hz}, lawOf());
    EXPECT_NEAR(other.volume / at_1000.volume, 1.0, 0.005) << hz;
  }
  for (const ScalarType type : {ScalarType::UInt8, ScalarType::Float32}) {
    const Outcome other = press({.type = type}, lawOf());
    EXPECT_NEAR(other.volume / at_1000.volume, 1.0, 0.005) << haptics::nameOf(type);
  }
}

TEST(Cutting, VibratesAsTeethPassAndNoMoreThanTheGateLets) {
  using haptics::vibrationFrequency;
  constexpr double kTurn = 2.0 * M_PI;
  // teeth pass 200 and 8,000 times in a second; the latter is beyond what is felt or rendered
  EXPECT_DOUBLE_EQ(vibrationFrequency(25.0 * kTurn, 1e-3), 200.0);
  EXPECT_DOUBLE_EQ(vibrationFrequency(1000.0 * kTurn, 1e-3), 250.0);
  EXPECT_DOUBLE_EQ(vibrationFrequency(1000.0 * kTurn, 2.5e-4), 250.0);
  EXPECT_DOUBLE_EQ(vibrationFrequency(1010.0 * kTurn, 1e-3), 8080.0 / 33.0);
  EXPECT_DOUBLE_EQ(vibrationFrequency(25.0 * kTurn, 2e-3), 100.0);
  const haptics::ForceLimits limits = haptics::limitsOf(*haptics::findRating("falcon"));
  for (const int hz : {1000, 4000})
    for (const double force : {1.0, 8.0}) {
      CutLaw law = lawOf();
      law.speed = 20.0 * kTurn;  // 160 Hz
      const Press how{.force = force, .seconds = 0.5, .hz = hz, .limits = limits};
      const Outcome still = press(how, law);
      law.vibration = 0.25;
      const Outcome shaken = press(how, law);
      // the device is led, so the vibration is all that differs
      EXPECT_EQ(shaken.volume, still.volume);
      EXPECT_EQ(shaken.depth, still.depth);
      const double most = std::min(0.25 * force, haptics::kMostVibration);
      double greatest = 0.0, all = 0.0, cosine = 0.0, sine = 0.0, least = 0.0, step = 0.0;
      const std::size_t count = shaken.wanted.size();
      for (std::size_t n = count / 5; n < count; ++n) {
        const double shake = shaken.wanted[n] - still.wanted[n],
                     at = kTurn * 160.0 * double(n) / hz;
        greatest = std::max(greatest, std::abs(shake));
        all += shake * shake;
        cosine += shake * std::cos(at);
        sine += shake * std::sin(at);
        least = std::min(least, shaken.wanted[n]);
        step = std::max(step, std::abs(shaken.sent[n] - shaken.sent[n - 1]));
        EXPECT_LE(std::abs(shaken.sent[n]), limits.force * (1.0 + 1e-12));
      }
      EXPECT_LE(greatest, most * 1.01) << force;
      EXPECT_GE(greatest, most * 0.9) << force;
      const double of_it = 2.0 * (cosine * cosine + sine * sine) / double(count - count / 5);
      EXPECT_GT(of_it / all, 0.98) << force << ' ' << hz;
      EXPECT_GE(least, 0.0);
      EXPECT_LE(step, limits.force / (limits.rise_time * hz) * (1.0 + 1e-12));
    }
}

TEST(Cutting, DoesNotCutWithTheShaft) {
  for (const bool shaft : {true, false}) {
    // a ball with a shaft along z that is a little wider, so that the ball comes near and no more,
    // or half as wide
    const double width = shaft ? kRadius + 0.03e-3 : 0.5 * kRadius;
    std::vector<Vec3> points = ballTool().shell.points;
    for (int n = 0; n < 40; ++n)
      for (int turn = 0; turn < 24; ++turn)
        points.push_back({width * std::cos(turn * M_PI / 12.0),
                          width * std::sin(turn * M_PI / 12.0), kRadius + n * kVoxel / 2.0});
    const Tool tool{"drill", {}, haptics::makeShell(std::move(points)).value()};
    const auto scene = haptics::makeScene(made::shared(block(ScalarType::Int16)), tool).value();
    CutLaw law = lawOf();
    law.burr.centre_P = -tool.shell.origin;
    Cutting cutting{CarvedScene::of(*scene).value(), law};
    Pose X = Pose::Identity();
    X.linear() << 0, 0, -1, 0, 1, 0, 1, 0, 0;  // it lies along x
    X.translation() = Vec3(0.0, 0.0, kSurface + kRadius + 0.2e-3);
    Proxy proxy{*cutting.scene(), X};
    Safety safety{{}};
    Settings settings;
    settings.isovalue = 88.0;
    int pressed = 0;
    for (int n = 0; n < 600; ++n) {
      Pose X_WD = X;
      X_WD.translation().z() -= 5e-6 * n;
      Budget budget = Budget::counted(1'000'000);
      const auto result = haptics::servoTick({X_WD, settings, StepFlags::kArmed | StepFlags::kCut,
                                              nullptr, nullptr, nullptr, &cutting},
                                             cutting.scene().get(), &proxy, safety, 1e-3, budget);
      pressed += result.tick.contacts > 0;
    }
    EXPECT_GT(pressed, 100) << shaft;
    EXPECT_EQ(cutting.removed().voxels > 0, !shaft);
  }
}

struct Felt {
  double given = 0.0, step = 0.0;  ///< J given to the hand; N, of the force in a tick
  double deepest = 0.0, volume = 0.0;
  double impulse = 0.0;  ///< N s, on the burr
  std::int64_t unsound = 0;
};

Felt feel(haptics::HandMotion motion, double stiffness, bool cut, int hz,
          const CutLaw& law = lawOf()) {
  const auto scene = haptics::makeScene(made::shared(block(ScalarType::Int16)), ballTool()).value();
  haptics::ClosedLoop loop;
  loop.scene = scene;
  loop.rate = {hz};
  loop.settings.isovalue = 88.0;
  loop.settings.stiffness = stiffness;
  loop.grip.gyration = haptics::gyrationOf(scene->tool.shell);
  if (cut) loop.cut = law;
  Pose X = Pose::Identity();
  X.translation().z() = kSurface + 3.0 * kRadius;
  const double reach = haptics::Hand::reachFor(0.003, stiffness, loop.grip.stiffness);
  const auto hand = haptics::Hand::from(X, motion, *scene, 88.0, reach, 1).value();
  Felt felt;
  Vec3 before = Vec3::Zero(), device = hand.at(0.0).translation();
  const auto done = loop.run(hand, 5 * hz / 2, [&](const haptics::TraceRow& row) {
    felt.given = std::max(felt.given, row.energy);
    // beside what the device's own motion makes of it
    const double moved = stiffness * (row.X_WD.translation() - device).norm();
    felt.step = std::max(felt.step, (row.sent_W.force - before).norm() - moved);
    before = row.sent_W.force;
    device = row.X_WD.translation();
    felt.unsound += !row.X_WP.matrix().allFinite() || !before.allFinite();
    const haptics::Scene& touched = row.cutting != nullptr ? *row.cutting->scene() : *scene;
    felt.deepest = std::max(felt.deepest, haptics::penetration(touched, 88.0, row.X_WP));
    if (row.cutting != nullptr) {
      felt.volume = row.cutting->removed().volume;
      felt.impulse += row.cutting->force() / hz;
    }
    return true;
  });
  EXPECT_TRUE(done.has_value());
  return felt;
}

TEST(Cutting, GivesTheHandNoEnergyAndNoJerk) {
  using haptics::HandMotion;
  struct Case {
    HandMotion motion;
    double stiffness;
    int hz;
  };
  for (const Case& of :
       {Case{HandMotion::Tap, 1000.0, 1000}, Case{HandMotion::Plunge, 5000.0, 4000},
        Case{HandMotion::Mill, 200.0, 1000}, Case{HandMotion::Mill, 1000.0, 1000},
        Case{HandMotion::Hollow, 5000.0, 1000}}) {
    if (made::kSanitized && of.motion != HandMotion::Mill) continue;
    const Felt cut = feel(of.motion, of.stiffness, true, of.hz),
               whole = feel(of.motion, of.stiffness, false, of.hz);
    const int where = int(of.motion);
    EXPECT_LE(cut.given, 1e-3) << where;
    // of the same motion without a cut, or of a tool that slips off an edge
    const double fall = haptics::TouchConstants::kMostFall / of.hz;
    EXPECT_LE(cut.step, 1.2 * std::max(whole.step, fall)) << where;
    EXPECT_EQ(cut.deepest, 0.0) << where;
    EXPECT_EQ(cut.unsound, 0) << where;
    EXPECT_GT(cut.volume, 1e-9) << where;
    EXPECT_EQ(whole.volume, 0.0) << where;
  }
}

TEST(Cutting, AVibrationGivesTheHandNoEnergyEither) {
  for (const double teeth_hz : {60.0, 120.0, 250.0}) {
    CutLaw law = lawOf();
    law.speed = teeth_hz / haptics::kBurrTeeth * 2.0 * M_PI;
    law.material.bands[0].energy *= 0.01;
    law.vibration = 1.0;
    const Felt shaken = feel(haptics::HandMotion::Mill, 1000.0, true, 1000, law);
    EXPECT_LE(shaken.given, 1e-3) << teeth_hz;
    EXPECT_EQ(shaken.deepest, 0.0) << teeth_hz;
    EXPECT_EQ(shaken.unsound, 0) << teeth_hz;
    EXPECT_GT(shaken.volume, 1e-9) << teeth_hz;
    std::printf("%g Hz: %g mJ, %g mm3\n", teeth_hz, 1e3 * shaken.given, 1e9 * shaken.volume);
    if (made::kSanitized) break;
  }
}

TEST(Cutting, BearsTheSameImpulseAtEveryRateAndTakesWhatTheLawSaysOfIt) {
  using haptics::HandMotion;
  const CutLaw law = lawOf();
  for (const HandMotion motion : {HandMotion::Mill, HandMotion::Hollow, HandMotion::Plunge}) {
    if (made::kSanitized && motion != HandMotion::Mill) continue;
    const Felt once = feel(motion, 1000.0, true, 1000), often = feel(motion, 1000.0, true, 4000);
    EXPECT_GT(once.impulse, 5.0) << int(motion);
    EXPECT_NEAR(often.impulse / once.impulse, 1.0, 0.03) << int(motion);
    for (const Felt& felt : {once, often}) {
      const double taken =
          law.share * felt.impulse * law.speed * law.burr.radius / law.material.energyAt(88.0);
      EXPECT_NEAR(felt.volume / taken, 1.0, 0.006) << int(motion);
    }
  }
}

}  // namespace
