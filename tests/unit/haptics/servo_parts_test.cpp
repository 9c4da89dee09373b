// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "datasets/phantoms/making.h"
#include "haptics/core/budget.h"
#include "haptics/core/fixed_vector.h"
#include "haptics/proxy/catch_up.h"
#include "haptics/proxy/pose_filter.h"
#include "haptics/servo/rate.h"
#include "haptics/servo/tick_stats.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::Budget;
using haptics::FixedVector;
using haptics::Pose;
using haptics::PoseFilter;
using haptics::Quat;
using haptics::TickStats;
using made::at;

constexpr double kRadius = 0.01, kTolerance = 2e-3;  // m

/// Begins a tick with the proxy above the device.
void begin(PoseFilter& filter, const Pose& X_WD) {
  const haptics::MassMetric metric{haptics::Mat3::Identity() * 1e-4};
  filter.begin(X_WD, at(X_WD.translation() + Eigen::Vector3d{0.0, 0.0, 10e-3}), metric, kRadius,
               kTolerance);
}

/// A filter that has just begun at the device pose of the origin, from a pose 10 mm away.
PoseFilter begun() {
  PoseFilter filter;
  begin(filter, Pose::Identity());
  filter.start(10e-3, 1e-3);
  return filter;
}

TEST(PoseFilter, TakesANearerPoseOrAShorterStepButNotOneThatIsAsGoodInNeither) {
  PoseFilter filter = begun();
  EXPECT_TRUE(filter.take(9e-3, 2e-3));      // nearer
  EXPECT_TRUE(filter.take(9.5e-3, 0.5e-3));  // less to do
  EXPECT_FALSE(filter.take(9.5e-3, 2e-3));   // worse than one in one, equal in one
  EXPECT_FALSE(filter.take(9e-3, 2e-3));     // seen already
  EXPECT_FALSE(filter.take(9e-3 - 0.001 * kTolerance, 2e-3));  // and no different
  EXPECT_TRUE(filter.take(0.0, 0.0));
}

// a dominated pose is never taken, however the poses come, and detours come to an end
TEST(PoseFilter, NeverTakesWhatAnEarlierPoseDominatesAndEndsItsDetours) {
  Random random{61};
  int refused = 0;
  for (int trial = 0; trial < 200; ++trial) {
    PoseFilter filter = begun();
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
TEST(PoseFilter, ForgetsPosesWhenTheDeviceMovesAtAllAndNotWhileItRests) {
  PoseFilter filter = begun();
  begin(filter, Pose::Identity());
  filter.start(10e-3, 1e-3);
  EXPECT_FALSE(filter.take(10e-3, 1e-3));
  begin(filter, at(1e-12, 0, 0));
  filter.start(10.1e-3, 2e-3);
  EXPECT_TRUE(filter.take(10e-3, 1e-3));
}

int detours(PoseFilter& filter) {
  int taken = 0;
  for (int n = 1; n <= 40; ++n) taken += filter.take(10e-3, 1e-3 - n * 0.0025 * kTolerance);
  return taken;
}

// a slide has what it needs; a hand that trembles or wanders about one place has a dozen in all
TEST(PoseFilter, GivesNewDetoursForTravelAndNoneWithinThePlay) {
  PoseFilter filter = begun();
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
TEST(PoseFilter, RaisesTheSpringByNoMoreThanMovesLetGoOf) {
  Random random{64};
  int detours = 0, refused = 0;
  for (int trial = 0; trial < 150; ++trial) {
    PoseFilter filter;
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
        // a place to wait on the way to a better pose may cost more
        const bool on_the_way = n % 3 == 2;
        const bool takes = on_the_way ? filter.mayWait(next) : filter.wouldTake(next, step);
        const bool took = on_the_way ? filter.takeOnTheWay(next, step) : filter.take(next, step);
        ASSERT_EQ(took, takes);
        if (!took) {
          ++refused;
          continue;
        }
        detours += next > distance;
        given += 0.5 * (next * next - distance * distance);
        const bool waits = on_the_way || next <= distance;
        ASSERT_LE(given, (waits ? 1.0 : 0.5) * kTolerance * 10e-3);
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
TEST(PoseFilter, SavesLittleOfALongWay) {
  PoseFilter filter;
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

/// m^2: what detours raise in all while the device travels along `along`, so many tolerances a
/// tick. In each `follows`-th tick the proxy follows it first, and so the spring releases what that
/// way raised; 0: never.
double raisedAlong(const Eigen::Vector3d& along, double tolerances, int ticks, int follows) {
  PoseFilter filter = begun();
  const double pull = 10e-3, way = tolerances * kTolerance;
  double given = 0.0;
  for (int tick = 1; tick <= ticks; ++tick) {
    begin(filter, at(tick * way * along));
    const int behind = follows > 0 ? (tick - 1) % follows + 1 : 0;
    filter.start(std::hypot(pull, behind * way), 2e-3);
    if (behind < follows) continue;
    if (follows > 0) {
      EXPECT_TRUE(filter.take(pull, 1.5e-3));
    }
    for (int n = 1; n <= 10; ++n) {
      const double far = pull + 0.04 * kTolerance * n, step = 1e-3 - 0.01 * kTolerance * n;
      const double before = pull + 0.04 * kTolerance * (n - 1);
      if (!filter.take(far, step)) break;
      given += 0.5 * (far * far - before * before);
    }
  }
  return given;
}

// a slide raises the spring again and again, by 0.03 of its pull over what it travels, and no
// faster; a press does not
TEST(PoseFilter, ForgivesWhatDetoursRaisedAsTheDeviceTravelsAcrossThePull) {
  const int ticks = 20'000;
  const double pull = 10e-3, travel = (0.01 * ticks - 4.0) * kTolerance;
  const double lent = 0.5 * kTolerance * pull;
  const double slide = raisedAlong(Eigen::Vector3d::UnitX(), 0.01, ticks, 0);
  EXPECT_GT(slide, 0.024 * pull * travel);
  EXPECT_LT(slide, 0.033 * pull * travel + lent);
  EXPECT_LE(raisedAlong(-Eigen::Vector3d::UnitZ(), 0.01, ticks, 0), lent);
}

// in a fast slide, following the device seems to release more than is forgiven
TEST(PoseFilter, DoesNotCountWhatFollowingAcrossThePullReleases) {
  const int ticks = 500;
  const double pull = 10e-3, way = 1.0 * kTolerance;
  const double seems = 0.5 * ticks * way * way, forgiven = 0.03 * pull * ticks * way;
  ASSERT_GT(seems, 1.5 * forgiven);
  const double raised = raisedAlong(Eigen::Vector3d::UnitX(), 1.0, ticks, 1);
  EXPECT_GT(raised, 0.9 * forgiven);
  // detours are up to 0.4 tolerances farther, and are made from where the proxy is behind
  EXPECT_LT(raised, 1.14 * forgiven + 0.5 * kTolerance * pull);
  // a proxy that follows two ticks at once releases twice as much, and the hand has paid for half
  const double late = raisedAlong(Eigen::Vector3d::UnitX(), 1.0, ticks, 2);
  EXPECT_GT(late, 0.9 * (forgiven + seems));
  EXPECT_LT(late, 1.08 * (forgiven + seems) + 0.5 * kTolerance * pull);
}

/// A released proxy in contact, whose centre is some way from a device that rests.
struct Released {
  Released(double away, double of_coupling, double of_servo)
      : stiffness{of_coupling}, period{of_servo}, lag{{away, 0.0, 0.0}, haptics::Vec3::Zero()} {
    release.hold(lag);
  }
  /// Begins a tick after the hand has moved; the share of a motion that is allowed.
  double begin(const haptics::Vec3& by, const haptics::Vec3& motion) {
    lag.linear += by;
    release.begin(lag, metric, haptics::Mat3::Identity(), lag.linear, stiffness, period);
    release.look(lag, whole());
    return release.shareOf(whitened(motion));
  }
  /// Goes so much of the motion, and ends the tick.
  void end(const haptics::Vec3& motion, double share) {
    const haptics::Twist step{motion, haptics::Vec3::Zero()};
    release.go({.motion = step, .advance = share}, whitened(share * motion), true);
    lag.linear -= share * motion;
    release.look(lag, whole());
    release.take();
    release.end(lag, true);
  }
  haptics::Vector6 whole() const { return metric.whitened(lag, haptics::Mat3::Identity()); }
  haptics::Vector6 whitened(const haptics::Vec3& motion) const {
    return metric.whitened({motion, haptics::Vec3::Zero()}, haptics::Mat3::Identity());
  }
  double stiffness, period;
  haptics::Twist lag;
  haptics::MassMetric metric{haptics::Mat3::Identity() * 1e-4};
  haptics::CatchUp release;
};

TEST(Release, GoesTheWayOfAMillisecondAtOnceAndNoMoreInAnyMillisecond) {
  for (const haptics::ServoRate rate : haptics::kServoRates) {
    SCOPED_TRACE(rate.hz);
    const auto fine = static_cast<std::size_t>(rate.hz / 1000);
    constexpr double stiffness = 3000.0;                          // N/m
    const double most = 1e-3 * haptics::releaseSpeed(stiffness);  // m in a millisecond
    Released proxy{0.01, stiffness, rate.period()};
    for (int n = 0; n < 4; ++n) {  // it rests in contact, and its way is saved up
      proxy.begin(haptics::Vec3::Zero(), haptics::Vec3::Zero());
      proxy.end(haptics::Vec3::Zero(), 0.0);
    }
    std::vector<double> ways;
    for (std::size_t n = 0; n < 20 * fine; ++n) {
      const haptics::Vec3 motion = proxy.lag.linear;
      const double share = proxy.begin(haptics::Vec3::Zero(), motion);
      ways.push_back(share * motion.norm());
      proxy.end(motion, share);
    }
    EXPECT_NEAR(ways.front(), most, 1e-6 * most);
    double all = 0.0;
    for (std::size_t n = 0; n < ways.size(); ++n) {
      double last = 0.0;
      for (std::size_t k = 0; k < fine; ++k) last += n >= k ? ways[n - k] : 0.0;
      EXPECT_LE(last, (1.0 + 1e-6) * most) << n;
      all += ways[n];
    }
    EXPECT_NEAR(all, 20.0 * most, 0.05 * most);
  }
}

TEST(Release, FollowsTheHandWhenNothingIsSpare) {
  Random random{7};
  int all = 0;
  for (int n = 0; n < 200; ++n) {
    Released proxy{0.01, 4000.0, 0.25e-3};
    for (int k = 0; k < 4; ++k) {
      proxy.begin(haptics::Vec3::Zero(), haptics::Vec3::Zero());
      proxy.end(haptics::Vec3::Zero(), 0.0);
    }
    const haptics::Vec3 towards = proxy.lag.linear;
    proxy.end(towards, proxy.begin(haptics::Vec3::Zero(), towards));
    // the proxy is now as near as it may be in a millisecond; a step of the hand is still followed
    const haptics::Vec3 step = 1e-5 * random.direction();
    all += proxy.begin(step, step) > 1.0 - 1e-3;
  }
  EXPECT_EQ(all, 200);
}

TEST(Release, ATickThatDidNotFollowLeavesItsWayToTheNextAndNoMore) {
  const double most = 0.25e-3 * haptics::releaseSpeed(3000.0);  // m in a tick
  Released proxy{0.01, 3000.0, 0.25e-3};
  for (int n = 0; n < 4; ++n) {
    proxy.begin(haptics::Vec3::Zero(), haptics::Vec3::Zero());
    proxy.end(haptics::Vec3::Zero(), 0.0);
  }
  proxy.begin(haptics::Vec3::Zero(), haptics::Vec3::Zero());
  proxy.release.end(proxy.lag, false);
  const haptics::Vec3 motion = proxy.lag.linear;
  EXPECT_NEAR(proxy.begin(haptics::Vec3::Zero(), motion) * motion.norm(), 4.0 * most, 1e-6 * most);
}

TEST(Release, ALegIsAsLongAsTheToolWentAlongIt) {
  Released proxy{0.01, 1000.0, 1e-3};
  const haptics::Vec3 motion = proxy.lag.linear;
  proxy.begin(haptics::Vec3::Zero(), motion);
  proxy.release.go({.motion = {motion, haptics::Vec3::Zero()}, .advance = 1.0, .bears = true},
                   proxy.whitened(motion), true);
  proxy.release.shorten(0.5);
  ASSERT_EQ(proxy.release.legs().size(), 1U);
  EXPECT_EQ(proxy.release.legs()[0].advance, 0.5);
  // and the place to wait is on what it went
  proxy.lag.linear *= 0.5;
  proxy.release.look(proxy.lag, proxy.whole());
  const auto place = proxy.release.placeToWait();
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->share * 0.5 * motion.norm(),
              haptics::TouchConstants::kMostFall / 1000.0 * 1e-3, 1e-9);
}

TEST(Release, ASearchThatGoesOnWaitsOnItsWayOfEarlierTicks) {
  Released proxy{0.01, 1000.0, 0.25e-3};
  const haptics::Vec3 motion = 0.5 * proxy.lag.linear, by{1e-4, 0.0, 0.0};
  proxy.begin(haptics::Vec3::Zero(), motion);
  proxy.release.go({.motion = {motion, haptics::Vec3::Zero()}, .advance = 1.0, .bears = true},
                   proxy.whitened(motion), true);
  proxy.release.end(proxy.lag, true);  // the pose that it has reached is not taken
  // the hand goes on, and now it would be
  proxy.begin(by, motion);
  proxy.lag.linear -= motion;
  proxy.release.look(proxy.lag, proxy.whole());
  const auto place = proxy.release.placeToWait();
  ASSERT_TRUE(place);
  const double fall = haptics::TouchConstants::kMostFall / 1000.0 * 0.25e-3;  // m
  EXPECT_NEAR(place->share * motion.norm(), by.norm() + fall, 1e-9);
  // what comes after contact was lost has no way
  proxy.release.hold(proxy.lag);
  EXPECT_FALSE(proxy.release.placeToWait());
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
