// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/simulation/hand.h"
#include "tests/scenario/trial.h"
#include "tests/support/millimetre.h"

// More than a tick can look at: what is proven in one must serve the next, or the proxy stays where
// it is for ever, legal and useless.

namespace {

using datasets::Random;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;
using made::at;
using millimetre::h;

/// What a tick may spend beyond its allowance before it looks at the budget again.
constexpr std::int64_t kOverrun = haptics::kTickWork / 5;

/// A square of points, flat, 20 mm wide.
haptics::Tool plate(int count) {
  return made::tool(datasets::platePoints(int(std::lround(std::sqrt(double(count)))), 0.02));
}

/// A blurred wall with this normal, under noise, whose surface is at 500.
std::shared_ptr<const haptics::Volume> wall(const Vec3& normal, double noise, unsigned seed) {
  auto grain = datasets::grains(seed);
  return made::shared(datasets::sampledFloat(datasets::centredGrid(64, h), [&](const Vec3& p) {
    return 500.0 - 500.0 * std::tanh(normal.dot(p) / (1.2 * h)) + noise * grain();
  }));
}

// straight, the voxels' facets are none; aslant, the proxy of few points lags by 0.045 mm too
TEST(Starving, ManyPointsAllInFlatContactKeepUp) {
  struct Row {
    int count;
    double lag;     // m: in the mean, in a slide at 50 mm/s
    double aslant;  // the same on a wall that cuts the voxels aslant
    int arrives;    // ticks: in which it is where it belongs once the device rests
  };
  for (const auto& [count, lag, aslant, arrives] :
       {Row{10'000, 0.02e-3, 0.065e-3, 3}, Row{100'489, 0.2e-3, 0.2e-3, 10},
        Row{1'000'000, 2e-3, 2e-3, 60}}) {
    if (made::kSanitized && count > 200'000) continue;  // it would take minutes
    for (const bool straight : {true, false}) {
      const Vec3 n = straight ? Vec3{0, 0, 1} : Vec3{0.3, 0.2, 1}.normalized();
      const haptics::Mat3 R = Quat::FromTwoVectors(Vec3::UnitZ(), n).toRotationMatrix();
      const auto scene = haptics::makeScene(wall(n, 0.0, 0), plate(count)).value();
      const auto device = [&](double x, double z) {
        Pose X = Pose::Identity();
        X.linear() = R;
        X.translation() = R * Vec3{x, 0, z};
        return X;
      };
      Trial trial{scene, 500.0, device(-0.006, 2e-3)};
      // the evaluator takes its time over a million points: looked at now and then
      trial.judged = false;
      trial.carry(device(-0.006, 2e-3), device(-0.006, -1e-3), 100);
      trial.hold(device(-0.006, -1e-3), 40);
      double mean = 0.0;
      const int ticks = made::trials(240);
      for (int n_tick = 1; n_tick <= ticks; ++n_tick) {
        const Pose D = device(-0.006 + 50e-6 * n_tick, -1e-3);
        trial.step(D);
        const Vec3 apart = R.transpose() * (trial.place() - D.translation());
        mean += apart.head<2>().norm() / ticks;
        if (n_tick % 80 == 0) {
          EXPECT_TRUE(trial.isLegal());
        }
      }
      const Pose D = device(-0.006 + 50e-6 * ticks, -1e-3);
      int took = 0;
      while (trial.last.cut || took == 0) {
        trial.step(D);
        if (++took == 500) break;
      }
      std::cout << count << " points" << (straight ? "" : ", aslant") << ": " << 1e3 * mean
                << " mm behind, at rest after " << took << " ticks, " << trial.most_work
                << " units at most\n";
      EXPECT_LE(mean, straight ? lag : aslant) << count;
      EXPECT_LE(took, arrives) << count;
      EXPECT_LE(trial.most_work, haptics::kTickWork + kOverrun) << count;
      EXPECT_TRUE(trial.isLegal());
    }
  }
}

// every pose by the evaluator; the surface moves, too
TEST(Starving, DenseToolsNeverEnterRoughWalls) {
  Random random{207};
  for (const bool flat : {true, false}) {
    const Vec3 n = random.direction();
    const auto scene =
        haptics::makeScene(wall(n, 20.0, 208), flat ? plate(5'000) : ballTool(5'000, 8e-3)).value();
    const auto device = [&](double out) {
      Pose X = Pose::Identity();
      const Vec3 aside = random.box(8e-3);
      X.linear() = Quat::FromTwoVectors(Vec3::UnitZ(), n).toRotationMatrix() *
                   Quat{Eigen::AngleAxisd{0.1, random.direction()}}.toRotationMatrix();
      X.translation() = aside - n.dot(aside) * n + (out + (flat ? 0.0 : 8e-3)) * n;
      return X;
    };
    Pose from = device(8e-3);
    Trial trial{scene, 500.0, from};
    const int moves = std::max(made::trials(20), 6);
    for (int k = 0; k < moves; ++k) {
      const Pose to = device(random.in(-3e-3, 0.5e-3));
      trial.carry(from, to, 40);
      // the surface moves away, so the proxy stays outside
      if (k % 5 == 4) trial.isovalue += 20.0;
      from = to;
    }
    EXPECT_EQ(trial.illegal, 0);
    EXPECT_GT(trial.contact, 15 * moves);
  }
}

TEST(Starving, ADrillOfTwoHundredThousandPointsGoesWhereOneOfTwoThousandDoes) {
  datasets::Phantom made = datasets::makePhantom("sphere").value();
  const double isovalue = made.isovalue;
  const auto volume = made::shared(std::move(made.volume));
  const auto mesh = resources::namedToolMesh("drill").value();
  const auto drill = [&](int count) {
    return haptics::makeScene(volume, haptics::makeTool("drill", mesh, count).value()).value();
  };
  const auto few = drill(2'000), many = drill(200'000);
  const haptics::Hand hand =
      haptics::Hand::aimed(haptics::HandMotion::Slide, *few, isovalue, 3e-3, 7).value();
  double coupling[2] = {};
  for (const bool is_many : {false, true}) {
    Trial trial{is_many ? many : few, isovalue, hand.at(0.0)};
    trial.judged = !is_many;
    const int ticks = std::max(made::trials(2000), 1000);  // half of them to get there
    for (int n = 0; n < ticks; ++n) {
      const Pose D = hand.at(1e-3 * n);
      trial.step(D);
      coupling[is_many] += (trial.place() - D.translation()).norm() / ticks;
      if (is_many && n % 250 == 0) {
        EXPECT_TRUE(trial.isLegal());
      }
    }
    EXPECT_EQ(trial.illegal, 0);
    EXPECT_GT(trial.contact, ticks / 3);
    EXPECT_LE(trial.most_work, haptics::kTickWork + kOverrun);
  }
  std::cout << "coupling " << 1e3 * coupling[0] << " mm with 2,000 points, " << 1e3 * coupling[1]
            << " mm with 200,000\n";
  EXPECT_LT(coupling[1], 1.1 * coupling[0] + 0.2e-3);
}

// an isovalue among the specks of the background: nothing can be left out
TEST(Starving, SpecksEverywhereDoNotHoldTheProxy) {
  Random random{205};
  const auto scene = made::scene(datasets::sampledFloat(datasets::centredGrid(48, h),
                                                        [&](const Vec3& p) {
                                                          return p.norm() < 0.012
                                                                     ? random.in(1999.0, 2040.0)
                                                                     : random.in(-1000.0, -950.0);
                                                        }),
                                 ballTool(300, 2e-3));
  double lag[2] = {};
  for (const bool cut : {false, true}) {
    Random hand{206};
    Pose from = at(0, 0, 0.04);
    Trial trial{scene, -950.0, from};
    if (!cut) trial.allowance = 100 * haptics::kTickWork;
    for (int n = 0; n < 12; ++n) {
      const Pose to = at(hand.box(0.014), hand.rotation());
      trial.carry(from, to, 40);
      trial.hold(to, 20);
      lag[cut] += (trial.place() - to.translation()).norm() / 12;
      from = to;
    }
    EXPECT_EQ(trial.illegal, 0);
  }
  std::cout << "among specks: " << 1e3 * lag[0] << " mm behind without a budget, " << 1e3 * lag[1]
            << " mm with it\n";
  EXPECT_LT(lag[1], 1.3 * lag[0] + 1e-3);
}

// rows of four hundred points and their projection take some 3,000 units: cut anywhere in them, the
// next tick goes on, and the plate gets to where one of an ample budget gets
TEST(Starving, ATickTooShortForItsRowsAndTheirProjectionGetsOn) {
  for (const bool noisy : {false, true}) {
    Random grain{207};
    const auto volume =
        made::shared(datasets::sampledFloat(datasets::centredGrid(48, h), [&](const Vec3& p) {
          return 1000.0 - 4e5 * p.z() + (noisy ? grain.in(-40.0, 40.0) : 0.0);
        }));
    const auto scene = haptics::makeScene(volume, plate(400)).value();
    Vec3 rest = Vec3::Zero();
    for (const std::int64_t allowance :
         {haptics::kTickWork, std::int64_t{700}, std::int64_t{100}}) {
      SCOPED_TRACE(std::to_string(allowance) + (noisy ? " in noise" : ""));
      Trial trial{scene, 1000.0, at(-0.002, 0, 3e-3)};
      trial.allowance = allowance;
      trial.carry(at(-0.002, 0, 3e-3), at(-0.002, 0, -1e-3), 60);
      trial.carry(at(-0.002, 0, -1e-3), at(0.002, 0, -1e-3), 200);
      int cut = 0;
      for (int n = 0; n < 3000; ++n) cut += trial.step(at(0.002, 0, -1e-3)).cut;
      EXPECT_EQ(trial.illegal, 0);
      EXPECT_GT(trial.contact, 3000);
      // a projection, or what is done between two looks at the budget
      EXPECT_LE(trial.most_work, allowance + 600);
      if (allowance == haptics::kTickWork) {
        rest = trial.place();
        // at rest it does little else than the projection
        haptics::Budget budget = haptics::Budget::counted(allowance);
        haptics::tick(*scene, 1000.0, trial.coupling, at(0.002, 0, -1e-3), trial.proxy, budget,
                      1e-3);
        EXPECT_GT(budget.counts.pivots, 0);
        EXPECT_GE(budget.spent(), 15 * budget.counts.pivots);
        continue;
      }
      std::cout << allowance << " units: " << cut << " ticks cut at rest, "
                << 1e3 * (trial.place() - rest).norm() << " mm from where it ends otherwise\n";
      // in noise it may find rest in another dent
      EXPECT_LT((trial.place() - rest).norm(), (noisy ? 0.3 : 0.01) * h);
    }
  }
}

}  // namespace
