// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/hand.h"

#include <gtest/gtest.h>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/simulation/grip.h"
#include "tests/support/made.h"

namespace {

using haptics::Grip;
using haptics::Hand;
using haptics::HandMotion;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;
using haptics::Wrench;
using made::at;

constexpr double kPeriod = 1e-3;  // s

TEST(Grip, GivesWayByForceOverStiffnessAndTorqueOverItsAngularOne) {
  Grip grip;
  const Wrench felt{{0.5, 0, -1.0}, {0, 2e-2, 0}};
  for (int n = 0; n < 2000; ++n) grip.advance(Pose::Identity(), felt, kPeriod);
  EXPECT_LT((grip.X_WD.translation() - felt.force / grip.stiffness).norm(), 1e-9);
  const Eigen::AngleAxisd turn{grip.X_WD.linear()};
  EXPECT_NEAR(turn.angle(), 2e-2 / (grip.stiffness * grip.gyration * grip.gyration), 1e-6);
  EXPECT_NEAR(std::abs(turn.axis().y()), 1.0, 1e-6);
}

TEST(Grip, FollowsAFreeHandBy15MillisecondsAndDoesNotRing) {
  Grip grip;
  double farthest = 0.0;
  for (int n = 0; n < 1000; ++n) {
    const Pose hand = at(0.1 * n * kPeriod, 0, 0);  // 0.1 m/s
    grip.advance(hand, {}, kPeriod);
    farthest = std::max(farthest, grip.X_WD.translation().x() - hand.translation().x());
  }
  // damping over stiffness: 16 ms
  EXPECT_NEAR(0.1 * 0.999 - grip.X_WD.translation().x(), 0.1 * 0.016, 0.1 * 2e-3);
  EXPECT_LE(farthest, 1e-4);
}

// a wall of k N/m whose force is held between ticks: twice the damping over the period is the limit
TEST(Grip, AgainstAHeldForceIsStableUpToTheLimitItStatesAndNotBeyond) {
  for (const double k : {1e3, 8e3, 13e3, 25e3}) {
    Grip grip;
    grip.X_WD = at(0, 0, -1e-4);
    double early = 0.0, late = 0.0;
    for (int n = 0; n < 3000; ++n) {
      const Wrench felt{{0, 0, -k * grip.X_WD.translation().z()}, Vec3::Zero()};
      grip.advance(Pose::Identity(), felt, kPeriod);
      const double size = std::abs(grip.X_WD.translation().z());
      if (n < 20) early = std::max(early, size);
      if (n >= 2900) late = std::max(late, size);
    }
    EXPECT_EQ(late < 1e-3 * early, k < 16e3) << k << " N/m";
  }
}

TEST(Hand, AlongARecordedPathPassesThroughItsPosesAndHoldsItsEnds) {
  const Quat q{Eigen::AngleAxisd{1.0, Vec3::UnitZ()}};
  const Hand hand =
      Hand::along({0.5, 1.0, 3.0}, {at(0, 0, 0), at({1, 0, 0}, q), at(1, 2, 0)}).value();
  EXPECT_TRUE(hand.at(0.0).isApprox(at(0, 0, 0)));
  EXPECT_TRUE(hand.at(1.0).isApprox(at({1, 0, 0}, q)));
  EXPECT_TRUE(hand.at(9.0).isApprox(at(1, 2, 0)));
  EXPECT_TRUE(hand.at(2.0).translation().isApprox(Vec3{1, 1, 0}));
  const Eigen::AngleAxisd half{hand.at(0.75).linear()};
  EXPECT_NEAR(half.angle(), 0.5, 1e-12);
}

TEST(Hand, RefusesAPathThatIsNone) {
  EXPECT_FALSE(Hand::along({}, {}));
  EXPECT_FALSE(Hand::along({0.0, 1.0}, {at(0, 0, 0)}));
  EXPECT_FALSE(Hand::along({0.0, 0.0}, {at(0, 0, 0), at(0, 0, 0)}));
  EXPECT_FALSE(Hand::along({1.0, 0.0}, {at(0, 0, 0), at(0, 0, 0)}));
  EXPECT_FALSE(Hand::along({0.0, NAN}, {at(0, 0, 0), at(0, 0, 0)}));
  EXPECT_FALSE(Hand::along({0.0}, {at(NAN, 0, 0)}));
}

TEST(Hand, AimedStartsOutsideReachesTheSurfaceAndGoesAsFarBeyondAsAsked) {
  const auto scene = made::scene(datasets::solid(datasets::centredGrid(48, 1e-3),
                                                 [](const Vec3& p) { return p.norm() - 0.015; }),
                                 made::tool(datasets::ballPoints(100, 3e-3)));
  for (const HandMotion motion :
       {HandMotion::Tap, HandMotion::Slide, HandMotion::Wedge, HandMotion::Pry, HandMotion::Hook,
        HandMotion::Jerk, HandMotion::Twist}) {
    SCOPED_TRACE(int(motion));
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Hand hand = Hand::aimed(motion, *scene, datasets::kSolidIso, 5e-3, seed).value();
      const Hand again = Hand::aimed(motion, *scene, datasets::kSolidIso, 5e-3, seed).value();
      EXPECT_GT(hand.at(0.0).translation().norm(), 0.027);  // clear of the grid's faces, 24 mm
      double deepest = 0.0, jump = 0.0;
      for (int n = 0; n < 4000; ++n) {
        const Pose X = hand.at(n * kPeriod);
        ASSERT_TRUE(X.matrix().allFinite());
        ASSERT_EQ(X.matrix(), again.at(n * kPeriod).matrix());
        ASSERT_LT((X.linear() * X.linear().transpose() - haptics::Mat3::Identity()).norm(), 1e-9);
        deepest = std::max(deepest, 0.018 - X.translation().norm());
        jump = std::max(jump, (hand.at((n + 1) * kPeriod).translation() - X.translation()).norm());
      }
      EXPECT_GT(deepest, 0.001);  // m beyond first touch
      EXPECT_LT(jump, 0.01);      // m a tick: jerk is the fastest, 5 m/s or so
    }
  }
}

TEST(Hand, SaysWhenThereIsNothingToTouch) {
  const auto scene = made::scene(datasets::solid(datasets::centredGrid(24, 1e-3),
                                                 [](const Vec3& p) { return p.norm() - 0.005; }),
                                 made::tool(datasets::ballPoints(10, 1e-3)));
  const auto hand = Hand::aimed(HandMotion::Tap, *scene, 1e6, 5e-3, 1);
  ASSERT_FALSE(hand);
  EXPECT_EQ(hand.error().reason, "nothing-inside");
}

}  // namespace
