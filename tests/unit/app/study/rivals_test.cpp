// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/study/accuracy/led.h"
#include "app/study/comparison/methods.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "datasets/phantoms/shapes.h"
#include "tests/support/made.h"

// The rivals against closed forms: a rival that is wrong would make ours look good.

namespace {

using comparison::kStiffness;
using haptics::Vec3;

constexpr double kVoxel = 1e-3;  // m

/// A shape whose field is its distance, over three voxels on either side.
template <class Shape>
comparison::Touched distanceField(const Shape& shape) {
  return {"made",
          made::shared(datasets::sampledFloat(
              datasets::centredGrid(48, kVoxel),
              [&](const Vec3& p) { return std::clamp(-1e5 * shape.distance(p), -300.0, 300.0); })),
          0.0, "", 0};
}

/// Where a method's tool comes to rest: down from 2 mm above the device's place, then held.
comparison::Tick rested(comparison::Method& method, const haptics::Pose& X_WD) {
  haptics::Pose X = X_WD;
  X.translation().z() += 4e-3;
  method.start(X);
  comparison::Tick tick;
  for (int n = 1; n <= 3000; ++n) {
    X.translation().z() = X_WD.translation().z() + 4e-3 * std::max(0.0, 1.0 - n / 500.0);
    tick = method.tick(X);
  }
  return tick;
}

/// A pole and rings of points below the middle of a ball, symmetric, so that nothing turns it.
std::vector<Vec3> ballBelow(double radius) {
  std::vector<Vec3> points{{0.0, 0.0, -radius}};
  for (const double polar : {0.35, 0.9, std::numbers::pi - 0.9, std::numbers::pi - 0.35})
    for (int n = 0; n < 8; ++n) {
      const double turn = std::numbers::pi * n / 4.0;
      points.push_back(radius * Vec3{std::sin(polar) * std::cos(turn),
                                     std::sin(polar) * std::sin(turn), -std::cos(polar)});
    }
  points.push_back({0.0, 0.0, radius});
  return points;
}

TEST(Penalty, ABallOnAHalfSpaceRestsWhereSpringAndPointsBalance) {
  const auto scene = distanceField(datasets::shapes::HalfSpace{});
  constexpr double kRadius = 6e-3, kDeep = 2e-3;  // m
  const auto tool = made::tool(ballBelow(kRadius));
  for (const double stiffness : {3e3, 1e4, 3e4}) {
    rivals::PenaltySettings settings;
    settings.point_stiffness = stiffness;
    const auto method = comparison::penalty(scene, tool.shell, settings);
    const auto tick = rested(*method, made::at(0.0, 0.0, kRadius - kDeep));
    // pushes of all points that are below against the coupling, by bisection
    double low = kRadius - kDeep, high = kRadius + kVoxel;
    for (int n = 0; n < 60; ++n) {
      const double z = 0.5 * (low + high);
      double push = -kStiffness * (z - (kRadius - kDeep));
      for (const Vec3& p : tool.shell.points)
        push += stiffness * std::max(0.0, settings.layer * kVoxel - (z + p.z()));
      (push > 0.0 ? low : high) = z;
    }
    EXPECT_NEAR(tick.X_WP.translation().z(), low, 1e-7) << stiffness;
    EXPECT_NEAR(tick.force.z(), kStiffness * (low - kRadius + kDeep), 1e-3 * tick.force.z());
    EXPECT_LT(tick.torque.norm(), 1e-6);
  }
}

TEST(Penalty, ManyPointsPushAsStifflyAsTen) {
  const auto scene = distanceField(datasets::shapes::HalfSpace{});
  const auto tool = made::tool(datasets::platePoints(6, 0.02));
  ASSERT_EQ(tool.shell.points.size(), 36u);
  rivals::PenaltySettings settings;
  settings.point_stiffness = 1e4;
  settings.layer = 0.0;
  const auto method = comparison::penalty(scene, tool.shell, settings);
  const auto tick = rested(*method, made::at(0.0, 0.0, -2e-3));
  EXPECT_NEAR(tick.X_WP.translation().z(), -2e-3 * kStiffness / (kStiffness + 1e5), 1e-7);
  EXPECT_EQ(tick.contacts, 36);
}

TEST(GodObject, RestsAtTheNearestPlaceToTheDevice) {
  const datasets::shapes::Sphere sphere{0.015};
  const auto scene = distanceField(sphere);
  const auto tool = made::point();
  const rivals::GodObjectSettings settings;
  const auto method = comparison::godObject(scene, tool.shell, settings);
  for (const Vec3& place : {Vec3{0.0, 0.0, 0.013}, Vec3{0.006, 0.002, 0.010}}) {
    const auto tick = rested(*method, made::at(place.x(), place.y(), place.z()));
    const Vec3 nearest = (sphere.radius + settings.skin * kVoxel) * place.normalized();
    EXPECT_LT((tick.X_WP.translation() - nearest).norm(), 0.03 * kVoxel);
    EXPECT_LT((tick.force - kStiffness * (nearest - place)).norm(), 0.03);
    EXPECT_EQ(tick.contacts, 1);
  }
}

TEST(GodObject, ThatIsInsideMovesToTheEquilibriumOfItsSprings) {
  const auto scene = distanceField(datasets::shapes::HalfSpace{});
  const auto tool = made::point();
  const rivals::GodObjectSettings settings{.penalty = 20.0, .sub_steps = 1, .stride = 3.0};
  const auto method = comparison::godObject(scene, tool.shell, settings);
  method->start(made::at(0.0, 0.0, -0.3e-3));
  const auto tick = method->tick(made::at(0.0, 0.0, -1e-3));
  const double way =
      (-0.7e-3 + settings.penalty * (0.3e-3 + settings.skin * kVoxel)) / (1.0 + settings.penalty);
  EXPECT_NEAR(tick.X_WP.translation().z(), -0.3e-3 + way, 1e-9);
}

/// A ball that comes down on a ball of 15 mm and slides over it, fast.
comparison::Course overABall() {
  comparison::Course course{"slide", {}, false};
  for (int n = 0; n < 400; ++n)
    course.device.push_back(made::at(0.006 * std::sin(0.06 * std::max(0, n - 100)), 0.0,
                                     0.020 - 4e-5 * std::min(n, 100)));
  return course;
}

TEST(Rivals, GivenHalfTheirBudgetMoveInTheDiagram) {
  const auto scene = distanceField(datasets::shapes::Sphere{0.015});
  const auto tool = made::tool(datasets::ballPoints(100, 3e-3));
  study::accuracy::Contenders all;
  const rivals::PenaltySettings penalty;
  const rivals::GodObjectSettings god{.sub_steps = 2};
  for (const int share : {1, 2}) {
    rivals::PenaltySettings settings = penalty;
    // softer, so that the coarse steps hold
    settings.point_stiffness = 3e3;
    settings.sub_steps /= share;
    all.add("penalty", std::to_string(settings.sub_steps),
            comparison::penalty(scene, tool.shell, settings));
    all.add(
        "god object", std::to_string(god.sub_steps / share),
        comparison::godObject(scene, tool.shell, {god.penalty, god.skin, god.sub_steps / share}));
  }
  const std::vector<comparison::Course> courses{overABall()};
  const comparison::FreeBlocks blocks{*scene.volume, scene.isovalue};
  const comparison::Judge judge{scene, tool.shell, blocks};
  const auto led = study::accuracy::led(std::move(all), courses, tool.shell);
  std::vector<comparison::Summary> sums;
  for (const auto& track : led.tracks)
    sums.push_back(comparison::summaryOf(track, courses, tool.shell, judge, 20, 1e-5));
  study::Outcome outcome;
  study::accuracy::addTo(outcome, study::accuracy::couplingOf(
                                      led, "t", sums, courses,
                                      study::accuracy::deviceInside(courses, judge), tool.shell));
  const auto& series = outcome.plots.at(0).series;
  ASSERT_EQ(series.size(), 2u);
  for (std::size_t m = 0; m < 2; ++m) {
    ASSERT_EQ(series[m].points.size(), 2u);
    const auto &one = series[m].points[0], &other = series[m].points[1];
    EXPECT_NE(one.setting, other.setting);
    EXPECT_GT(std::abs(one.y - other.y), 1e-6 * one.y) << series[m].name;
    // the work, which no clock blurs
    const double whole = sums[m].counts.sub_steps, half = sums[m + 2].counts.sub_steps;
    EXPECT_LT(half, 0.75 * whole) << series[m].name;
    EXPECT_LT(sums[m + 2].counts.samples, 0.75 * sums[m].counts.samples) << series[m].name;
  }
}

}  // namespace
