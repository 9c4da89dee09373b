// SPDX-License-Identifier: BSD-3-Clause
#include "app/measurement/capacity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "datasets/phantoms/phantoms.h"
#include "haptics/tool/point_shell.h"
#include "resources/named_tools.h"

// No test here asks how long something takes: budgets are counted, and no tick is too long unless
// the test makes every one so.

namespace {

using measurement::Capacity;
using measurement::CapacityRequest;
using measurement::Load;

const auto nobody = [](double) {};

/// The probe on the sphere, with as much counted work a tick.
CapacityRequest request(std::int64_t work) {
  auto phantom = datasets::makePhantom("sphere").value();
  CapacityRequest out;
  out.isovalue = phantom.isovalue;
  out.scene = haptics::makeScene(
                  std::make_shared<const haptics::Volume>(std::move(phantom.volume)),
                  haptics::makeTool("probe", resources::namedToolMesh("probe").value()).value())
                  .value();
  out.allowance.work = work;
  out.allowance.period = std::numeric_limits<double>::infinity();
  out.touching = 0.3;
  out.seconds = 1e9;
  out.most_points = 20'000;
  return out;
}

/// A machine that carries so many points, and what is found of it.
Capacity found(int capacity, int dense, int most_points = 300'000, int planted = 0) {
  Capacity result;
  result.dense = dense;
  for (int n = 0; n < 30; ++n) {
    const auto points = measurement::nextToTry(result.tried, dense, most_points);
    if (!points) {
      measurement::conclude(result);
      return result;
    }
    Load load;
    load.points = *points;
    load.carried = *points <= capacity && *points != planted;
    for (const Load& known : result.tried) EXPECT_NE(known.points, *points) << "tried twice";
    EXPECT_LE(*points, most_points);
    result.tried.push_back(load);
    std::sort(result.tried.begin(), result.tried.end(),
              [](const Load& a, const Load& b) { return a.points < b.points; });
  }
  ADD_FAILURE() << "the search does not end for " << capacity;
  return result;
}

TEST(Capacity, TheSearchFindsWhatAMachineCarriesWithinAThird) {
  for (const int capacity : {12, 150, 999, 1'000, 2'400, 60'000, 99'999, 100'000, 299'999})
    for (const int dense : {40, 7'100, 2'000'000}) {
      const Capacity result = found(capacity, dense);
      ASSERT_TRUE(result.too_many) << capacity;
      EXPECT_LE(result.most, capacity);
      EXPECT_GT(*result.too_many, capacity);
      EXPECT_LE(*result.too_many, 1.5 * result.most + 2.0) << capacity;  // a third, and rounding
      EXPECT_LE(result.tried.size(), 9U) << capacity;
      EXPECT_EQ(result.suggested, std::min(dense, result.most));
      // what is suggested was tried and carried, not concluded from others
      EXPECT_TRUE(std::any_of(
          result.tried.begin(), result.tried.end(),
          [&](const Load& load) { return load.points == result.suggested && load.carried; }))
          << capacity << ' ' << dense;
    }
}

TEST(Capacity, AMachineThatCarriesEverythingOrNothingIsSaidToDoSo) {
  const Capacity all = found(1'000'000'000, 7'100);
  EXPECT_EQ(all.most, 300'000);
  EXPECT_FALSE(all.too_many);
  EXPECT_EQ(all.suggested, 7'100);
  const Capacity none = found(0, 7'100);
  EXPECT_EQ(none.most, 0);
  EXPECT_EQ(none.too_many, 10);
  EXPECT_EQ(none.suggested, 0);
}

TEST(Capacity, WhatMayBeSuggestedIsTriedAsSoonAsItIsInReach) {
  Load load;
  load.points = 1'000;
  load.carried = true;
  EXPECT_EQ(measurement::nextToTry(std::span{&load, 1}, 750, 300'000), 750);
  EXPECT_EQ(measurement::nextToTry(std::span{&load, 1}, 7'100, 300'000), 10'000);
  load.carried = false;
  EXPECT_EQ(measurement::nextToTry(std::span{&load, 1}, 750, 300'000), 750);
  EXPECT_EQ(measurement::nextToTry(std::span{&load, 1}, 7'100, 300'000), 100);
}

TEST(Capacity, OneDensityThatIsNotCarriedBoundsTheAnswerWhateverHigherOnesDo) {
  EXPECT_GT(found(60'000, 400).most, 10'000);
  const Capacity planted = found(60'000, 400, 300'000, 10'000);
  EXPECT_LT(planted.most, 10'000);
  EXPECT_EQ(planted.too_many, 10'000);
  // also where the one is found last
  EXPECT_EQ(found(60'000, 7'100, 300'000, 7'100).too_many, 7'100);
}

TEST(Capacity, MeasuresThePresentToolAndOthersTheSameEveryTimeWhereWorkIsCounted) {
  const Capacity a = measurement::measureCapacity(request(300), {}, nobody).value();
  const Capacity b = measurement::measureCapacity(request(300), {}, nobody).value();
  EXPECT_EQ(a.present.points, 403);
  EXPECT_NEAR(a.voxel, 1e-3, 1e-12);
  // four hands, less the ticks that follow a sample of the lag
  EXPECT_LE(a.present.ticks, 4 * 300);
  EXPECT_GT(a.present.ticks, 4 * 300 - 4 * 300 / 50);
  EXPECT_LE(a.present.median, a.present.p99);
  EXPECT_LE(a.present.p99, a.present.longest);
  EXPECT_GT(a.present.median, 0.0);
  EXPECT_EQ(a.present.missed, 0);
  ASSERT_EQ(a.tried.size(), b.tried.size());
  ASSERT_GE(a.tried.size(), 3U);
  for (std::size_t n = 0; n < a.tried.size(); ++n) {
    EXPECT_EQ(a.tried[n].points, b.tried[n].points);
    EXPECT_EQ(a.tried[n].cut, b.tried[n].cut);
    EXPECT_EQ(a.tried[n].lag, b.tried[n].lag);
    if (n > 0) {
      EXPECT_GT(a.tried[n].points, a.tried[n - 1].points);
    }
    EXPECT_EQ(a.tried[n].carried, a.tried[n].lag <= measurement::kMostLag * a.voxel);
  }
  EXPECT_EQ(a.most, b.most);
}

TEST(Capacity, ALesserBudgetCutsMoreLagsMoreAndCarriesFewer) {
  const Capacity ample = measurement::measureCapacity(request(1'000'000'000), {}, nobody).value();
  EXPECT_EQ(ample.most, 20'000);
  EXPECT_FALSE(ample.too_many);
  for (const Load& load : ample.tried) {
    EXPECT_EQ(load.cut, 0) << load.points;
    EXPECT_EQ(load.lag, 0.0) << load.points;
  }
  const Capacity little = measurement::measureCapacity(request(300), {}, nobody).value();
  ASSERT_TRUE(little.too_many);
  EXPECT_LT(little.most, ample.most);
  EXPECT_GT(little.tried.back().cut, little.tried.front().cut);
  EXPECT_GT(little.tried.back().lag, measurement::kMostLag * little.voxel);
  EXPECT_LE(little.suggested, little.most);
}

TEST(Capacity, TicksLongerThanThePeriodAreMissesAndAreNotCarried) {
  const CapacityRequest wanted = request(0);
  measurement::Path path;
  path.poses.assign(50, haptics::poseOf(haptics::Vec3{0, 0, 0.1}, haptics::Quat::Identity()));
  measurement::Allowance allowance;
  allowance.work = 1'000'000;
  for (const bool keeps : {true, false}) {
    allowance.period = keeps ? std::numeric_limits<double>::infinity() : 0.0;
    const auto load = measurement::loadOf(*wanted.scene, wanted.isovalue, {}, {path}, allowance,
                                          [] { return true; });
    EXPECT_EQ(load->ticks, 50);
    EXPECT_EQ(load->missed, keeps ? 0 : 50);
    EXPECT_EQ(load->carried, keeps);
  }
}

TEST(Capacity, TheLagIsHowFarTheProxyStaysBehind) {
  const CapacityRequest wanted = request(0);
  measurement::Path path;
  const auto away = haptics::poseOf(haptics::Vec3{0, 0, 0.1}, haptics::Quat::Identity());
  for (int n = 0; n < 150; ++n) {
    path.poses.push_back(away);
    path.poses.back().translation().x() += 1e-4 * n;
  }
  measurement::Allowance allowance;
  allowance.period = std::numeric_limits<double>::infinity();
  const auto lagWith = [&](std::int64_t work) {
    allowance.work = work;
    return measurement::loadOf(*wanted.scene, wanted.isovalue, {}, {path}, allowance,
                               [] { return true; })
        ->lag;
  };
  // with no work at all the proxy stays where it began; every fiftieth tick is looked at
  EXPECT_NEAR(lagWith(1), (0.0 + 50e-4 + 100e-4) / 3.0, 1e-12);
  EXPECT_EQ(lagWith(1'000'000), 0.0);
}

TEST(Capacity, EndsSoonAfterItIsToldToAndSaysSo) {
  for (const int after : {1, 30, 200}) {
    std::stop_source stop;
    int calls = 0;
    const auto result =
        measurement::measureCapacity(request(20'000), stop.get_token(), [&](double fraction) {
          EXPECT_LE(fraction, 1.0);
          if (++calls == after) stop.request_stop();
        });
    ASSERT_FALSE(result) << after;
    EXPECT_EQ(result.error().kind, haptics::Error::Kind::Cancelled);
    EXPECT_EQ(calls, after);
  }
}

TEST(Capacity, BeginsNoOtherToolWhenItsTimeIsUp) {
  CapacityRequest wanted = request(20'000);
  wanted.seconds = 0.0;
  double last = 0.0;
  const Capacity result =
      measurement::measureCapacity(wanted, {}, [&](double fraction) { last = fraction; }).value();
  EXPECT_GT(result.present.ticks, 0);
  EXPECT_TRUE(result.tried.empty());
  EXPECT_EQ(result.most, 0);
  EXPECT_EQ(last, 1.0);
}

TEST(Capacity, RefusesWhatHasNothingToTouch) {
  CapacityRequest wanted = request(20'000);
  wanted.isovalue = 1e9;
  const auto result = measurement::measureCapacity(wanted, {}, nobody);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().reason, "nothing-inside");
}

TEST(Capacity, AnotherToolOfTheMeshGoesWhereTheFirstOneWent) {
  // a mesh whose vertices are not where its area is: the two centroids are far apart
  const haptics::TriangleMesh mesh = resources::namedToolMesh("cane").value();
  const haptics::Tool tool = haptics::makeTool("cane", mesh).value();
  const haptics::Tool other = haptics::makeTool("cane", tool.mesh, 2'000).value();
  ASSERT_GT((tool.mesh.vertices[0] - other.mesh.vertices[0]).norm(), 1e-4);
  measurement::Path path;
  for (int n = 0; n < 5; ++n)
    path.poses.push_back(haptics::poseOf(
        haptics::Vec3{0.01 * n, -0.02, 0.03},
        haptics::Quat{Eigen::AngleAxisd{0.4 * n, haptics::Vec3{1, 2, 3}.normalized()}}));
  const auto same = measurement::pathsFor(other, tool, {path});
  ASSERT_EQ(same.size(), 1U);
  for (int n = 0; n < 5; ++n)
    for (const std::size_t v : {std::size_t{0}, std::size_t{77}, mesh.vertices.size() - 1})
      EXPECT_LT((same[0].poses[n] * other.mesh.vertices[v] - path.poses[n] * tool.mesh.vertices[v])
                    .norm(),
                1e-12);
}

}  // namespace
