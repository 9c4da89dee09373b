// SPDX-License-Identifier: BSD-3-Clause
// The trilinear isosurface of each analytic phantom is its formula's surface.
#include <gtest/gtest.h>

#include <random>

#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/phantoms/shapes.h"
#include "tests/support/sentence.h"

namespace datasets {
namespace {

using evaluator::fieldAt;
using haptics::Vec3;

/// Whether p_W lies at least `margin` voxels within the grid.
bool within(const haptics::Grid& grid, const Vec3& p_W, double margin) {
  const Vec3 index = grid.indexOf(p_W);
  for (Eigen::Index a = 0; a < 3; ++a)
    if (index[a] < margin ||
        index[a] > static_cast<double>(grid.dims[static_cast<std::size_t>(a)]) - 1.0 - margin)
      return false;
  return true;
}

struct Errors {
  double worst = 0.0;  ///< voxels
  int points = 0;
  int outside = 0, inside = 0;  ///< probes 1.5 voxels off the surface, by the formula
  int wrong = 0;                ///< of those, on the other side of s
};

/// Walks random points to the surface along the normal; there F must be s. `worst` is |F - s|
/// over the slope that the ramp has, so in voxels.
template <class Shape>
Errors errorsOf(const Phantom& phantom, const Shape& shape, double slope, unsigned seed = 7) {
  std::mt19937 draw{seed};
  const auto unit = [&] { return static_cast<double>(draw()) / 4294967296.0; };
  const haptics::Grid& grid = phantom.volume.grid;
  const double h = grid.spacing.x();
  Errors errors;
  for (int trial = 0; trial < 60'000; ++trial) {
    Vec3 index;
    for (Eigen::Index a = 0; a < 3; ++a)
      index[a] = unit() * static_cast<double>(grid.dims[static_cast<std::size_t>(a)] - 1);
    Vec3 p = grid.worldOf(index);
    if (std::abs(shape.distance(p)) > 2.0 * h) continue;
    for (int step = 0; step < 4; ++step) p -= shape.distance(p) * shape.normal(p);
    if (std::abs(shape.distance(p)) > 1e-12 || !within(grid, p, 2.0)) continue;
    ++errors.points;
    errors.worst =
        std::max(errors.worst, std::abs(fieldAt(phantom.volume, p) - phantom.isovalue) / slope);
    const Vec3 n = shape.normal(p);
    for (const double side : {1.5 * h, -1.5 * h}) {
      const Vec3 probe = p + side * n;  // across a narrow groove it may be in the other wall
      const bool solid = fieldAt(phantom.volume, probe) >= phantom.isovalue;
      ++(shape.distance(probe) > 0.0 ? errors.outside : errors.inside);
      errors.wrong += solid == (shape.distance(probe) > 0.0);
    }
  }
  return errors;
}

template <class Shape>
void expectSurface(const char* name, const Shape& shape, double bound_voxels, double slope) {
  SCOPED_TRACE(name);
  const auto phantom = makePhantom(name);
  ASSERT_TRUE(phantom.has_value()) << sentence(phantom.error());
  const Errors errors = errorsOf(*phantom, shape, slope);
  EXPECT_GT(errors.points, 500);  // the sample must reach the surface
  EXPECT_LT(errors.worst, bound_voxels);
  EXPECT_EQ(errors.wrong, 0);
  EXPECT_GT(errors.outside, 500);
  EXPECT_GT(errors.inside, 500);
}

constexpr double kSlope = 4000.0;  // int16 phantoms: intensity per voxel

// flat walls: only the rounding of a voxel to a whole number, half of 1 / 4000 voxel
TEST(AnalyticPhantom, FlatWallsAreExactToTheRoundingOfAVoxel) {
  expectSurface("halfspace", shapes::HalfSpace{}, 1.3e-4, kSlope);
  expectSurface("wedge", shapes::Wedge{}, 1.3e-4, kSlope);
  expectSurface("slot", shapes::Slot{}, 1.3e-4, kSlope);
}

// curved: interpolation errs by up to h^2 / 8 times the second derivatives' sum, 2 / r for a ball
TEST(AnalyticPhantom, CurvedWallsAreExactToSecondOrder) {
  expectSurface("sphere", shapes::Sphere{}, 1.02 * 2.0 / (8.0 * 20.0), kSlope);
  expectSurface("cylinder", shapes::Cylinder{}, 1.05 / (8.0 * 12.0), kSlope);
  expectSurface("torus", shapes::Torus{}, 1.3 * 2.0 / (8.0 * 8.0), kSlope);
  expectSurface("gyroid", shapes::Gyroid{}, 0.06, kSlope);
}

TEST(AnalyticPhantom, TheHoleIsThePapersAndLeavesThePegItsClearance) {
  const auto phantom = makePhantom("hole");
  ASSERT_TRUE(phantom.has_value());
  const haptics::Grid& grid = phantom->volume.grid;
  EXPECT_EQ(grid.dims, (std::array<std::int64_t, 3>{256, 256, 256}));
  EXPECT_DOUBLE_EQ(grid.spacing.x(), 0.0003);
  EXPECT_EQ(phantom->volume.type, haptics::ScalarType::UInt8);
  EXPECT_EQ(phantom->tool, "peg");
  // the walls at 7.65 mm, all round and along the hole; 1e-9 m either side decides
  for (int step = 0; step <= 40; ++step) {
    const double along = 0.0075 * (step / 20.0 - 1.0), z = 0.0018 * (step % 20 - 10);
    for (const auto& [x, y] : {std::pair{1.0, along}, std::pair{-1.0, along}}) {
      const Vec3 wall{0.00765 * x, y, z}, turned{y, 0.00765 * x, z};
      for (const Vec3& p : {wall, turned}) {
        Vec3 out = Vec3::Zero();
        Eigen::Index axis = 0;
        p.head<2>().cwiseAbs().maxCoeff(&axis);
        out[axis] = p[axis] < 0 ? -1.0 : 1.0;
        EXPECT_GE(fieldAt(phantom->volume, p + 1e-9 * out), 128.0) << p.transpose();
        EXPECT_LT(fieldAt(phantom->volume, p - 1e-9 * out), 128.0) << p.transpose();
      }
    }
  }
}

TEST(AnalyticPhantom, OnlyMaterialThatReachesTheBorderIsCut) {
  for (const char* name : {"sphere", "torus", "hole", "marker", "demo"}) {
    SCOPED_TRACE(name);
    const auto phantom = makePhantom(name);
    ASSERT_TRUE(phantom.has_value());
    const haptics::Grid& grid = phantom->volume.grid;
    int solid = 0;
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (const std::int64_t i : {std::int64_t{0}, grid.dims[0] - 1})
        for (std::int64_t k = 0; k < grid.dims[2]; k += 3)
          solid += fieldAt(phantom->volume,
                           grid.worldOf(Vec3(static_cast<double>(i), static_cast<double>(j),
                                             static_cast<double>(k)))) >= phantom->isovalue;
    EXPECT_EQ(solid, 0);
    EXPECT_LT(phantom->volume.least, phantom->isovalue);
  }
}

TEST(AnalyticPhantom, TheMarkerTellsLeftFrontAndTop) {
  const auto phantom = makePhantom("marker");
  ASSERT_TRUE(phantom.has_value());
  const auto solid = [&](double x, double y, double z) {
    return fieldAt(phantom->volume, Vec3{x, y, z}) >= phantom->isovalue;
  };
  EXPECT_TRUE(solid(0.0195, 0, 0));  // left, +x in LPS
  EXPECT_FALSE(solid(-0.0175, 0, 0));
  EXPECT_TRUE(solid(0, -0.0180, 0));  // anterior, -y
  EXPECT_FALSE(solid(0, -0.0200, 0));
  EXPECT_FALSE(solid(0, 0.0175, 0));
  EXPECT_TRUE(solid(0, 0, 0.0165));  // superior, +z
  EXPECT_FALSE(solid(0, 0, 0.0185));
  EXPECT_FALSE(solid(0, 0, -0.0165));
}

// the sizes that README.md and shapes.h state, in numbers of their own
TEST(AnalyticPhantom, TheSolidsStandWhereTheyAreSaidToStand) {
  const auto expectWall = [](const char* name, const Vec3& inside_mm, const Vec3& outside_mm) {
    const auto phantom = makePhantom(name);
    ASSERT_TRUE(phantom.has_value());
    EXPECT_GE(fieldAt(phantom->volume, 1e-3 * inside_mm), phantom->isovalue) << name;
    EXPECT_LT(fieldAt(phantom->volume, 1e-3 * outside_mm), phantom->isovalue) << name;
  };
  expectWall("sphere", {19.9, 0, 0}, {20.1, 0, 0});
  expectWall("halfspace", {3, 4, -0.01}, {3, 4, 0.01});
  expectWall("torus", {27.9, 0, 0}, {28.1, 0, 0});
  expectWall("torus", {0, 12.1, 0}, {0, 11.8, 0});
  expectWall("cylinder", {25, 0, 11.9}, {25, 0, 12.1});
  expectWall("wedge", {0, 5, -16.01}, {0, 5, -15.99});
  expectWall("wedge", {10, 0, 1.3}, {10, 0, 1.4});  // -16 + 10 / tan 30 degrees = 1.32
  expectWall("wedge", {-10, 0, 1.3}, {-10, 0, 1.4});
  expectWall("slot", {4.01, 0, 0}, {3.99, 0, 0});
  expectWall("slot", {-4.01, 0, 0}, {-3.99, 0, 0});
  expectWall("slot", {0, 0, -12.01}, {0, 0, -11.99});
  // sin X cos Y < 0 on the line Z = 0, X = 2, Y = 2 + pi / 2 of a period of 32 mm
  expectWall("gyroid", {0, -4, 0}, {0, 4, 0});
}

TEST(Shapes, NormalsAreTheGradientsOfTheDistances) {
  std::mt19937 draw{11};
  int compared = 0;
  const auto check = [&](const auto& shape, bool is_distance) {
    for (int trial = 0; trial < 2'000; ++trial) {
      const auto unit = [&] { return static_cast<double>(draw()) / 2147483648.0 - 1.0; };
      Vec3 p = 0.03 * Vec3{unit(), unit(), unit()};
      for (int step = 0; step < 6; ++step) p -= shape.distance(p) * shape.normal(p);
      const double h = 1e-6;  // m
      Vec3 gradient;
      for (Eigen::Index a = 0; a < 3; ++a)
        gradient[a] =
            (shape.distance(p + h * Vec3::Unit(a)) - shape.distance(p - h * Vec3::Unit(a))) /
            (2 * h);
      if (std::abs(shape.distance(p)) > 1e-9 || std::abs(gradient.norm() - 1.0) > 0.01)
        continue;  // not on the surface, or within 1 um of a crease
      EXPECT_LT((gradient.normalized() - shape.normal(p)).norm(), 1e-4);
      if (is_distance) {
        EXPECT_NEAR(gradient.norm(), 1.0, 1e-4);
      }
      ++compared;
    }
  };
  check(shapes::Sphere{}, true);
  check(shapes::HalfSpace{}, true);
  check(shapes::Torus{}, true);
  check(shapes::Cylinder{}, true);
  check(shapes::Gyroid{}, false);
  check(shapes::Wedge{}, true);
  check(shapes::Slot{}, true);
  EXPECT_GT(compared, 12'000);
}

}  // namespace
}  // namespace datasets
