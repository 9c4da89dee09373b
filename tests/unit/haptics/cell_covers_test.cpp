// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/cell_covers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/collision/clearance.h"
#include "haptics/collision/motion.h"
#include "haptics/collision/sweep.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

namespace {

using datasets::Random;
using haptics::CellCover;
using haptics::CellCovers;
using haptics::Clearance;
using haptics::Isosurface;
using haptics::Pose;
using haptics::ScalarField;
using haptics::ShellTree;
using haptics::Twist;
using haptics::Vec3;
using haptics::Volume;
using millimetre::h;
using Index = std::array<std::int64_t, 3>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A blurred wall through the origin, 1000 inside and 0 outside, under noise.
Volume wall(const Vec3& normal, double noise, unsigned seed) {
  auto grain = datasets::grains(seed);
  return datasets::sampledFloat(datasets::centredGrid(48, h), [&, normal](const Vec3& p) {
    return 500.0 - 500.0 * std::tanh(normal.dot(p) / (1.2 * h)) + noise * grain();
  });
}
/// Nothing but noise.
Volume noise(Random& random) {
  return datasets::sampledFloat(datasets::centredGrid(24, h),
                                [&](const Vec3&) { return random.in(0.0, 1000.0); });
}

/// Looks at many lines through the cell, along which F is linear; how far the cover is above the
/// solid on them [voxels], or infinity.
double slackOf(const Isosurface& solid, const Index& at, const CellCover& cover) {
  const haptics::Cell cell = solid.field.cellAt(at);
  const Vec3 low{double(at[0]), double(at[1]), double(at[2])};
  constexpr int kAcross = 24;
  double highest = -kInfinity;
  for (int axis = 0; axis < 3; ++axis)
    for (int j = 0; j <= kAcross; ++j)
      for (int i = 0; i <= kAcross; ++i) {
        std::array<Vec3, 2> end;
        std::array<double, 2> above;
        for (std::size_t e = 0; e < 2; ++e) {
          end[e] = low;
          end[e][axis] += double(e);
          end[e][(axis + 1) % 3] += double(i) / kAcross;
          end[e][(axis + 2) % 3] += double(j) / kAcross;
          above[e] = cell.value(end[e]) - solid.ceiling();
        }
        for (std::size_t e = 0; e < 2; ++e) {
          if (above[e] < 0.0) continue;
          highest = std::max(highest, cover.normal.dot(end[e]));
          if (above[1 - e] >= 0.0) continue;
          const double share = above[e] / (above[e] - above[1 - e]);
          highest = std::max(highest, cover.normal.dot(end[e] + share * (end[1 - e] - end[e])));
        }
      }
  EXPECT_LE(highest, cover.height + 1e-9);
  return cover.height - highest;
}

TEST(CellCovers, NothingOfTheSolidIsBeyondACover) {
  Random random{401};
  for (const bool rough : {false, true}) {
    const auto volume =
        made::shared(rough ? noise(random) : wall(Vec3{0.3, 0.2, 1.0}.normalized(), 20.0, 402));
    const ScalarField field{volume};
    const Isosurface solid{field, 500.0};
    CellCovers covers{true};
    int covered = 0, empty = 0, none = 0;
    for (int n = 0; n < made::trials(1500); ++n) {
      Index at;
      for (std::size_t axis = 0; axis < 3; ++axis)
        at[axis] = random.below(int(volume->grid.dims[axis]) + 2) - 1;
      if (!rough) at[2] = 18 + random.below(12);
      haptics::Budget budget = millimetre::unlimited();
      const CellCover cover = covers.at(solid, at, budget);
      if (cover.height == kInfinity) {
        ++none;
        continue;
      }
      (cover.height == -kInfinity ? empty : covered) += 1;
      slackOf(solid, at, cover);
    }
    EXPECT_GT(covered, made::trials(300));
    EXPECT_GT(empty, rough ? 0 : made::trials(100));
    EXPECT_LT(none, 10);
  }
}

TEST(CellCovers, OfAWallIsTight) {
  for (const Vec3& normal : {Vec3{0, 0, 1}, Vec3{0.3, 0.2, 1}, Vec3{1, 1, 1}, Vec3{-1, 0.5, 0.1}}) {
    const Vec3 n = normal.normalized();
    const ScalarField field{made::shared(wall(n, 0.0, 0))};
    const Isosurface solid{field, 500.0};
    CellCovers covers{true};
    Random random{403};
    double most = 0.0, mean = 0.0;
    std::int64_t work = 0;
    constexpr int kCells = 200;
    for (int k = 0; k < kCells; ++k) {
      Vec3 p = random.box(0.015);
      p -= n.dot(p) * n;
      const Vec3 u = field.indexOf(p);
      const Index at{std::int64_t(std::floor(u.x())), std::int64_t(std::floor(u.y())),
                     std::int64_t(std::floor(u.z()))};
      haptics::Budget budget = millimetre::unlimited();
      const CellCover cover = covers.at(solid, at, budget);
      work += budget.spent();
      if (cover.height == -kInfinity) continue;
      const double slack = slackOf(solid, at, cover);
      most = std::max(most, slack);
      mean += slack / kCells;
    }
    std::cout << "cover above the solid: " << mean << " voxels in the mean, " << most
              << " at most, " << double(work) / kCells << " units of work\n";
    EXPECT_LT(mean, 2.0 * CellCovers::kTightness);
    EXPECT_LT(most, 4.0 * CellCovers::kTightness);
    EXPECT_LT(work, 400 * kCells);
  }
}

TEST(CellCovers, AreFoundAnewForAnotherIsovalueAndWhenTheyWereDropped) {
  const ScalarField field{made::shared(wall({0, 0, 1}, 0.0, 0))};
  CellCovers covers{true};
  const auto at = [&](double isovalue, const Index& cell) {
    haptics::Budget budget = millimetre::unlimited();
    return covers.at({field, isovalue}, cell, budget).height;
  };
  const Index cell{20, 20, 23};
  const double low = at(500.0, cell);
  EXPECT_EQ(at(500.0, cell), low);
  covers.forget();
  EXPECT_GT(at(400.0, cell), low + 0.05);
  covers.forget();
  EXPECT_EQ(at(500.0, cell), low);
  // more cells than there is room for
  for (std::int64_t k = 10; k < 38; ++k)
    for (std::int64_t j = 0; j < 40; ++j)
      for (std::int64_t i = 0; i < 40; ++i) at(500.0, {i, j, k});
  EXPECT_EQ(at(500.0, cell), low);
}

/// Dense tools at places near a surface, and short motions along it: whatever was not looked at
/// point by point stays free until the sweep's impact.
TEST(CarriedNodes, HoldNoPointThatMeetsTheSurface) {
  Random random{404};
  long carried = 0, looked = 0, met = 0;
  for (int round = 0; round < 4; ++round) {
    const Vec3 n = random.direction();
    const auto volume = made::shared(wall(n, round < 2 ? 0.0 : 30.0, 405 + unsigned(round)));
    const ScalarField field{volume};
    const Isosurface solid{field, 500.0};
    const haptics::Tool tool = made::tool(round % 2 == 0 ? datasets::platePoints(80, 0.01)
                                                         : datasets::ballPoints(6000, 6e-3));
    const ShellTree tree{tool.shell.points};
    const haptics::Tolerances lengths{h};
    Clearance clearance{tree, lengths.band};
    haptics::Sweep sweep{tool.shell.points.size()};
    const haptics::Mat3 facing = haptics::Quat::FromTwoVectors(Vec3::UnitZ(), n).toRotationMatrix();
    Pose X = Pose::Identity();
    for (int k = 0; k < std::max(made::trials(150), 60); ++k) {
      // mostly a step on, sometimes elsewhere
      if (k % 10 == 0) {
        X.linear() = facing * haptics::Quat{Eigen::AngleAxisd{0.02, random.direction()}};
        X.translation() = random.box(2e-3);
        X.translation() -= n.dot(X.translation()) * n;
        X.translation() += (round % 2 == 0 ? 0.0 : 6e-3) * n + random.in(0.05, 0.2) * h * n;
        clearance.forget();
      }
      haptics::Budget budget = millimetre::unlimited();
      if (clearance.collect(solid, tree, X, lengths.band, budget) != Clearance::Verdict::Legal) {
        k += 9 - k % 10;
        continue;
      }
      Twist motion{random.in(0.0, 0.3) * h * random.direction(),
                   random.in(0.0, 0.01) * random.direction()};
      motion.linear -= 0.5 * n.dot(motion.linear) * n;
      const double length = motion.linear.norm() + motion.angular.norm() * tool.shell.radius;
      ASSERT_EQ(clearance.collect(solid, tree, X, length, budget), Clearance::Verdict::Legal);
      clearance.aim();
      ASSERT_EQ(clearance.carry(solid, tree, X, motion, budget), Clearance::Verdict::Legal);
      sweep.begin(field, clearance, X, motion, lengths);
      ASSERT_TRUE(sweep.advance(solid, tree, clearance, lengths, budget));
      met += sweep.time() < 1.0;
      for (std::size_t place = 0; place < tool.shell.points.size(); ++place) {
        if (clearance.holds(place)) {
          ++looked;
          continue;
        }
        carried += clearance.carries(tree, place);
        const haptics::PointPath path{
            X.translation(), X.linear() * Vec3{tree.x[place], tree.y[place], tree.z[place]},
            motion};
        for (const double share : {0.0, 0.5, 1.0})
          ASSERT_LT(evaluator::fieldAt(*volume, path.at(share * sweep.time())), 500.0);
      }
      clearance.moved(motion.linear.norm() * sweep.time(), motion.angular.norm() * sweep.time());
      X = haptics::moved(X, motion, std::max(0.0, sweep.time() - 1e-3));
    }
  }
  std::cout << carried << " points carried, " << looked << " looked at, " << met
            << " motions met the surface\n";
  EXPECT_GT(carried, 2 * looked);
  EXPECT_GT(met, 10);
}

// one corner of a tilted plate, each time another, beyond the band: no point of it is looked at
TEST(CarriedNodes, AreNotCarriedOnASurfaceThatHasRisen) {
  const ScalarField field{made::shared(wall({0, 0, 1}, 0.0, 0))};
  const haptics::Tool tool = made::tool(datasets::platePoints(80, 0.01));
  const ShellTree tree{tool.shell.points};
  const haptics::Tolerances lengths{h};
  for (const Vec3& axis : {Vec3{1, 1, 0}, Vec3{1, -1, 0}, Vec3{-1, 1, 0}, Vec3{-1, -1, 0}}) {
    Clearance clearance{tree, lengths.band};
    const haptics::Quat tilt{Eigen::AngleAxisd{0.06, axis.normalized()}};
    const Pose X = datasets::at(Vec3{0, 0, 0.55 * h}, tilt);
    haptics::Budget budget = millimetre::unlimited();
    ASSERT_EQ(clearance.collect({field, 500.0}, tree, X, h, budget), Clearance::Verdict::Legal);
    // the first search has no crowd before it
    clearance.moved(1e-9, 0.0);
    ASSERT_EQ(clearance.collect({field, 500.0}, tree, X, h, budget), Clearance::Verdict::Legal);
    EXPECT_TRUE(clearance.carriesAny());
    clearance.forget();
    EXPECT_EQ(clearance.collect({field, 400.0}, tree, X, h, budget), Clearance::Verdict::Inside);
  }
}

}  // namespace
