// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/collision.h"

#include <gtest/gtest.h>

#include <random>

#include "app/study/reference/motion.h"
#include "tests/unit/app/reference/volumes.h"

namespace {

using haptics::PointShell;
using reference::Choices;
using reference::Contact;
using reference::FirstHit;
using reference::Pose;
using reference::Quat;
using reference::Solid;
using reference::Twist;
using reference::Variant;
using reference::Vec3;

constexpr double kSide = 1e-3;  // m

Choices choicesOf(const haptics::Volume& volume, Variant variant) {
  return reference::choicesFor(volume.grid, variant);
}

Pose at(double x, double y, double z) { return haptics::poseOf({x, y, z}, Quat::Identity()); }

/// One point, at the centre of the tool.
PointShell point() {
  PointShell shell;
  shell.points = {Vec3::Zero()};
  shell.radius = 0.0;
  return shell;
}

TEST(ReferenceFirstHit, MeetsAHalfSpaceWithinEpsilonOfTheTruth) {
  const auto volume = reference_test::halfSpace(40, kSide);
  for (const Variant variant : {Variant::Literal, Variant::AcceptInside}) {
    const Solid solid{volume, 0.0, choicesOf(volume, variant)};
    std::mt19937 random{3};
    std::uniform_real_distribution<double> number{-1.0, 1.0};
    for (int trial = 0; trial < 200; ++trial) {
      const double height = 2e-3 + 1e-3 * number(random);
      const Twist motion{.linear = {3e-3 * number(random), 3e-3 * number(random), -6e-3}};
      const FirstHit hit = reference::firstHit(solid, point(), at(0, 0, height), motion);
      ASSERT_TRUE(hit.met);
      const double truth = height / 6e-3;
      const double epsilon = solid.choices().epsilon / motion.linear.norm();
      // outside end: early by less than epsilon; inside end: late by less than that
      const double sign = variant == Variant::AcceptInside ? -1.0 : 1.0;
      EXPECT_GE(sign * (truth - hit.t), -1e-12);
      EXPECT_LE(sign * (truth - hit.t), epsilon);
    }
  }
}

// the point on a turning arm comes down on the plane: height + r sin(a t) = 0
TEST(ReferenceFirstHit, FollowsTheArcOfATurningPoint) {
  const auto volume = reference_test::halfSpace(60, kSide);
  const Solid solid{volume, 0.0, choicesOf(volume, Variant::Literal)};
  PointShell shell;
  shell.points = {Vec3{0.02, 0, 0}, Vec3{-0.02, 0, 0}};
  shell.radius = 0.02;
  const double height = 0.01, angle = 1.2;
  const Twist motion{.linear = Vec3::Zero(), .angular = {0, angle, 0}};  // +x turns to -z
  const FirstHit hit = reference::firstHit(solid, shell, at(0, 0, height), motion);
  ASSERT_TRUE(hit.met);
  EXPECT_EQ(hit.point, 0);
  const double truth = std::asin(height / 0.02) / angle;
  EXPECT_LE(hit.t, truth + 1e-12);
  EXPECT_GE(hit.t, truth - solid.choices().epsilon / (0.02 * angle));
}

TEST(ReferenceFirstHit, ReportsTheEarliestOfAllPointsOnASphere) {
  const double radius = 10e-3;
  const auto volume = reference_test::sphere(50, kSide, radius, 0.0);
  const Solid solid{volume, 0.0, choicesOf(volume, Variant::Literal)};
  const PointShell shell = reference_test::ball(100, 3e-3);
  std::mt19937 random{9};
  std::normal_distribution<double> number;
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 from = Vec3{number(random), number(random), number(random)}.normalized() * 18e-3;
    const Pose X_WP = haptics::poseOf(from, Quat{1, number(random), number(random), 0});
    const Twist motion{.linear = -from};
    const FirstHit hit = reference::firstHit(solid, shell, X_WP, motion);
    ASSERT_TRUE(hit.met);
    // dense scan of every point: nothing is inside before the hit, something is just after
    bool before = false, after = false;
    for (const Vec3& r_P : shell.points) {
      for (int step = 0; step <= 400; ++step)
        before |= solid.inside(reference::moved(X_WP, motion, hit.t * step / 400.0) * r_P);
      const double later = hit.t + solid.choices().epsilon / motion.linear.norm();
      after |= solid.inside(reference::moved(X_WP, motion, later) * r_P);
    }
    EXPECT_FALSE(before);
    EXPECT_TRUE(after);
  }
}

TEST(ReferenceFirstHit, GoesAllTheWayWhereNothingIsMet) {
  const auto volume = reference_test::halfSpace(20, kSide);
  const Solid solid{volume, 0.0, choicesOf(volume, Variant::Literal)};
  const FirstHit hit =
      reference::firstHit(solid, point(), at(0, 0, 2e-3), {.linear = {3e-3, 0, -1e-3}});
  EXPECT_FALSE(hit.met);
  EXPECT_EQ(hit.t, 1.0);
}

// why a deep proxy stays deep: only a way from outside to inside counts
TEST(ReferenceFirstHit, IgnoresAPointThatStartsInside) {
  const auto volume = reference_test::halfSpace(20, kSide);
  const Solid solid{volume, 0.0, choicesOf(volume, Variant::Literal)};
  EXPECT_FALSE(reference::firstHit(solid, point(), at(0, 0, -1e-3), {.linear = {0, 0, -2e-3}}).met);
}

TEST(ReferencePrune, KeepsWhatTheWayToTheDevicePressesOn) {
  const auto volume = reference_test::halfSpace(20, kSide);
  const Solid solid{volume, 0.0, choicesOf(volume, Variant::Literal)};
  const double epsilon = solid.choices().epsilon;
  const PointShell shell = point();
  const auto kept = [&](double gap, const Vec3& way) {
    const Pose X_WP = at(0, 0, gap);
    const std::vector<Contact> contacts = {reference::contactOf(solid, shell, X_WP, 0)};
    return reference::prune(solid, shell, contacts, X_WP, {.linear = way}).size() == 1;
  };
  const double half = epsilon / 2;
  EXPECT_TRUE(kept(half, {0, 0, -1e-3}));            // pressed
  EXPECT_FALSE(kept(half, {0, 0, 1e-3}));            // lifted
  EXPECT_FALSE(kept(half, {1e-3, 0, 0}));            // slid along
  EXPECT_TRUE(kept(half, {1e-3, 0, -0.6e-3}));       // epsilon at 31 degrees goes half down, just
  EXPECT_FALSE(kept(half, {1e-3, 0, -0.55e-3}));     // at 29 degrees not
  EXPECT_FALSE(kept(half, {0, 0, -0.4 * epsilon}));  // the device itself is outside
  EXPECT_FALSE(kept(half, Vec3::Zero()));            // judged where it stands
  EXPECT_TRUE(kept(-half, Vec3::Zero()));
}

TEST(ReferencePrune, ReadsTheMotionOfEpsilonInTwoWays) {
  // a long tool turns about its centre: its tip goes epsilon, a point near the centre far less
  const auto volume = reference_test::halfSpace(60, kSide);
  Choices choices = choicesOf(volume, Variant::Literal);
  PointShell shell;
  shell.points = {Vec3{0.001, 0, 0}, Vec3{0.02, 0, 0}};
  shell.radius = 0.02;
  const Pose X_WP = at(0, 0, choices.epsilon / 2);
  const Twist free{.linear = Vec3::Zero(), .angular = {0, 0.3, 0}};
  for (const bool whole : {false, true}) {
    choices.epsilon_motion =
        whole ? reference::EpsilonMotion::WholeTool : reference::EpsilonMotion::EachPoint;
    const Solid solid{volume, 0.0, choices};
    const std::vector<Contact> contacts = {reference::contactOf(solid, shell, X_WP, 0),
                                           reference::contactOf(solid, shell, X_WP, 1)};
    EXPECT_EQ(reference::prune(solid, shell, contacts, X_WP, free).size(), whole ? 1u : 2u);
  }
}

TEST(ReferenceContacts, AreThePointsWithinEpsilonAndTheOneThatWasMet) {
  const auto volume = reference_test::halfSpace(40, kSide);
  const Solid solid{volume, 0.0, choicesOf(volume, Variant::Literal)};
  const double epsilon = solid.choices().epsilon;
  PointShell shell;
  shell.points = {Vec3{1e-3, 0, 0.5 * epsilon}, Vec3{2e-3, 0, 1.5 * epsilon},
                  Vec3{3e-3, 0, 2.5 * epsilon}, Vec3{4e-3, 0, -1e-3}};
  shell.radius = 5e-3;
  const auto contacts = reference::contactsAt(solid, shell, at(0, 0, 0), 1);
  ASSERT_EQ(contacts.size(), 3u);
  EXPECT_EQ(contacts[0].point, 0);
  EXPECT_EQ(contacts[1].point, 1);
  EXPECT_EQ(contacts[2].point, 3);  // inside is within
  for (const Contact& contact : contacts) EXPECT_TRUE(contact.n_W.isApprox(Vec3::UnitZ(), 1e-6));
  EXPECT_NEAR(contacts[0].gap, 0.5 * epsilon, 1e-9);
  EXPECT_NEAR(contacts[2].gap, -1e-3, 1e-9);
}

}  // namespace
