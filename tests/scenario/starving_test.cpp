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

/// A square of points, flat, 40 mm wide.
haptics::Tool plate(int count) {
  return made::tool(datasets::platePoints(int(std::lround(std::sqrt(double(count)))), 0.04));
}

TEST(Starving, ManyPointsAllInFlatContactKeepUp) {
  const auto volume = made::shared(datasets::sampledFloat(
      datasets::centredGrid(64, h), [](const Vec3& p) { return 1000.0 - 4e6 * p.z(); }));
  struct Row {
    int count;
    double lag;   // m: at most, in a slide at 20 mm/s
    int arrives;  // ticks: in which it is where it belongs once the device rests
  };
  for (const auto& [count, lag, arrives] : {Row{100'489, 2e-3, 100}, Row{1'000'000, 12e-3, 2500}}) {
    const auto scene = haptics::makeScene(volume, plate(count)).value();
    Trial trial{scene, 1000.0, at(-0.006, 0, 2e-3)};
    // the evaluator takes its time over a million points: looked at now and then
    trial.judged = false;
    trial.carry(at(-0.006, 0, 2e-3), at(-0.006, 0, -1e-3), 30);
    double worst = 0.0;
    const int ticks = count < 500'000 ? made::trials(600) : made::trials(300);
    for (int n = 1; n <= ticks; ++n) {
      const double x = -0.006 + 20e-6 * n;
      trial.step(at(x, 0, -1e-3));
      worst = std::max(worst, std::abs(trial.place().x() - x));
      if (n % 100 == 0) {
        EXPECT_TRUE(trial.isLegal());
      }
    }
    const Pose D = at(-0.006 + 20e-6 * ticks, 0, -1e-3);
    const Vec3 rest = D.translation() + Vec3{0, 0, 1e-3 + scene->lengths.rest_gap};
    int took = 0;
    while ((trial.place() - rest).norm() > 0.01 * h && took < 3000) {
      trial.step(D);
      ++took;
    }
    std::cout << count << " points: at most " << 1e3 * worst << " mm behind, at rest after " << took
              << " ticks, " << trial.most_work << " units at most\n";
    EXPECT_LE(worst, lag) << count;
    EXPECT_LE(took, arrives) << count;
    EXPECT_LE(trial.most_work, haptics::kTickWork + kOverrun) << count;
    EXPECT_TRUE(trial.isLegal());
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
