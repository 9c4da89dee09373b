// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "app/study/made/made.h"
#include "haptics/core/budget.h"
#include "haptics/core/fixed_vector.h"
#include "haptics/servo/acceptance.h"
#include "haptics/servo/tick_stats.h"

namespace {

using haptics::Acceptance;
using haptics::Budget;
using haptics::FixedVector;
using haptics::Pose;
using haptics::Quat;
using haptics::TickStats;
using made::at;
using made::Random;

constexpr double kRadius = 0.01, kStill = 1e-6, kResolution = 1e-9;  // m

/// A filter that has just begun at the device pose of the origin, from a pose 10 mm away.
Acceptance begun() {
  Acceptance filter;
  filter.begin(Pose::Identity(), kRadius, kStill);
  filter.start(10e-3, 1e-3);
  return filter;
}

TEST(Acceptance, TakesANearerPoseOrAShorterStepButNotOneThatIsAsGoodInNeither) {
  Acceptance filter = begun();
  EXPECT_TRUE(filter.take(9e-3, 2e-3, kResolution));     // nearer
  EXPECT_TRUE(filter.take(11e-3, 0.5e-3, kResolution));  // less to do
  EXPECT_FALSE(filter.take(11e-3, 1e-3, kResolution));  // worse than the start in one, equal in one
  EXPECT_FALSE(filter.take(9e-3, 2e-3, kResolution));   // seen already
  EXPECT_FALSE(filter.take(9e-3 - 0.5e-9, 2e-3, kResolution));  // and no different
  EXPECT_TRUE(filter.take(0.0, 0.0, kResolution));
}

// a dominated pose is never taken, however the poses come, and detours come to an end
TEST(Acceptance, NeverTakesWhatAnEarlierPoseDominatesAndEndsItsDetours) {
  Random random{61};
  int refused = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Acceptance filter = begun();
    std::vector<std::pair<double, double>> taken{{10e-3, 1e-3}};
    int detours = 0;
    double nearest = 10e-3;
    for (int n = 0; n < 300; ++n) {
      const double distance = random.in(1e-3, 12e-3), step = random.in(0.0, 2e-3);
      const bool took = filter.take(distance, step, kResolution);
      for (const auto& [d, s] : taken)
        if (distance >= d && step >= s) {
          ASSERT_FALSE(took);
        }
      refused += !took;
      if (!took) continue;
      taken.emplace_back(distance, step);
      detours += distance >= nearest;
      nearest = std::min(nearest, distance);
    }
    EXPECT_LE(detours, 12);
    EXPECT_GT(taken.size(), 3u);
  }
  EXPECT_GT(refused, 1000);
}

// what was visited is known by its distance to the device: no motion is too small to void that
TEST(Acceptance, ForgetsPosesWhenTheDeviceMovesAtAllAndNotWhileItRests) {
  Acceptance filter = begun();
  filter.begin(Pose::Identity(), kRadius, kStill);
  filter.start(10e-3, 1e-3);
  EXPECT_FALSE(filter.take(10e-3, 1e-3, kResolution));
  filter.begin(at(1e-12, 0, 0), kRadius, kStill);
  filter.start(10.1e-3, 2e-3);
  EXPECT_TRUE(filter.take(10e-3, 1e-3, kResolution));
}

int detours(Acceptance& filter) {
  int taken = 0;
  for (int n = 1; n <= 40; ++n)
    taken += filter.take(10e-3 + n * 1e-6, 1e-3 - n * 1e-6, kResolution);
  return taken;
}

TEST(Acceptance, GivesNewDetoursOnlyOnceTheDeviceHasMovedByMoreThanItMayTremble) {
  Acceptance filter = begun();
  EXPECT_EQ(detours(filter), 12);
  for (int n = 0; n < 20; ++n) {  // trembling about one place
    filter.begin(at(n % 2 * 0.8e-6, 0, 0), kRadius, kStill);
    filter.start(10e-3, 1e-3);
    EXPECT_EQ(detours(filter), 0);
    EXPECT_TRUE(filter.take(9.9e-3, 1e-3, kResolution));  // nearer is always allowed
  }
  const Quat turned{Eigen::AngleAxisd{1e-3, Eigen::Vector3d::UnitX()}};  // 10 um at the rim
  filter.begin(at(Eigen::Vector3d::Zero(), turned), kRadius, kStill);
  filter.start(10e-3, 1e-3);
  EXPECT_EQ(detours(filter), 12);
  // a creeping device gets there too
  int given = 0;
  for (int n = 1; n <= 100; ++n) {
    filter.begin(at({0.3e-6 * n, 0, 0}, turned), kRadius, kStill);
    filter.start(10e-3, 1e-3);
    given += detours(filter) == 12;
  }
  EXPECT_GE(given, 20);
}

TEST(TickStats, GivesRateAndTheTimeThatOneTickInAHundredExceeds) {
  TickStats stats;
  EXPECT_EQ(stats.rate(), 0.0);
  Random random{62};
  std::vector<double> times;
  for (int n = 0; n <= 1000; ++n) {
    const double cpu = 20e-6 * std::exp(random.in(0.0, 2.0));
    times.push_back(cpu);
    stats.add(n * 1e-3, cpu);
  }
  std::sort(times.begin(), times.end());
  EXPECT_NEAR(stats.rate(), 1000.0, 1e-6);
  const double exact = times[990];
  EXPECT_GE(stats.p99(),
            0.95 * exact);  // a bin is 5 % wide, and ticks on the edge may go either way
  EXPECT_LE(stats.p99(), 1.08 * exact);
}

TEST(TickStats, StartsAfreshEverySecondAndSurvivesAnyTime) {
  TickStats stats;
  for (int n = 0; n < 1001; ++n) stats.add(n * 1e-3, 1e-3);
  EXPECT_GT(stats.p99(), 0.9e-3);
  for (int n = 1001; n < 2400; ++n) stats.add(n * 1e-3, 1e-5);
  EXPECT_LT(stats.p99(), 2e-5);
  for (const double odd : {0.0, -1.0, 1e9, double(INFINITY), double(NAN)}) stats.add(5.0, odd);
  EXPECT_TRUE(std::isfinite(stats.p99()));
}

TEST(Budget, CountsWorkAndEveryQuestionExactlyAndStaysCut) {
  Budget budget = Budget::counted(10);
  for (int n = 0; n < 4; ++n) {
    EXPECT_TRUE(budget.left());  // one unit to ask
    budget.spend();
  }
  EXPECT_TRUE(budget.left());
  EXPECT_FALSE(budget.left());
  EXPECT_TRUE(budget.cut());
  EXPECT_EQ(budget.spent(), 10);
  EXPECT_FALSE(budget.left());
  EXPECT_EQ(budget.spent(), 10);
}

TEST(Budget, ByTimeEndsOnceTheThreadHasUsedIt) {
  Budget budget = Budget::timed(2'000'000);
  EXPECT_TRUE(budget.left());
  const std::int64_t begun = Budget::threadTime();
  while (Budget::threadTime() - begun < 3'000'000) budget.spend(0);
  budget.spend(1000);
  EXPECT_FALSE(budget.left());
}

TEST(FixedVector, RefusesWhatItHasNoRoomForAndKeepsTheRest) {
  FixedVector<int, 3> items;
  EXPECT_TRUE(items.push(1) && items.push(2) && items.push(3));
  EXPECT_FALSE(items.push(4));
  EXPECT_TRUE(items.full());
  items.dropUnordered(0);
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[0], 3);
  EXPECT_EQ(items[1], 2);
}

}  // namespace
