// SPDX-License-Identifier: BSD-3-Clause
// Distances to a structure: against closed forms and against every midpoint of a label map.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "datasets/labels/distances.h"
#include "tests/support/made.h"

namespace datasets {
namespace {

using haptics::DistanceMap;
using haptics::Grid;
using haptics::Mat3;
using haptics::Vec3;
using SignedDistance = std::function<double(const Vec3& p_W)>;

/// Oblique, uneven and left-handed.
Grid unevenGrid() {
  Grid grid;
  grid.dims = {61, 57, 43};
  grid.spacing = 1e-3 * Vec3(0.43, 0.51, 0.83);
  grid.direction = Eigen::AngleAxisd{0.6, Vec3{0.3, -0.8, 0.5}.normalized()}.toRotationMatrix() *
                   Vec3(1.0, -1.0, 1.0).asDiagonal();
  grid.origin = 1e-3 * Vec3(-31.0, 12.0, 57.0);
  return grid;
}

Vec3 centreOf(const Grid& grid) {
  return grid.worldOf({0.5 * double(grid.dims[0] - 1), 0.5 * double(grid.dims[1] - 1),
                       0.5 * double(grid.dims[2] - 1)});
}

/// A map of one structure: the voxels whose centre is not outside.
LabelMap marked(const Grid& grid, const SignedDistance& distance) {
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::UInt8).value();
  auto* label = static_cast<std::uint8_t*>(voxels.get());
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i)
        *label++ = distance(grid.worldOf({double(i), double(j), double(k)})) <= 0.0 ? 7 : 0;
  LabelMap map = LabelMap::over(grid).value();
  const std::uint8_t number = map.add(Structure{});
  const haptics::Volume volume =
      haptics::makeVolume(grid, haptics::ScalarType::UInt8, std::move(voxels)).value();
  EXPECT_TRUE(map.add(volume, {{7, number}}));
  return map;
}

/// The greatest errors of a map, m.
struct Errors {
  double outside = 0.0;  ///< at places between voxels
  double inside = 0.0;
  double centre = 0.0;  ///< at voxels
};

/// At places in a part of the grid whose true distance is below `most`.
Errors errorsOf(const DistanceMap& map, const Grid& grid, const SignedDistance& truth,
                std::mt19937& random, double from, double until) {
  std::uniform_real_distribution<double> part(from, until);
  Errors found;
  for (int n = 0; n < 4000; ++n) {
    const Vec3 at(part(random) * double(grid.dims[0] - 1), part(random) * double(grid.dims[1] - 1),
                  part(random) * double(grid.dims[2] - 1));
    const auto keepWorst = [&](const Vec3& p_W, double& worst) {
      const double distance = truth(p_W);
      if (std::abs(distance) < map.most - map.error)
        worst = std::max(worst, std::abs(map.at(p_W) - distance));
    };
    keepWorst(grid.worldOf(at), truth(grid.worldOf(at)) < 0.0 ? found.inside : found.outside);
    keepWorst(grid.worldOf(at.array().round()), found.centre);
  }
  return found;
}

TEST(Distances, AreThoseOfBallsCylindersAndPlanes) {
  const Grid grid = unevenGrid();
  std::mt19937 random{5};
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> shift(-0.5, 0.5);
  const double half = 0.5 * grid.spacing.maxCoeff();
  double worst = 0.0;
  for (int n = 0; n < made::trials(60); ++n) {
    const Vec3 centre = centreOf(grid) + 1e-3 * Vec3(shift(random), shift(random), shift(random));
    Vec3 axis(normal(random), normal(random), normal(random));
    if (n % 6 == 5) axis = grid.direction.col(n % 3);
    axis.normalize();
    const double radius = 1e-3 * (1.0 + double(n % 5));
    SignedDistance truth;
    switch (n % 3) {
      case 0:
        truth = [=](const Vec3& p) { return (p - centre).norm() - radius; };
        break;
      case 1:
        truth = [=](const Vec3& p) {
          return ((p - centre) - axis * axis.dot(p - centre)).norm() - radius;
        };
        break;
      default:
        truth = [=](const Vec3& p) { return axis.dot(p - centre); };
    }
    const LabelMap labels = marked(grid, truth);
    const DistanceMap map = distancesTo(labels, 0, {.most = 0.006}).value();
    // what is beyond the grid does not belong to it, so cylinders and planes end there
    const double from = n % 3 == 0 ? 0.0 : 0.35;
    const Errors found = errorsOf(map, grid, truth, random, from, 1.0 - from);
    EXPECT_LE(found.outside, half) << n;
    EXPECT_LE(found.centre, map.error) << n;
    EXPECT_LE(found.inside, 2.0 * half) << n;
    worst = std::max(worst, found.outside);
    EXPECT_LE(half, map.error);
    EXPECT_LT(map.steepest, 1.75);
  }
  EXPECT_GT(worst, 0.5 * half);  // they were looked at
}

TEST(Distances, AreThoseToTheNearestMidpointAtEachVoxel) {
  Grid grid = unevenGrid();
  grid.dims = {17, 13, 11};
  std::mt19937 random{8};
  std::vector<bool> in(std::size_t(grid.voxelCount()));
  for (int n = 0; n < 40; ++n) in[random() % in.size()] = true;
  const auto belongs = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return i >= 0 && j >= 0 && k >= 0 && i < grid.dims[0] && j < grid.dims[1] && k < grid.dims[2] &&
           in[std::size_t((k * grid.dims[1] + j) * grid.dims[0] + i)];
  };
  const LabelMap labels = marked(grid, [&](const Vec3& p_W) {
    const Vec3 at = grid.indexOf(p_W).array().round();
    return belongs(std::int64_t(at.x()), std::int64_t(at.y()), std::int64_t(at.z())) ? -1.0 : 1.0;
  });
  const DistanceMap map = distancesTo(labels, 0, {.most = 0.004}).value();
  std::vector<Vec3> midpoints;
  for (std::int64_t k = -1; k <= grid.dims[2]; ++k)
    for (std::int64_t j = -1; j <= grid.dims[1]; ++j)
      for (std::int64_t i = -1; i <= grid.dims[0]; ++i)
        for (int axis = 0; axis < 3; ++axis)
          if (belongs(i, j, k) != belongs(i + (axis == 0), j + (axis == 1), k + (axis == 2)))
            midpoints.push_back(grid.worldOf(Vec3(double(i), double(j), double(k)) +
                                             0.5 * Vec3(axis == 0, axis == 1, axis == 2)));
  int saturated = 0;
  for (std::int64_t k = -3; k < grid.dims[2] + 3; ++k)
    for (std::int64_t j = -3; j < grid.dims[1] + 3; ++j)
      for (std::int64_t i = -3; i < grid.dims[0] + 3; ++i) {
        const Vec3 p_W = grid.worldOf({double(i), double(j), double(k)});
        double nearest = map.most;
        for (const Vec3& midpoint : midpoints) nearest = std::min(nearest, (midpoint - p_W).norm());
        saturated += nearest == map.most;
        ASSERT_NEAR(map.at(p_W), belongs(i, j, k) ? -nearest : nearest, 1.01 * map.step)
            << i << ", " << j << ", " << k;
      }
  EXPECT_GT(saturated, 10);
}

TEST(Distances, OfALargeStructureAreCoarserAndLoseNothingThin) {
  const Grid grid = unevenGrid();
  const Vec3 centre = centreOf(grid), normal = grid.direction.col(1);
  const SignedDistance plate = [&](const Vec3& p) {
    return std::abs(normal.dot(p - centre)) - 0.26e-3;  // one voxel thick
  };
  const LabelMap labels = marked(grid, plate);
  const DistanceMap map = distancesTo(labels, 0, {.most = 0.006, .most_bytes = 400'000}).value();
  EXPECT_LE(map.grid.voxelCount() * 7, 400'000);
  EXPECT_NEAR(map.grid.spacing.maxCoeff(), 2 * 0.83e-3, 1e-12);
  std::mt19937 random{3};
  const Errors found = errorsOf(map, grid, plate, random, 0.3, 0.7);
  EXPECT_LE(found.outside, map.error);
  EXPECT_GT(found.outside, 0.1e-3);
  EXPECT_LT(map.at(centre), 0.1e-3);
}

TEST(Distances, AreAsManyAsWasSaidBefore) {
  const Grid grid = unevenGrid();
  const LabelMap labels =
      marked(grid, [&](const Vec3& p) { return (p - centreOf(grid)).norm() - 0.004; });
  haptics::VoxelBox box{grid.dims, {}};
  for (std::int64_t n = 0; n < grid.voxelCount(); ++n)
    if (labels.codes()[n] != 0)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::array<std::int64_t, 3> at{n % grid.dims[0], n / grid.dims[0] % grid.dims[1],
                                             n / grid.dims[0] / grid.dims[1]};
        box.first[axis] = std::min(box.first[axis], at[axis]);
        box.end[axis] = std::max(box.end[axis], at[axis] + 1);
      }
  for (const std::size_t bytes : {std::size_t{100'000'000}, std::size_t{300'000}}) {
    const DistanceOptions options{.most = 0.006, .most_bytes = bytes};
    EXPECT_EQ(distanceSamples(grid, box, options),
              distancesTo(labels, 0, options).value().grid.voxelCount());
  }
}

TEST(Distances, EndWhenTheyAreCancelled) {
  const Grid grid = unevenGrid();
  const LabelMap labels =
      marked(grid, [&](const Vec3& p) { return (p - centreOf(grid)).norm() - 0.004; });
  int told = 0;
  double last = 0.0;
  const auto whole = distancesTo(labels, 0, {}, [&](double part) {
    EXPECT_GT(part, last);
    last = part;
    ++told;
    return true;
  });
  ASSERT_TRUE(whole);
  EXPECT_EQ(last, 1.0);
  for (int after = 1; after < told; ++after) {
    int left = after;
    const auto none = distancesTo(labels, 0, {}, [&](double) { return --left > 0; });
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, haptics::Error::Kind::Cancelled);
  }
}

}  // namespace
}  // namespace datasets
