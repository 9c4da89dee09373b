// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "datasets/edits/edit_history.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/scenario/trial.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

// How the wall of a cut feels: like the plane that it stands for.

namespace {

using datasets::LassoCut;
using datasets::Random;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;
using haptics::Volume;
using made::at;
using millimetre::h;

constexpr double kBone = 300.0;  // isovalue
constexpr double kAir = -1024.0, kDense = 1200.0, kGrain = 60.0;

/// A lasso from a camera that looks aslant: one edge passes through the origin.
struct SlantedCut {
  explicit SlantedCut(Random& random) {
    const Quat turn = random.rotation();
    const double off = random.in(-0.1, 0.1), distance = 0.15;
    // the origin lies on the edge, as it is seen
    cut.X_WC = haptics::poseOf(turn * Vec3{-off * distance, 0.0, distance}, turn);
    cut.outline = {{off, -1.0}, {3.0, -1.0}, {3.0, 1.0}, {off, 1.0}};
    cut.isovalue = kBone;
    out_W = turn * Vec3{1.0, 0.0, off}.normalized();
    along_W = turn * Vec3::UnitY();
    across_W = out_W.cross(along_W);
  }
  LassoCut cut;
  Vec3 out_W, along_W, across_W;  ///< of its wall, right-handed
};

/// Dense matter with grain that fills its grid, and one voxel of air.
std::shared_ptr<const Volume> grainySolid(Random& random) {
  return made::shared(datasets::filled(
      datasets::centredGrid(64, h), haptics::ScalarType::Int16,
      [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return i + j + k == 0 ? kAir : kDense + random.in(-kGrain, kGrain) * std::sqrt(3.0);
      }));
}

/// The same wall by its formula, without rounding.
std::shared_ptr<const Volume> formulaPlane(const Vec3& out_W) {
  return made::shared(datasets::sampledFloat(datasets::centredGrid(64, h), [&](const Vec3& p) {
    return std::clamp(kBone - (kBone - kAir) / 3.0 * out_W.dot(p) / h, kAir, kDense);
  }));
}

struct SlideFeel {
  double step = 0.0;     ///< N: the largest between ticks
  double deepest = 0.0;  ///< mm inside, by the evaluator
  double aside = 0.0;    ///< N: the largest force along the wall
  double lag = 0.0;      ///< m: the farthest along the wall from the device
  double weakest = 1e9;  ///< N along the normal
  double turned = 0.0;   ///< degrees of the force from the normal, the most
  int frozen = 0;        ///< ticks in which the device went along the wall and the proxy did not
  int illegal = 0, ticks = 0;
};

/// A ball is pressed 2 mm into the wall and slides along it.
SlideFeel slideOver(const std::shared_ptr<const Volume>& volume, const SlantedCut& slanted,
                    double speed) {
  const double radius = 3e-3;
  const auto scene = haptics::makeScene(volume, ballTool(400, radius)).value();
  const double step = speed * 1e-3;  // m a tick
  const auto device = [&](int n) {
    const double way = n * step / 0.012;
    return at(slanted.out_W * (radius - 2e-3) + 0.012 * std::sin(way) * slanted.along_W +
              0.009 * std::sin(1.7 * way) * slanted.across_W);
  };
  const Pose above = at(slanted.out_W * (radius + 2e-3));
  Trial trial{scene, kBone, above};
  trial.carry(above, device(0), 50);
  trial.hold(device(0), 50);
  SlideFeel feel;
  Vec3 last = trial.last.wrench_W.force, place = trial.place();
  for (int n = 1; n <= made::trials(1500); ++n) {
    const Pose D = device(n);
    trial.step(D);
    const Vec3 force = trial.last.wrench_W.force;
    const double normal = force.dot(slanted.out_W);
    feel.step = std::max(feel.step, (force - last).norm());
    feel.aside = std::max(feel.aside, (force - normal * slanted.out_W).norm());
    feel.weakest = std::min(feel.weakest, normal);
    feel.turned =
        std::max(feel.turned, std::acos(std::min(1.0, normal / force.norm())) * 180.0 / M_PI);
    feel.deepest = std::max(feel.deepest, trial.penetration_mm());
    const Vec3 behind = trial.place() - D.translation();
    feel.lag = std::max(feel.lag, (behind - slanted.out_W * slanted.out_W.dot(behind)).norm());
    feel.frozen += (trial.place() - place).norm() <
                   0.5 * (D.translation() - device(n - 1).translation()).norm();
    last = force;
    place = trial.place();
    ++feel.ticks;
  }
  feel.illegal = trial.illegal;
  return feel;
}

TEST(CutWall, IsFeltAsThePlaneThatItStandsFor) {
  Random random{271};
  for (const double speed : {0.01, 0.1})
    for (int n = 0; n < 3; ++n) {
      const SlantedCut slanted{random};
      const std::vector<datasets::Edit> edits{slanted.cut};
      const auto wall = datasets::edited(grainySolid(random), edits);
      ASSERT_TRUE(wall);
      const SlideFeel cut = slideOver(*wall, slanted, speed);
      const SlideFeel plane = slideOver(formulaPlane(slanted.out_W), slanted, speed);
      std::cout << 1e3 * speed << " mm/s: force step " << cut.step << " N (plane " << plane.step
                << "), aside " << cut.aside << " N (" << plane.aside << "), lag " << 1e3 * cut.lag
                << " mm (" << 1e3 * plane.lag << "), turned " << cut.turned << " degrees ("
                << plane.turned << ")\n";
      EXPECT_EQ(cut.illegal, 0);
      EXPECT_EQ(cut.deepest, 0.0);
      EXPECT_EQ(cut.frozen, 0);
      EXPECT_EQ(plane.frozen, 0);
      EXPECT_GT(cut.weakest, 1.8);              // N: 1000 N/m · 2 mm, less the ball's bulge
      EXPECT_LE(cut.step, plane.step + 0.005);  // N
      EXPECT_LE(cut.aside, plane.aside + 0.02);
    }
}

}  // namespace
