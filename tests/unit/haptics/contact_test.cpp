// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/collision/clearance.h"
#include "haptics/collision/motion.h"
#include "haptics/collision/prune.h"
#include "haptics/solver/unconstrained_motion.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

namespace {

using datasets::Random;
using haptics::Budget;
using haptics::Clearance;
using haptics::Contact;
using haptics::Contacts;
using haptics::Isosurface;
using haptics::PointPath;
using haptics::Pose;
using haptics::Quat;
using haptics::ScalarField;
using haptics::Tolerances;
using haptics::Twist;
using haptics::Vec3;
using made::at;
using millimetre::h;
using millimetre::unlimited;

constexpr double kPi = M_PI;

TEST(PointPath, IsTheLineOfTheOriginAndTheTurnAboutIt) {
  Random random{41};
  for (int n = 0; n < 500; ++n) {
    const Pose X = at(random.box(0.1), random.rotation());
    const Vec3 p = random.box(0.05);
    const Twist V{random.box(0.02), random.in(0.0, 3.0) * random.direction()};
    const PointPath path{X.translation(), X.linear() * p, V};
    const double t = random.in(0.0, 1.0);
    EXPECT_LT((path.at(t) - haptics::moved(X, V, t) * p).norm(), 1e-15);  // m, rounding
    // the closed form, with the matrix exponential of Eigen's angle-axis
    Vec3 expected = X.translation() + t * V.linear;
    expected += Eigen::AngleAxisd{t * V.angular.norm(), V.angular.normalized()} * (X.linear() * p);
    EXPECT_LT((path.at(t) - expected).norm(), 1e-15);
  }
}

TEST(PointPath, NeverOutrunsItsSpeedNorLeavesItsSagitta) {
  Random random{42};
  for (int n = 0; n < 500; ++n) {
    const Vec3 r = random.box(0.05), turn = random.in(0.0, 3.0) * random.direction();
    const PointPath path{random.box(0.1), r, {random.box(0.02), turn}};
    const double a = random.in(0.0, 0.8), dt = random.in(0.0, 0.2), b = a + dt;
    EXPECT_LE((path.at(b) - path.at(a)).norm(), path.speed() * dt * (1 + 1e-12));
    const double bulge = haptics::sagitta(r.norm(), turn.norm() * dt);
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vec3 chord = path.at(a) + share * (path.at(b) - path.at(a));
      EXPECT_LE((path.at(a + share * dt) - chord).norm(), bulge * (1 + 1e-9) + 1e-16);
    }
  }
}

TEST(Moved, StaysARotationAfterAMillionSteps) {
  Random random{43};
  Pose X = at(Vec3::Zero(), random.rotation());
  for (int n = 0; n < made::trials(1'000'000); ++n)
    X = haptics::moved(X, {Vec3::Zero(), random.box(0.3)}, 1.0);
  EXPECT_LT((X.linear() * X.linear().transpose() - haptics::Mat3::Identity()).norm(), 1e-14);
}

TEST(UnconstrainedMotion, TakesTheProxyToTheDevice) {
  Random random{44};
  for (int n = 0; n < 1000; ++n) {
    const Pose P = at(random.box(0.1), random.rotation()),
               D = at(random.box(0.1), random.rotation());
    Vec3 turn = Vec3::Zero();
    const Twist V = haptics::unconstrainedMotion(P, D, turn);
    EXPECT_LT((haptics::moved(P, V, 1.0).matrix() - D.matrix()).norm(), 1e-14);
    EXPECT_LE(V.angular.norm(), kPi + 1e-12);
    EXPECT_EQ(turn, V.angular);
  }
}

// three whole turns about a slanted axis, and back
TEST(UnwrappedTurn, FollowsTheDeviceThroughPiAndBeyond) {
  Random random{45};
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 axis = random.direction();
    const Pose P = at(Vec3::Zero(), random.rotation());
    Vec3 turn = Vec3::Zero();
    for (int degree = 0; degree <= 2 * 1080; ++degree) {
      const double angle = (degree <= 1080 ? degree : 2160 - degree) * kPi / 180.0;
      const Pose D = at(Vec3::Zero(), Quat{Eigen::AngleAxisd{angle, axis}} * Quat{P.linear()});
      turn = haptics::unwrappedTurn(P, D, turn);
      // rounding of the angle, and of the axis where a whole turn is a degree away
      ASSERT_LT((turn - angle * axis).norm(), 1e-12) << degree << " degrees";
    }
  }
}

/// A half-space z <= 0 whose field falls by 4,000 a voxel.
struct HalfSpace {
  ScalarField field{made::shared(datasets::sampledFloat(
      datasets::centredGrid(40, h), [](const Vec3& p) { return 1000.0 - 4e6 * p.z(); }))};
  Isosurface solid{field, 1000.0};
};

TEST(Prune, KeepsWhatTheMotionPressesOnAndItsNormal) {
  const HalfSpace space;
  const double epsilon = 0.05 * h;
  const auto stands = [&](double gap, const Vec3& way) {
    return haptics::standsInTheWay(space.solid, {0, 0, gap}, Vec3::Zero(), {way, Vec3::Zero()},
                                   epsilon);
  };
  EXPECT_TRUE(stands(0.5 * epsilon, {0, 0, -1e-3}));
  EXPECT_FALSE(stands(1.5 * epsilon, {0, 0, -1e-3}));
  EXPECT_FALSE(stands(0.5 * epsilon, {0, 0, 1e-3}));
  EXPECT_FALSE(stands(0.5 * epsilon, {1e-3, 0, 0}));
  EXPECT_FALSE(stands(0.5 * epsilon, Vec3::Zero()));
  EXPECT_FALSE(stands(0.5 * epsilon, {0, 0, -0.4 * epsilon}));  // the device itself is outside
}

TEST(Prune, DropsContactsThatWereLeftOrHaveMovedAwayAndKeepsTheGapsOfTheOthers) {
  const HalfSpace space;
  const double epsilon = 0.05 * h;
  const haptics::PointShell shell = haptics::makeShell({{5e-3, 0, 0}, {-5e-3, 0, 0}}).value();
  const Pose X = at(0, 0, 0.4 * epsilon);
  const Vec3 n = Vec3{0.1, 0, 1}.normalized();  // a normal of its own: it is to be kept
  const auto contact = [&](int point, const Vec3& met_at) {
    return Contact{point, Vec3::Zero(), n, 0.0, met_at, 0.3 * epsilon};
  };
  Contacts contacts;
  contacts.push(contact(0, Vec3{5e-3, 0, 0.8 * epsilon}));       // 0.4 epsilon further up
  contacts.push(contact(1, Vec3{-5e-3 + 2.0 * epsilon, 0, 0}));  // two epsilon aside
  Budget budget = unlimited();
  haptics::prune(space.solid, shell, X, {{0, 0, -1e-3}, Vec3::Zero()}, Tolerances{h}, contacts,
                 budget);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].point, 0);
  EXPECT_EQ(contacts[0].n_W, n);
  EXPECT_NEAR(contacts[0].gap, 0.3 * epsilon - 0.4 * epsilon * n.z(), 1e-12);
  EXPECT_TRUE(contacts[0].r_W.isApprox(Vec3{5e-3, 0, 0}, 1e-12));
  // a turn that lifts this point and presses the other lets go of it
  haptics::prune(space.solid, shell, X, {Vec3::Zero(), {0, -0.5, 0}}, Tolerances{h}, contacts,
                 budget);
  EXPECT_TRUE(contacts.empty());
}

// a plane that is kept while the tool slides off it, a little in each tick, carries it in mid air
TEST(Prune, LetsGoOfAContactThatCreepsAway) {
  const HalfSpace space;
  const Tolerances lengths{h};
  const haptics::PointShell shell = haptics::makeShell({{0, 0, 0}}).value();
  const Vec3 met{0, 0, 0.2 * lengths.rest_gap};
  Contacts contacts;
  contacts.push({0, Vec3::Zero(), Vec3::UnitZ(), 0.0, met, 0.2 * lengths.rest_gap});
  double crept = 0.0;
  for (; crept < 3.0 * lengths.rest_gap && !contacts.empty(); crept += 0.1 * lengths.rest_gap) {
    Budget budget = unlimited();
    haptics::prune(space.solid, shell, at(met.x() + crept, 0, met.z()),
                   {{1e-4, 0, -1e-3}, Vec3::Zero()}, lengths, contacts, budget);
  }
  EXPECT_NEAR(crept, 1.1 * lengths.rest_gap, 0.11 * lengths.rest_gap);
}

TEST(Clearance, ProvesHowFarEveryPointItLeavesOutMayGo) {
  Random random{46};
  const auto volume = made::shared(datasets::whiteNoise(datasets::centredGrid(40, h), 47));
  const ScalarField field{volume};
  const Isosurface solid{field, 220.0};
  const haptics::PointShell shell = haptics::makeShell(datasets::ballPoints(300, 9e-3)).value();
  const haptics::ShellTree tree{shell.points};
  Clearance clearance{tree};
  Pose X = at(0.028, 0, 0);
  int left_out = 0, looked_at = 0, legal = 0, inside = 0;
  for (int n = 0; n < 400; ++n) {
    const double reach = random.in(0.05, 0.6) * h;
    Budget budget = unlimited();
    const auto verdict = clearance.collect(solid, tree, X, reach, budget);
    ASSERT_NE(verdict, Clearance::Verdict::Cut);
    bool truly_inside = false;
    for (const Vec3& p : shell.points)
      truly_inside = truly_inside || evaluator::fieldAt(*volume, X * p) >= solid.ceiling();
    EXPECT_EQ(verdict == Clearance::Verdict::Inside, truly_inside);
    ++(truly_inside ? inside : legal);
    std::vector<bool> near(shell.points.size(), false);
    for (std::size_t i = 0; i < clearance.size(); ++i) {
      const haptics::NearPoint& point = clearance.near(i);
      const auto p = static_cast<std::size_t>(tree.index[static_cast<std::size_t>(point.place)]);
      near[p] = true;
      const Vec3 p_W = X * shell.points[p];
      EXPECT_NEAR(point.value, evaluator::fieldAt(*volume, p_W), field.roundingMargin());
      EXPECT_LT(point.free, reach);
    }
    for (std::size_t i = 0; i < shell.points.size() && !truly_inside; ++i) {
      if (near[i]) {
        ++looked_at;
        continue;
      }
      ++left_out;
      for (int sample = 0; sample < 4; ++sample)
        ASSERT_LT(evaluator::fieldAt(*volume, X * shell.points[i] + reach * random.direction()),
                  solid.isovalue);
    }
    // the budget carries over: motion spends it, jumps forget it
    if (n % 10 == 9) {
      X = at(random.box(0.028), random.rotation());
      clearance.forget();
    } else {
      const Twist step{0.3e-3 * random.direction(), 0.02 * random.direction()};
      X = haptics::moved(X, step, 1.0);
      clearance.moved(step.linear.norm(), step.angular.norm());
    }
  }
  EXPECT_GT(left_out, 10'000);
  EXPECT_GT(looked_at, 1'000);
  EXPECT_GT(legal, made::trials(10));
  EXPECT_GT(inside, made::trials(10));
}

// above a plane the bounds are tight: what motion spends must be spent in full
TEST(Clearance, SpendsAllOfAMotionOverAPlane) {
  const HalfSpace space;
  const haptics::PointShell shell = haptics::makeShell(datasets::ballPoints(60, 4e-3)).value();
  for (const bool turning : {false, true}) {
    Random random{48};
    const haptics::ShellTree tree{shell.points};
    Clearance clearance{tree};
    Pose X = at(0, 0, 11e-3);
    int met = 0, skipped = 0;
    for (int n = 0; n < 200 && met < 20; ++n) {
      const double reach = random.in(0.02, 0.2) * h;
      Budget budget = unlimited();
      ASSERT_EQ(clearance.collect(space.solid, tree, X, reach, budget), Clearance::Verdict::Legal);
      skipped += budget.spent() < 60;
      std::vector<bool> near(shell.points.size(), false);
      for (std::size_t i = 0; i < clearance.size(); ++i)
        near[static_cast<std::size_t>(
            tree.index[static_cast<std::size_t>(clearance.near(i).place)])] = true;
      for (std::size_t i = 0; i < shell.points.size(); ++i) {
        const double height = (X * shell.points[i]).z();
        met += height < reach;
        if (height < reach) {
          ASSERT_TRUE(near[i]) << "at " << height << " m, within " << reach;
        }
      }
      // down to where the lowest points are in reach; turning, each comes down in its turn
      const double fall = std::min(0.1 * h, X.translation().z() - 4.02e-3);
      const Twist step{{0, 0, -fall}, {turning ? 0.03 : 0.0, 0, 0}};
      X = haptics::moved(X, step, 1.0);
      clearance.moved(step.linear.norm(), step.angular.norm());
    }
    EXPECT_GT(met, 0);
    EXPECT_GT(skipped, 20);
  }
}

TEST(Clearance, LooksAtNothingTwiceThatCannotHaveComeNear) {
  const HalfSpace space;
  const haptics::PointShell shell = haptics::makeShell(datasets::ballPoints(100, 2e-3)).value();
  const haptics::ShellTree tree{shell.points};
  Clearance clearance{tree};
  Budget first = unlimited(), second = unlimited();
  const Pose X = at(0, 0, 3e-3);  // within four voxels: nothing is proven by a block alone
  clearance.collect(space.solid, tree, X, 1e-4, first);
  clearance.collect(space.solid, tree, X, 1e-4, second);
  EXPECT_GE(first.spent(), 100);
  EXPECT_EQ(second.spent(), 0);
}

TEST(Clearance, SaysWhenTheBudgetRanOutAndGoesOnFromThere) {
  const HalfSpace space;
  const haptics::PointShell shell = haptics::makeShell(datasets::ballPoints(100, 2e-3)).value();
  const haptics::ShellTree tree{shell.points};
  Clearance clearance{tree};
  const Pose X = at(0, 0, 3e-3);  // within four voxels: nothing is proven by a block alone
  int ticks = 0;
  for (;; ++ticks) {
    Budget little = Budget::counted(20);
    if (clearance.collect(space.solid, tree, X, 1e-4, little) != Clearance::Verdict::Cut) break;
    ASSERT_LT(ticks, 50);
  }
  EXPECT_GE(ticks, 4);
}

// no slope there to go by, and yet as inside as can be
TEST(Clearance, FindsAToolInsideAPlateauInside) {
  const auto volume =
      made::shared(datasets::filled(datasets::centredGrid(48, h), haptics::ScalarType::UInt8,
                                    [](auto, auto, auto k) { return k < 36 ? 255. : 0.; }));
  const ScalarField field{volume};
  const haptics::PointShell shell = haptics::makeShell(datasets::ballPoints(50, 1e-3)).value();
  const haptics::ShellTree tree{shell.points};
  Clearance clearance{tree};
  Budget budget = unlimited();
  EXPECT_EQ(clearance.collect({field, 100.0}, tree, at(0, 0, -8e-3), 1e-4, budget),
            Clearance::Verdict::Inside);
}

}  // namespace
