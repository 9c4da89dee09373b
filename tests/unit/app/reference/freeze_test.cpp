// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "app/study/reference/motion.h"
#include "app/study/reference/run.h"
#include "tests/unit/app/reference/volumes.h"

namespace {

using reference::Pose;
using reference::Quat;
using reference::Record;
using reference::Scene;
using reference::Variant;
using reference::Vec3;

constexpr double kRadius = 18e-3, kBall = 4e-3;  // m

/// 2 mm into a sphere of 18 mm with a ball of 4 mm, then 40 degrees around it in a second.
std::vector<Pose> slide() {
  std::vector<Pose> poses;
  for (int k = 0; k < 300; ++k)
    poses.push_back(
        haptics::poseOf({0, 0, kRadius + kBall + 3e-3 - k * 5e-3 / 299}, Quat::Identity()));
  const double height = kRadius + kBall - 2e-3;
  for (int k = 1; k <= 1000; ++k) {
    const double turn = 0.7 * k / 1000;
    poses.push_back(
        haptics::poseOf(height * Vec3{std::sin(turn), 0, std::cos(turn)}, Quat::Identity()));
  }
  return poses;
}

Scene sceneOf(Variant variant, double noise) {
  const auto volume = reference_test::sphere(56, 1e-3, kRadius, noise);
  return {.solid = {volume, 0.0, reference::choicesFor(volume.grid, variant)},
          .shell = reference_test::ball(200, kBall)};
}

struct Outcome {
  double frozen, deepest, behind, samples_per_point;  // shares, m, m, 1
};

Outcome outcomeOf(Variant variant, double noise) {
  const Scene scene = sceneOf(variant, noise);
  const std::vector<Pose> hand = slide();
  const std::vector<Record> records = reference::run(scene, hand);
  Outcome outcome{reference::frozenShare(records, hand, scene.shell), 0.0, 0.0, 0.0};
  for (const Record& record : records) {
    outcome.deepest = std::max(outcome.deepest, record.penetration);
    outcome.samples_per_point += static_cast<double>(record.samples) / 200 / records.size();
  }
  outcome.behind = (records.back().X_WP.translation() - hand.back().translation()).norm();
  std::printf(
      "frozen %.3f of contact ticks, deepest %.2e mm, %.2f mm behind, %.2f samples a point\n",
      outcome.frozen, outcome.deepest * 1e3, outcome.behind * 1e3, outcome.samples_per_point);
  return outcome;
}

TEST(ReferenceRun, LiteralFreezesOnANoisySphereAndStaysOutside) {
  const Outcome outcome = outcomeOf(Variant::Literal, 0.02);
  EXPECT_GT(outcome.frozen, 0.5);
  EXPECT_GT(outcome.behind, 8e-3);
  EXPECT_LT(outcome.deepest, 0.5e-4);  // m: never more than epsilon
}

TEST(ReferenceRun, AcceptInsideMovesAndPenetrates) {
  const Outcome outcome = outcomeOf(Variant::AcceptInside, 0.02);
  EXPECT_LT(outcome.frozen, 0.1);
  EXPECT_LT(outcome.behind, 4e-3);
  EXPECT_GT(outcome.deepest, 1e-5);
}

TEST(ReferenceRun, CharitableFreezesLessThanLiteral) {
  const double literal = outcomeOf(Variant::Literal, 0.02).frozen;
  const Outcome charitable = outcomeOf(Variant::Charitable, 0.02);
  EXPECT_LT(charitable.frozen, literal);
}

TEST(ReferenceRun, FollowsTheDeviceInFreeSpaceWithoutAnyForce) {
  const Scene scene = sceneOf(Variant::Literal, 0.0);
  std::vector<Pose> hand;
  for (int k = 0; k < 50; ++k)
    hand.push_back(haptics::poseOf({2e-3 * k - 50e-3, 0, 40e-3}, Quat{1, 0.02 * k, 0, 0.01 * k}));
  for (const Record& record : reference::run(scene, hand)) {
    EXPECT_EQ(record.contacts, 0);
    EXPECT_LT(record.wrench.force.norm(), 1e-11);   // N: rounding of the pose
    EXPECT_LT(record.wrench.torque.norm(), 1e-11);  // N·m
    EXPECT_EQ(record.penetration, 0.0);
  }
}

TEST(ReferenceRun, PushesTheHandOutOfTheSphere) {
  const Scene scene = sceneOf(Variant::Literal, 0.0);
  std::vector<Pose> hand = slide();
  hand.resize(300);
  const Record last = reference::run(scene, hand).back();
  // 2 mm at 1000 N/m, less what 200 points leave of a ball, 0.1 mm between two of them
  EXPECT_NEAR(last.wrench.force.z(), 2.0, 0.1);
  EXPECT_LT(last.wrench.force.head<2>().norm(), 0.1);
  EXPECT_GT(last.contacts, 0);
}

}  // namespace
