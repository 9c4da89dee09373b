// SPDX-License-Identifier: BSD-3-Clause
// The distance of a tool to structures: nothing is nearer than what is told, to the bit.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/scene/watch.h"
#include "tests/support/made.h"
#include "tests/support/made_distances.h"

namespace {

using datasets::Random;
using haptics::DistanceMap;
using haptics::Nearnesses;
using haptics::Pose;
using haptics::Vec3;
using haptics::Watch;

std::shared_ptr<const haptics::Scene> sceneWith(const std::vector<Vec3>& points) {
  return made::scene(datasets::solid(datasets::centredGrid(24, 1e-3),
                                     [](const auto& p) { return p.norm() - 0.008; }),
                     made::tool(points));
}

std::shared_ptr<const haptics::Scene> sceneWith(int points) {
  return sceneWith(points == 1 ? std::vector<Vec3>{Vec3::Zero()}
                               : datasets::ballPoints(points, 6e-3));
}

/// In all directions about any place between them.
std::vector<Vec3> cloud(Random& random) {
  std::vector<Vec3> points(1000);
  for (Vec3& point : points) point = random.box(6e-3);
  return points;
}

/// Oblique and left-handed, some 60 mm wide.
haptics::Grid obliqueGrid() {
  haptics::Grid grid;
  grid.dims = {41, 47, 35};
  grid.spacing = 1e-3 * Vec3(1.5, 1.3, 1.8);
  grid.direction = Eigen::AngleAxisd{0.7, Vec3{0.2, 0.9, -0.4}.normalized()}.toRotationMatrix() *
                   Vec3(1.0, 1.0, -1.0).asDiagonal();
  grid.origin = -grid.direction * (0.5 * grid.spacing.cwiseProduct(Vec3(40.0, 46.0, 34.0)));
  return grid;
}

TEST(Watch, TellsTheLeastOfAllPointsToTheBit) {
  Random random{91};
  const Vec3 middle(4e-3, -7e-3, 2e-3), axis = Vec3(0.3, 0.5, 0.8).normalized();
  Watch watch;
  watch.structures.push_back(
      {4, made::distanceMap(
              obliqueGrid(), [&](const Vec3& p) { return (p - middle).norm() - 9e-3; }, 0.012)});
  watch.structures.push_back({9, made::distanceMap(
                                     obliqueGrid(),
                                     [&](const Vec3& p) {
                                       const double along = std::clamp(axis.dot(p), -0.01, 0.01);
                                       return (p - along * axis).norm() - 1e-3;
                                     },
                                     0.012)});
  // steeper than a distance, as what is linear between samples may be
  watch.structures.push_back(
      {2, made::distanceMap(
              obliqueGrid(), [&](const Vec3& p) { return 1.6 * p.norm() - 5e-3; }, 0.012)});
  // as steep as its bound almost everywhere
  watch.structures.push_back(
      {3, made::distanceMap(
              obliqueGrid(), [&](const Vec3& p) { return p.norm() - 0.015; }, 0.012)});
  int inside = 0, near = 0, far = 0;
  for (const auto& scene :
       {sceneWith(1), sceneWith(3), sceneWith(60), sceneWith(6000), sceneWith(cloud(random))}) {
    const std::size_t points = scene->tool.shell.points.size();
    for (int n = 0; n < 200; ++n) {
      const Pose X_WP = haptics::poseOf(random.box(0.03), random.rotation());
      Nearnesses measured;
      haptics::measure(watch, *scene, X_WP, measured);
      ASSERT_EQ(measured.size(), 4U);
      for (std::size_t of = 0; of < 4; ++of) {
        const DistanceMap& map = watch.structures[of].distances;
        EXPECT_EQ(measured[of].structure, watch.structures[of].structure);
        double least = map.told();
        for (const Vec3& p : scene->tool.shell.points) least = std::min(least, map.at(X_WP * p));
        // the map's axes times the tool's are rounded in another order
        ASSERT_NEAR(measured[of].nearest, least, 1e-9) << points << " points, " << n;
        ASSERT_NEAR(measured[of].tip, std::min(map.told(), map.at(X_WP * scene->tool.shell.tip)),
                    1e-9);
        inside += measured[of].nearest < 0.0F;
        near += measured[of].nearest > 0.0F && least < map.told();
        far += least == map.told();
      }
      Nearnesses again;
      haptics::measure(watch, *scene, X_WP, again);
      EXPECT_TRUE(std::equal(again.begin(), again.end(), measured.begin()));
    }
  }
  EXPECT_GT(inside, 30);
  EXPECT_GT(near, 100);
  EXPECT_GT(far, 100);
}

TEST(Watch, IsAsFarAsTheClosedForm) {
  const auto scene = sceneWith(400);
  const Vec3 middle(2e-3, 1e-3, -3e-3);
  Watch watch;
  watch.structures.push_back({1, made::distanceMap(obliqueGrid(), [&](const Vec3& p) {
                                return (p - middle).norm() - 5e-3;
                              })});
  Random random{7};
  for (int n = 0; n < 100; ++n) {
    const Vec3 way = random.box(1.0).normalized();
    Nearnesses measured;
    haptics::measure(watch, *scene, made::at(middle + way * 15e-3), measured);
    EXPECT_NEAR(measured[0].nearest, 15e-3 - 5e-3 - scene->tool.shell.radius, 2e-4);
  }
}

TEST(Watch, BeyondAMapAndAtAPoseThatIsNoneIsFar) {
  const auto scene = sceneWith(60);
  Watch watch;
  for (std::uint8_t n = 0; n < haptics::kMostWatched + 3; ++n)
    watch.structures.push_back(
        {n, made::distanceMap(obliqueGrid(), [](const Vec3& p) { return p.norm() - 5e-3; })});
  Nearnesses measured;
  haptics::measure(watch, *scene, made::at(1.0, 2.0, 3.0), measured);
  ASSERT_EQ(measured.size(), haptics::kMostWatched);
  for (const haptics::Nearness& one : measured) {
    EXPECT_FLOAT_EQ(one.tip, 0.020F);
    EXPECT_FLOAT_EQ(one.nearest, 0.020F);
  }
  haptics::measure(watch, *scene, made::at(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0),
                   measured);
  EXPECT_FLOAT_EQ(measured[0].nearest, 0.020F);
}

}  // namespace
