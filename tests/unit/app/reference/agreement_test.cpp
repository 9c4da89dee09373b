// SPDX-License-Identifier: BSD-3-Clause

// Each step of haptics against the same step of the reference, from one state. The two share no
// algorithm: where they agree, both read the paper alike.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "app/study/reference/motion.h"
#include "app/study/reference/tick.h"
#include "haptics/collision/prune.h"
#include "haptics/collision/sweep.h"
#include "haptics/solver/constrained_motion.h"
#include "haptics/solver/unconstrained_motion.h"
#include "tests/unit/app/reference/volumes.h"

namespace {

using haptics::Mat3;
using haptics::PointShell;
using haptics::Pose;
using haptics::Quat;
using haptics::Twist;
using haptics::Vec3;
using reference::Choices;
using reference::Solid;
using reference::Variant;

class Generator {
 public:
  explicit Generator(unsigned seed) : random_{seed} {}
  double number(double size) { return size * std::uniform_real_distribution{-1.0, 1.0}(random_); }
  Vec3 vector(double size) { return {number(size), number(size), number(size)}; }
  Quat rotation() { return {number(1), number(1), number(1), number(1)}; }
  Pose pose(double size) { return haptics::poseOf(vector(size), rotation()); }
  /// On a sphere.
  Vec3 direction() {
    std::normal_distribution<double> normal;
    return Vec3{normal(random_), normal(random_), normal(random_)}.normalized();
  }

 private:
  std::mt19937 random_;
};

/// One volume seen by both.
struct Both {
  std::shared_ptr<const haptics::Volume> volume;
  haptics::ScalarField field;
  Solid solid;
  haptics::Tolerances lengths;
  double isovalue;

  Both(const haptics::Volume& v, double s, Variant variant)
      : volume{std::make_shared<haptics::Volume>(v)},
        field{volume},
        solid{v, s, choices(v, variant)},
        lengths{v.grid.spacing.minCoeff()},
        isovalue{s} {}
  haptics::Isosurface surface() const { return {field, isovalue}; }

  /// The same epsilon for both.
  static Choices choices(const haptics::Volume& v, Variant variant) {
    Choices result = reference::choicesFor(v.grid, variant);
    result.epsilon = haptics::Tolerances{v.grid.spacing.minCoeff()}.epsilon;
    return result;
  }
};

constexpr double kRadius = 12e-3, kBall = 3e-3;  // m

Both sphere(double noise, Variant variant) {
  return {reference_test::sphere(44, 1e-3, kRadius, noise), 0.0, variant};
}

bool legal(const Solid& solid, const PointShell& shell, const Pose& X_WP) {
  return std::none_of(shell.points.begin(), shell.points.end(),
                      [&](const Vec3& r_P) { return solid.inside(X_WP * r_P); });
}

TEST(Agreement, OnTheFieldAndItsCentralGradient) {
  // unequal sides, turned and left-handed axes, and places beyond the rim
  Mat3 direction = Eigen::AngleAxisd{0.7, Vec3{1, 2, 3}.normalized()}.toRotationMatrix();
  direction.col(1) *= -1.0;
  std::mt19937 random{4};
  std::normal_distribution<double> grain{0.0, 100.0};
  const Both both{
      reference_test::sampled(
          12, {1e-3, 1.5e-3, 2.5e-3}, [&](const Vec3&) { return grain(random); }, direction),
      0.0, Variant::Literal};
  Generator make{5};
  for (int trial = 0; trial < 5000; ++trial) {
    const Vec3 p_W = make.vector(14e-3);
    const Vec3 u = both.field.indexOf(p_W);
    EXPECT_NEAR(both.field.value(u), both.solid.value(p_W), 1e-9);
    const Vec3 gradient_W = both.solid.gradient(p_W);
    EXPECT_TRUE(both.field.centralGradient(u).isApprox(gradient_W, 1e-9) ||
                gradient_W.norm() < 1e-6);
  }
}

TEST(Agreement, OnTheUnconstrainedMotion) {
  Generator make{1};
  for (int trial = 0; trial < 2000; ++trial) {
    const Pose X_WP = make.pose(0.1), X_WD = make.pose(0.1);
    const Twist expected = reference::unconstrainedMotion(X_WP, X_WD);
    Vec3 turn = Vec3::Zero();
    const Twist found = haptics::unconstrainedMotion(X_WP, X_WD, turn);
    EXPECT_TRUE(found.linear.isApprox(expected.linear, 1e-12));
    // at half a turn both ways round are as short
    if (expected.angular.norm() > M_PI - 1e-6) continue;
    EXPECT_LT((found.angular - expected.angular).norm(), 1e-10);
  }
}

TEST(Agreement, OnTheVerdictOfPruning) {
  const Both both = sphere(0.02, Variant::Literal);
  const PointShell shell = reference_test::ball(60, kBall);
  Generator make{2};
  int kept = 0, dropped = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    SCOPED_TRACE(trial);
    // a point of the ball within epsilon of the surface
    const int point = trial % 60;
    const Quat rotation = make.rotation().normalized();
    const Vec3 r_W = rotation * shell.points[point];
    const Vec3 out = make.direction();
    Vec3 p_W = out * (kRadius + 1e-3);
    for (int step = 0; step < 40; ++step)
      p_W += out * std::clamp(-both.solid.gap(p_W), -5e-4, 5e-4);
    p_W += out * both.lengths.epsilon * make.number(1.0);
    const Pose X_WP = haptics::poseOf(p_W - r_W, rotation);

    Twist motion{make.vector(1e-3), make.vector(0.3)};
    if (trial % 3 == 0) motion.angular.setZero();
    if (trial % 3 == 1) motion.linear.setZero();
    const std::vector<reference::Contact> contacts = {
        reference::contactOf(both.solid, shell, X_WP, point)};
    const bool expected = !reference::prune(both.solid, shell, contacts, X_WP, motion).empty();
    // a slower reading of "moved a distance epsilon" must not be what decides
    bool doubtful = false;
    const haptics::PointPath path{X_WP.translation(), r_W, motion};
    const double epsilon = both.lengths.epsilon;
    const double least = std::min(1.0, epsilon / path.speed());
    const double most = std::min(1.0, epsilon / (motion.linear + motion.angular.cross(r_W)).norm());
    for (int step = 0; step <= 20; ++step) {
      const Vec3 q_W =
          reference::moved(X_WP, motion, least + (most - least) * step / 20) * shell.points[point];
      doubtful |= both.solid.inside(q_W) != expected;
    }
    if (doubtful) continue;
    EXPECT_EQ(haptics::standsInTheWay(both.surface(), X_WP.translation(), r_W, motion, epsilon),
              expected);
    ++(expected ? kept : dropped);
  }
  EXPECT_GT(kept, 800);
  EXPECT_GT(dropped, 800);
}

TEST(Agreement, OnTheProjectionWithEqualRows) {
  Generator make{3};
  int slowed = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    SCOPED_TRACE(trial);
    const Quat rotation = make.rotation();
    const Pose X_WP = haptics::poseOf(Vec3::Zero(), rotation);
    Mat3 root;
    root << make.vector(0.02), make.vector(0.02), make.vector(0.02);
    const Mat3 inertia_P = root * root.transpose() + 1e-6 * Mat3::Identity();

    // the paper's cone, or with gaps of either sign that one motion, `way`, leaves room for
    std::vector<reference::Row> rows;
    std::vector<haptics::MotionRow> same;
    const Vec3 up = make.direction();
    for (int i = 0; i < 1 + trial % 20; ++i) {
      const Vec3 n_W = Vec3{make.vector(1.2) + 1.3 * up}.normalized(), r_W = make.vector(0.05);
      const double room = trial % 2 == 0 ? 0.0 : 1e-5 * (0.5 + make.number(1.0));
      rows.push_back({.n_W = n_W, .r_W = r_W, .bias = -room});
      same.push_back({n_W, r_W, room});
    }
    const Twist free{make.vector(0.01) - 0.01 * up, make.vector(0.3)};
    const reference::MassMetric M = reference::massMetric(X_WP, inertia_P);
    const Twist expected = reference::constrainedMotion(free, rows, M);
    const auto found =
        haptics::constrainedMotion(free, same, haptics::MassMetric{inertia_P}, X_WP.linear());
    if (found.status != haptics::ConstrainedMotion::Status::Exact) continue;
    const Twist difference{found.twist.linear - expected.linear,
                           found.twist.angular - expected.angular};
    EXPECT_LE(std::sqrt(M.inner(difference, difference)), 1e-10 * std::sqrt(M.inner(free, free)));
    const Twist lost{expected.linear - free.linear, expected.angular - free.angular};
    slowed += M.inner(lost, lost) > 1e-6 * M.inner(free, free);
  }
  EXPECT_GT(slowed, 1000);
}

/// A legal start beside the sphere and a motion of some voxels with a turn.
struct Arc {
  Pose X_WP;
  Twist motion;
};
Arc arcTowardsSphere(Generator& make) {
  const Vec3 out = make.direction();
  return {haptics::poseOf(out * (kRadius + kBall + 2e-3), make.rotation()),
          {.linear = -6e-3 * out + make.vector(3e-3), .angular = make.vector(0.5)}};
}

/// haptics' sweep of the whole shell along an arc.
haptics::Impact swept(const Both& both, const PointShell& shell, const Arc& arc) {
  haptics::Budget budget = haptics::Budget::counted(1'000'000'000);
  const haptics::ShellTree tree{shell.points};
  haptics::Clearance clearance{tree};
  const double reach = reference::pathBound(arc.motion, shell.radius) * 1.001;
  EXPECT_EQ(clearance.collect(both.surface(), tree, arc.X_WP, reach, budget),
            haptics::Clearance::Verdict::Legal);
  haptics::Sweep sweep{shell.points.size()};
  sweep.begin(both.field, clearance, arc.X_WP, arc.motion, both.lengths);
  EXPECT_TRUE(sweep.advance(both.surface(), tree, clearance, both.lengths, budget));
  return sweep.impact(both.surface(), tree, both.lengths, budget);
}

TEST(Agreement, OnTheFirstHitOfAnArc) {
  const Both both = sphere(0.0, Variant::AcceptInside);
  const Both outside = sphere(0.0, Variant::Literal);
  const PointShell shell = reference_test::ball(120, kBall);
  Generator make{6};
  int hits = 0;
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE(trial);
    const Arc arc = arcTowardsSphere(make);
    ASSERT_TRUE(legal(both.solid, shell, arc.X_WP));
    const haptics::Impact impact = swept(both, shell, arc);
    const auto late = reference::firstHit(both.solid, shell, arc.X_WP, arc.motion);
    if (!late.met) continue;
    ++hits;
    const auto early = reference::firstHit(outside.solid, shell, arc.X_WP, arc.motion);
    EXPECT_TRUE(impact.met);
    // never later than the inside end, and not before the outside end by more than epsilon
    EXPECT_LE(impact.time, late.t);
    const double length = reference::pathBound(arc.motion, shell.radius);
    EXPECT_GE(impact.time, early.t - both.solid.choices().epsilon / length);
  }
  EXPECT_GT(hits, 200);
}

TEST(Agreement, InNoiseTheSweepIsNeverLaterAndNeverInside) {
  const Both both = sphere(0.15, Variant::AcceptInside);
  const PointShell shell = reference_test::ball(120, kBall);
  Generator make{8};
  int hits = 0, earlier = 0;
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE(trial);
    const Arc arc = arcTowardsSphere(make);
    if (!legal(both.solid, shell, arc.X_WP)) continue;
    const haptics::Impact impact = swept(both, shell, arc);
    const auto late = reference::firstHit(both.solid, shell, arc.X_WP, arc.motion);
    EXPECT_LE(impact.time, late.t);
    hits += late.met;
    earlier += impact.time < late.t - 0.05;  // a feature that half a voxel steps over
    for (int step = 0; step <= 50; ++step)
      EXPECT_TRUE(legal(both.solid, shell,
                        reference::moved(arc.X_WP, arc.motion, impact.time * 0.999 * step / 50)));
  }
  EXPECT_GT(hits, 150);
  std::printf("%d hits; in %d the half-voxel steps of the reference went through something\n", hits,
              earlier);
}

}  // namespace
