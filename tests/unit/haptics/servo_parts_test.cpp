// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "datasets/phantoms/making.h"
#include "haptics/core/budget.h"
#include "haptics/core/fixed_vector.h"
#include "haptics/servo/acceptance.h"
#include "haptics/servo/tick_stats.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::Acceptance;
using haptics::Budget;
using haptics::FixedVector;
using haptics::Pose;
using haptics::Quat;
using haptics::TickStats;
using made::at;

constexpr double kRadius = 0.01, kTolerance = 2e-3;  // m

/// Begins a tick with the proxy above the device.
void begin(Acceptance& filter, const Pose& X_WD) {
  filter.begin(X_WD, at(X_WD.translation() + Eigen::Vector3d{0.0, 0.0, 10e-3}), kRadius,
               kTolerance);
}

/// A filter that has just begun at the device pose of the origin, from a pose 10 mm away.
Acceptance begun() {
  Acceptance filter;
  begin(filter, Pose::Identity());
  filter.start(10e-3, 1e-3);
  return filter;
}

TEST(Acceptance, TakesANearerPoseOrAShorterStepButNotOneThatIsAsGoodInNeither) {
  Acceptance filter = begun();
  EXPECT_TRUE(filter.take(9e-3, 2e-3));      // nearer
  EXPECT_TRUE(filter.take(9.5e-3, 0.5e-3));  // less to do
  EXPECT_FALSE(filter.take(9.5e-3, 2e-3));   // worse than one in one, equal in one
  EXPECT_FALSE(filter.take(9e-3, 2e-3));     // seen already
  EXPECT_FALSE(filter.take(9e-3 - 0.001 * kTolerance, 2e-3));  // and no different
  EXPECT_TRUE(filter.take(0.0, 0.0));
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
      const bool took = filter.take(distance, step);
      for (const auto& [d, s] : taken)
        if (distance >= d && step >= s) {
          ASSERT_FALSE(took);
        }
      refused += !took;
      if (!took) continue;
      taken.emplace_back(distance, step);
      detours += distance >= nearest - 0.002 * kTolerance;
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
  begin(filter, Pose::Identity());
  filter.start(10e-3, 1e-3);
  EXPECT_FALSE(filter.take(10e-3, 1e-3));
  begin(filter, at(1e-12, 0, 0));
  filter.start(10.1e-3, 2e-3);
  EXPECT_TRUE(filter.take(10e-3, 1e-3));
}

int detours(Acceptance& filter) {
  int taken = 0;
  for (int n = 1; n <= 40; ++n) taken += filter.take(10e-3, 1e-3 - n * 0.0025 * kTolerance);
  return taken;
}

// a slide has what it needs; a hand that trembles or wanders about one place has a dozen in all
TEST(Acceptance, GivesNewDetoursForTravelAndNoneWithinThePlay) {
  Acceptance filter = begun();
  EXPECT_EQ(detours(filter), 12);
  Random random{63};
  for (int n = 0; n < 200; ++n) {
    const Eigen::Vector3d p = random.direction() * random.in(0.0, 2.0 * kTolerance);
    const Quat q{Eigen::AngleAxisd{1.9 * kTolerance / kRadius, random.direction()}};
    begin(filter, at(p, q));
    filter.start(10e-3, 1e-3);
    ASSERT_EQ(detours(filter), 0);
    ASSERT_TRUE(filter.take(9.9e-3, 1e-3));  // nearer is always allowed
  }
  // to and fro along a line: after the play, a dozen for each half of a tolerance
  int given = 0;
  const auto slide = [&](int from, int to) {
    given = 0;
    for (int n = from; n != to; n += to > from ? 1 : -1) {
      begin(filter, at({0.1 * kTolerance * n, 0, 0}, Quat::Identity()));
      filter.start(10e-3, 1e-3);
      given += detours(filter) == 12;
    }
  };
  slide(0, 1000);
  const auto expectDozens = [&](double travel) {  // in tolerances, counted each 0.1
    EXPECT_GE(given, int(travel / 0.6) - 1);
    EXPECT_LE(given, int(travel / 0.5) + 1);
  };
  expectDozens(100.0 - 4.0);
  slide(1000, 0);
  expectDozens(100.0 - 8.0);
  // turning counts as its rim
  filter = begun();
  detours(filter);
  given = 0;
  for (int n = 0; n <= 100; ++n) {
    const double angle = 0.1 * kTolerance / kRadius * n;
    begin(filter, at({0, 0, 0}, Quat{Eigen::AngleAxisd{angle, Eigen::Vector3d::UnitX()}}));
    filter.start(10e-3, 1e-3);
    given += detours(filter) == 12;
  }
  expectDozens(10.0 - 4.0);
}

// the spring's energy over the stiffness is half of the distance squared
// of a hand that stays within the play
TEST(Acceptance, RaisesTheSpringByNoMoreThanMovesLetGoOf) {
  Random random{64};
  int detours = 0, refused = 0;
  for (int trial = 0; trial < 150; ++trial) {
    Acceptance filter;
    double distance = 5e-3, given = 0.0;
    for (int tick = 0; tick < 100; ++tick) {
      // the device moves, the proxy does not
      begin(filter, at(random.direction() * 1.9 * kTolerance));
      distance = std::clamp(distance + random.in(-1e-3, 1e-3), 1e-4, 8e-3);
      filter.start(distance, 1e-3);
      const double first = distance;
      for (int n = 0; n < 10; ++n) {
        const double next = random.in(0.8, 1.2) * distance;
        const double step = random.in(0.0, 1e-3);
        // a place on the way counts like any other
        const bool on_the_way = n % 3 == 2;
        const bool takes = on_the_way ? filter.affords(next) : filter.takes(next, step);
        const bool took = on_the_way ? filter.takeOnTheWay(next, step) : filter.take(next, step);
        ASSERT_EQ(took, takes);
        if (!took) {
          ++refused;
          continue;
        }
        detours += next > distance;
        given += 0.5 * (next * next - distance * distance);
        ASSERT_LE(given, 0.5 * kTolerance * 10e-3);
        distance = next;
        // and in a tick by a tolerance against the pull at most
        ASSERT_LE(0.5 * (distance * distance - first * first), 1.001 * kTolerance * first);
      }
    }
  }
  EXPECT_GT(detours, 1000);
  EXPECT_GT(refused, 1000);
}

// a long way that the spring let go of pays for four tolerances against its pull, not for more
TEST(Acceptance, SavesLittleOfALongWay) {
  Acceptance filter;
  begin(filter, Pose::Identity());
  filter.start(100e-3, 1e-3);
  ASSERT_TRUE(filter.take(50e-3, 1e-3));
  double given = 0.0;
  for (int tick = 1; tick <= 100; ++tick) {
    begin(filter, at({0.0, 0.0, 0.01 * kTolerance * tick}));
    filter.start(50e-3, 1e-3);
    if (filter.take(51.9e-3, 0.5e-3)) given += 0.5 * (51.9e-3 * 51.9e-3 - 50e-3 * 50e-3);
  }
  EXPECT_GT(given, 4.0 * kTolerance * 50e-3);
  EXPECT_LT(given, 4.6 * kTolerance * 100e-3);
}

/// m^2: what detours raise in all while the device travels along `along`, 0.1 tolerances a tick.
double raisedAlong(const Eigen::Vector3d& along, int ticks) {
  Acceptance filter = begun();
  double given = 0.0;
  for (int tick = 1; tick <= ticks; ++tick) {
    begin(filter, at(0.1 * kTolerance * tick * along));
    filter.start(10e-3, 1e-3);
    for (int n = 1; n <= 10; ++n) {
      const double far = 10e-3 + 0.04 * kTolerance * n, step = 1e-3 - 0.01 * kTolerance * n;
      const double before = 10e-3 + 0.04 * kTolerance * (n - 1);
      if (!filter.take(far, step)) break;
      given += 0.5 * (far * far - before * before);
    }
  }
  return given;
}

// a slide raises the spring again and again, by a tenth of its pull over what it travels, and no
// faster; a press does not
TEST(Acceptance, ForgivesWhatDetoursRaisedAsTheDeviceTravelsAcrossThePull) {
  const int ticks = 2'000;
  const double pull = 10e-3, travel = (0.1 * ticks - 4.0) * kTolerance;
  const double lent = 0.5 * kTolerance * pull;
  const double slide = raisedAlong(Eigen::Vector3d::UnitX(), ticks);
  EXPECT_GT(slide, 0.08 * pull * travel);
  EXPECT_LT(slide, 0.11 * pull * travel + lent);
  EXPECT_LE(raisedAlong(-Eigen::Vector3d::UnitZ(), ticks), lent);
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
