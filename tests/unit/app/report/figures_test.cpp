// SPDX-License-Identifier: BSD-3-Clause
// Every figure of a session against sums by hand.
#include "app/report/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using app::report::Figures;
using app::report::FiguresOf;
using app::report::Tally;
using app::report::Tick;
using haptics::Vec3;

constexpr std::int64_t kMs = 1'000'000;  // ns

Tick tickAt(double ms, const Vec3& tip_W = Vec3::Zero()) {
  Tick tick{.time_ns = std::llround(ms * double(kMs)), .known = true, .scene = 1, .tip_W = tip_W};
  return tick;
}
Tick tickNear(double ms, app::report::TickOf of) {
  Tick tick = tickAt(ms);
  tick.touches = of.touched;
  tick.structures.push(of);
  return tick;
}

Figures figuresOf(const std::vector<Tick>& ticks, std::vector<Tally::Structure> structures = {}) {
  Tally tally{std::move(structures)};
  for (const Tick& tick : ticks) tally.add(tick);
  return tally.figures();
}

TEST(Figures, OfNothingAndOfOneTickAreNone) {
  for (const std::vector<Tick>& ticks : {std::vector<Tick>{}, {tickAt(3.0)}}) {
    const Figures figures = figuresOf(ticks);
    EXPECT_EQ(figures.time, 0.0);
    EXPECT_EQ(figures.path, 0.0);
    EXPECT_TRUE(std::isnan(figures.economy));
    EXPECT_TRUE(std::isnan(figures.mean_force));
    EXPECT_TRUE(std::isnan(figures.contact_share));
    EXPECT_EQ(figures.contacts, 0);
  }
}

TEST(Figures, ThePathIsThatOfPlacesEvery20Ms) {
  // a circle of 10 mm in 2 s, with tremor in every second tick
  std::vector<Tick> ticks;
  for (int n = 0; n <= 2000; ++n) {
    const double turn = 2.0 * M_PI * n / 2000.0;
    ticks.push_back(tickAt(n, {0.01 * std::cos(turn), 0.01 * std::sin(turn), 1e-4 * (n % 2)}));
  }
  const Figures figures = figuresOf(ticks);
  EXPECT_DOUBLE_EQ(figures.time, 2.0);
  EXPECT_NEAR(figures.path, 100 * 2.0 * 0.01 * std::sin(M_PI / 100.0), 1e-12);
  EXPECT_NEAR(figures.economy, 0.0, 1e-12);  // the box has no height
  EXPECT_EQ(figures.idle, 0.0);
}

TEST(Figures, EconomyIsTheBoxOverThePath) {
  // along three edges of a box, and back the same way
  std::vector<Tick> ticks;
  const std::vector<Vec3> corners{{0, 0, 0},          {0.01, 0, 0},    {0.01, 0.02, 0},
                                  {0.01, 0.02, 0.04}, {0.01, 0.02, 0}, {0.01, 0, 0},
                                  {0, 0, 0}};
  for (std::size_t n = 0; n < corners.size(); ++n)
    for (int k = 0; k < 4; ++k) ticks.push_back(tickAt(double(n) * 20.0 + 5.0 * k, corners[n]));
  const Figures figures = figuresOf(ticks);
  EXPECT_NEAR(figures.path, 0.14, 1e-12);
  EXPECT_NEAR(figures.economy, std::cbrt(0.01 * 0.02 * 0.04) / 0.14, 1e-12);
}

TEST(Figures, IdleIsSlowAndFree) {
  std::vector<Tick> ticks;
  double x = 0.0;
  for (int n = 0; n <= 3000; ++n) {
    // a second at 4 mm/s, a second at 6 mm/s, a second at rest but in contact
    ticks.push_back(tickAt(n, {x, 0.0, 0.0}));
    ticks.back().touches = n >= 2000;
    x += n < 1000 ? 4e-6 : n < 2000 ? 6e-6 : 0.0;
  }
  const Figures figures = figuresOf(ticks);
  EXPECT_NEAR(figures.idle, 1.0, 1e-9);
  EXPECT_NEAR(figures.path, 0.010, 1e-9);
  EXPECT_NEAR(figures.contact_time, 1.0, 1e-9);
  EXPECT_NEAR(figures.contact_share, 1.0 / 3.0, 1e-9);
}

TEST(Figures, GapsAndUnknownTicksCountInNothing) {
  std::vector<Tick> ticks;
  for (int n = 0; n <= 100; ++n) ticks.push_back(tickAt(n, {1e-5 * n, 0.0, 0.0}));
  // 400 ms were lost, meanwhile the tool moved by 1 m
  for (int n = 500; n <= 600; ++n) ticks.push_back(tickAt(n, {1.0 + 1e-5 * n, 0.0, 0.0}));
  for (int n = 601; n <= 700; ++n) {
    ticks.push_back(tickAt(n, Vec3::Constant(INFINITY)));
    ticks.back().known = false;
    ticks.back().force = 1e9;
    ticks.back().touches = true;
  }
  for (int n = 701; n <= 800; ++n) ticks.push_back(tickAt(n, {5.0 + 1e-5 * n, 0.0, 0.0}));
  // another tool, the tip of which is elsewhere
  for (int n = 801; n <= 900; ++n) {
    ticks.push_back(tickAt(n, {9.0 + 1e-5 * n, 0.0, 0.0}));
    ticks.back().scene = 2;
  }
  const Figures figures = figuresOf(ticks);
  EXPECT_DOUBLE_EQ(figures.time, 0.9);
  EXPECT_NEAR(figures.unknown, 0.4 + 0.1, 1e-9);
  EXPECT_NEAR(figures.path, 1e-5 * (100 + 100 + 99 + 99), 1e-9);
  EXPECT_EQ(figures.largest_force.value, 0.0);
  EXPECT_EQ(figures.contacts, 0);
  EXPECT_EQ(figures.contact_time, 0.0);
}

TEST(Figures, ForcesAreMeansOverTimeAndLargestOfAll) {
  std::vector<Tick> ticks;
  // in contact for 1 ms at 1 N, for 3 ms at 5 N, and free at 7 N
  const std::vector<std::pair<double, double>> at{{0, 1}, {1, 5}, {4, 7}, {6, 0}};
  for (const auto& [ms, force] : at) {
    ticks.push_back(tickAt(ms));
    ticks.back().force = force;
    ticks.back().touches = ms < 4;
  }
  const Figures figures = figuresOf(ticks);
  EXPECT_NEAR(figures.mean_force, (1.0 * 1.0 + 3.0 * 5.0) / 4.0, 1e-12);
  EXPECT_EQ(figures.largest_force.value, 7.0);
  EXPECT_DOUBLE_EQ(figures.largest_force.at, 0.004);
}

TEST(Figures, StrokesAreCountedAndWhatTheyRemovedIsSummedUp) {
  std::vector<Tick> ticks;
  // two strokes of 100 ms at 2 N and 4 N, the first with a pause of 50 ms, and then nothing
  for (int n = 0; n < 1000; ++n) {
    ticks.push_back(tickAt(n));
    Tick& tick = ticks.back();
    const bool first = n < 150, second = n >= 400 && n < 500;
    tick.cuts = (first && (n < 50 || n >= 100)) || second;
    tick.force = first ? 2.0 : second ? 4.0 : 9.0;
    if (tick.cuts && n % 2 == 0) tick.removed = 1e-11;
  }
  const Figures figures = figuresOf(ticks);
  EXPECT_EQ(figures.strokes, 2);
  EXPECT_NEAR(figures.cut_time, 0.2, 1e-9);
  EXPECT_NEAR(figures.mean_cut_force, 3.0, 1e-9);
  EXPECT_NEAR(figures.removed, 100 * 1e-11, 1e-18);
  EXPECT_TRUE(std::isnan(figuresOf({tickAt(0), tickAt(1)}).mean_cut_force));
}

TEST(Figures, AShortPausePartsNoContacts) {
  std::vector<Tick> ticks;
  for (int n = 0; n < 600; ++n) {
    ticks.push_back(tickAt(n));
    // pauses of 99 and of 100 ms between the ticks in contact
    ticks.back().touches = n <= 50 || (n >= 149 && n <= 200) || n >= 300;
  }
  EXPECT_EQ(figuresOf(ticks).contacts, 2);
}

TEST(Figures, OfAStructure) {
  std::vector<Tick> ticks;
  std::vector<double> within(3, 0.0);
  double touched_s = 0.0, push_s = 0.0, inside_s = 0.0;
  const std::vector<double> margins{0.001, 0.002, 0.005};
  for (int n = 0; n <= 1000; ++n) {
    // from 9 mm down to -1 mm at 500 ms and back; touched from -0.5 mm on
    const auto nearest = float(1e-3 * (-1.0 + 0.02 * std::abs(n - 500)));
    const bool touched = nearest < -0.0005F;
    const double push = touched ? 1.0 + 0.001 * n : 0.0;
    ticks.push_back(tickNear(
        n, {.tip = nearest + 0.0003F, .nearest = nearest, .touched = touched, .push = push}));
    if (n == 1000) break;
    for (std::size_t m = 0; m < 3; ++m) within[m] += double(nearest) <= margins[m] ? 1e-3 : 0.0;
    touched_s += touched ? 1e-3 : 0.0;
    push_s += push * 1e-3;
    inside_s += nearest <= 0.0F ? 1e-3 : 0.0;
  }
  const FiguresOf of = figuresOf(ticks, {{margins, 0.020}}).structures.at(0);
  EXPECT_FLOAT_EQ(float(of.nearest.value), -0.001F);
  EXPECT_DOUBLE_EQ(of.nearest.at, 0.5);
  EXPECT_FLOAT_EQ(float(of.nearest_of_tip.value), -0.0007F);
  ASSERT_EQ(of.within.size(), 3U);
  for (std::size_t m = 0; m < 3; ++m) EXPECT_NEAR(of.within[m], within[m], 1e-9) << m;
  EXPECT_GT(within[0], 0.15);
  EXPECT_GT(within[2], within[1]);
  EXPECT_NEAR(of.touch_time, touched_s, 1e-9);
  EXPECT_NEAR(of.mean_push, push_s / touched_s, 1e-9);
  EXPECT_NEAR(of.largest_push.value, 1.0 + 0.001 * std::round(of.largest_push.at * 1e3), 1e-12);
  EXPECT_GT(of.largest_push.at, 0.51);
  EXPECT_EQ(of.encounter_count, 1);
  EXPECT_NEAR(of.encounter_time, inside_s, 1e-9);
  ASSERT_EQ(of.encounters.size(), 1U);
  EXPECT_NEAR(of.encounters[0].to - of.encounters[0].from, inside_s, 1.1e-3);
  EXPECT_EQ(of.encounters[0].nearest, of.nearest.value);
  EXPECT_EQ(of.encounters[0].push, of.largest_push.value);
}

TEST(Figures, AContactIsAnInjuryWhileTheStructureIsGuarded) {
  std::vector<Tick> ticks;
  for (int n = 0; n <= 100; ++n)
    ticks.push_back(tickNear(n, {.tip = -0.001F,
                                 .nearest = -0.001F,
                                 .touched = true,
                                 .push = n < 60 ? 1.0 : 5.0,
                                 .guarded = n >= 20 && n < 60}));
  const FiguresOf of = figuresOf(ticks, {{{}, 0.020}}).structures.at(0);
  EXPECT_EQ(of.encounter_count, 3);
  EXPECT_EQ(of.injury_count, 1);
  ASSERT_EQ(of.encounters.size(), 3U);
  EXPECT_FALSE(of.encounters[0].guarded);
  EXPECT_TRUE(of.encounters[1].guarded);
  EXPECT_DOUBLE_EQ(of.encounters[1].from, 0.020);
  EXPECT_DOUBLE_EQ(of.encounters[1].to, 0.059);
  EXPECT_EQ(of.encounters[1].push, 1.0);
  EXPECT_FALSE(of.encounters[2].guarded);
}

TEST(Figures, TheNearestThatIsNotToldHasNoTime) {
  std::vector<Tick> ticks;
  for (int n = 0; n < 50; ++n) ticks.push_back(tickNear(n, {.tip = 0.020F, .nearest = 0.020F}));
  const FiguresOf of = figuresOf(ticks, {{{0.001}, 0.020}}).structures.at(0);
  EXPECT_EQ(of.nearest.value, 0.020);
  EXPECT_TRUE(std::isnan(of.nearest.at));
  EXPECT_EQ(of.within[0], 0.0);
}

TEST(Figures, CountMoreEncountersThanTheyKeep) {
  std::vector<Tick> ticks;
  for (int n = 0; n < 1200; ++n) {
    ticks.push_back(tickNear(200.0 * n, {.tip = 1.0F, .nearest = 0.0F, .push = 0.0}));
    ticks.push_back(tickNear(200.0 * n + 1.0, {.tip = 1.0F, .nearest = -1e-3F * float(n)}));
  }
  const FiguresOf of = figuresOf(ticks, {{{}, 0.02}}).structures.at(0);
  EXPECT_EQ(of.encounter_count, 1200);
  ASSERT_EQ(of.encounters.size(), FiguresOf::kMostEncounters);
  EXPECT_FLOAT_EQ(float(of.encounters.back().nearest), -0.999F);
}

}  // namespace
