// SPDX-License-Identifier: BSD-3-Clause
// The wall of a cut lies where it was drawn and has its normal, in a noisy solid, on any grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "datasets/edits/edit_history.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/field/scalar_field.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

namespace {

using namespace datasets;
using namespace haptics;
using datasets::Random;

/// A solid that fills its grid, with grain; and one voxel of air, which is the background.
struct Matter {
  ScalarType type;
  double solid, grain, isovalue, lower, background;
};
constexpr Matter kBone{ScalarType::Int16, 1200.0, 60.0, 300.0, -300.0, -1024.0};
constexpr Matter kBytes{ScalarType::UInt8, 200.0, 8.0, 100.0, 60.0, 0.0};

std::shared_ptr<const Volume> noisySolid(const Grid& grid, const Matter& matter, Random& random) {
  return made::shared(
      datasets::filled(grid, matter.type, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        if (i + j + k == 0) return matter.background;
        return matter.solid + random.in(-matter.grain, matter.grain) * std::sqrt(3.0);
      }));
}

Vec3 middleOf(const Grid& grid) {
  return {0.5 * double(grid.dims[0] - 1), 0.5 * double(grid.dims[1] - 1),
          0.5 * double(grid.dims[2] - 1)};
}

/// A place of an ideal wall, and its unit normal out of what stays.
struct WallPoint {
  Vec3 at_W, normal_W;
};

struct WallErrors {
  double farthest = 0.0, mean = 0.0;  // voxels, in index coordinates
  double turned = 0.0;                // degrees, the most
  int points = 0;
};

/// How the isosurface lies to the wall. `shift`: voxels by which it is expected to lie before it.
void measure(const Volume& volume, double isovalue, const std::vector<WallPoint>& points,
             double shift, WallErrors& errors) {
  const ScalarField field{made::shared(volume)};
  const Grid& grid = volume.grid;
  const VoxelBox box{{5, 5, 5}, {grid.dims[0] - 6, grid.dims[1] - 6, grid.dims[2] - 6}};
  for (const WallPoint& point : points) {
    const Vec3 at = grid.indexOf(point.at_W);
    bool within = true;
    for (int a = 0; a < 3; ++a)
      within = within && at[a] > double(box.first[std::size_t(a)]) &&
               at[a] < double(box.end[std::size_t(a)]);
    if (!within) continue;
    // the normal of a plane in index coordinates
    const Vec3 out =
        grid.spacing.cwiseProduct(grid.direction.transpose() * point.normal_W).normalized();
    Budget budget = millimetre::unlimited();
    const Vec3 from = at + 4.0 * out, to = at - 4.0 * out;
    const double share = field.firstReach(from, to, isovalue, 1e-9, budget);
    ASSERT_LE(share, 1.0) << "no wall";
    const double found = 4.0 - 8.0 * share - shift;
    errors.farthest = std::max(errors.farthest, std::abs(found));
    errors.mean += found;
    const Vec3 normal = -field.centralGradient(from + share * (to - from)).normalized();
    errors.turned = std::max(errors.turned,
                             std::acos(std::min(1.0, normal.dot(point.normal_W))) * 180.0 / M_PI);
    ++errors.points;
  }
}

void expectAWall(const char* name, WallErrors errors) {
  errors.mean /= errors.points;
  std::cout << name << ": " << errors.points << " points, mean " << errors.mean << ", farthest "
            << errors.farthest << " voxel, normal within " << errors.turned << " degrees\n";
  EXPECT_GT(errors.points, 100);
  EXPECT_LT(std::abs(errors.mean), 0.02);
  EXPECT_LT(errors.farthest, 0.1);
  EXPECT_LT(errors.turned, 3.0);
}

Volume applied(const std::shared_ptr<const Volume>& scan, const Edit& edit) {
  const std::vector<Edit> edits{edit};
  return *edited(scan, edits).value();
}

TEST(PlaneCut, LeavesAWallInItsPlane) {
  Random random{191};
  for (const Matter& matter : {kBone, kBytes}) {
    WallErrors at, lower;
    for (int k = 0; k < 12; ++k) {
      const Grid grid =
          k < 4 ? datasets::centredGrid(32, 5e-4) : made::oddGrid(k, {36, 32, 28}, random);
      const auto scan = noisySolid(grid, matter, random);
      const PlaneCut cut{grid.worldOf(middleOf(grid) + random.box(3.0)), random.direction(),
                         matter.isovalue};
      const Volume volume = applied(scan, cut);
      std::vector<WallPoint> points;
      for (int n = 0; n < 60; ++n) {
        Vec3 p = grid.worldOf(middleOf(grid) + random.box(12.0));
        p -= cut.normal_W * cut.normal_W.dot(p - cut.point_W);
        points.push_back({p, cut.normal_W});
      }
      measure(volume, matter.isovalue, points, 0.0, at);
      // a lower isovalue moves the wall, which stays one
      measure(volume, matter.lower, points,
              3.0 * (matter.isovalue - matter.lower) / (matter.isovalue - matter.background),
              lower);
    }
    expectAWall("plane", at);
    expectAWall("plane, lower isovalue", lower);
  }
}

TEST(PlaneCut, LowersWhatIsBeforeItsWallAndNothingBehind) {
  Random random{192};
  const Grid grid = made::oddGrid(1, {40, 30, 20}, random);
  const auto scan = noisySolid(grid, kBone, random);
  const PlaneCut cut{grid.worldOf(middleOf(grid)), random.direction(), 300.0};
  const Volume volume = applied(scan, cut);
  const Vec3 out =
      grid.spacing.cwiseProduct(grid.direction.transpose() * cut.normal_W).normalized();
  const auto* before = static_cast<const std::int16_t*>(scan->voxels.get());
  const auto* after = static_cast<const std::int16_t*>(volume.voxels.get());
  int gone = 0, kept = 0, between = 0;
  for (std::int64_t k = 0, at = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i, ++at) {
        const double d = out.dot(middleOf(grid) - Vec3{double(i), double(j), double(k)});
        ASSERT_LE(after[at], before[at]);
        if (d < -3.0) {
          ++gone;
          ASSERT_EQ(after[at], -1024);
        } else if (d > 2.75) {
          ++kept;
          ASSERT_EQ(after[at], before[at]);
        } else {
          ++between;
        }
      }
  EXPECT_GT(gone, 1000);
  EXPECT_GT(kept, 1000);
  EXPECT_GT(between, 1000);
}

/// A camera that looks at the middle of a grid from outside it.
LassoCut lookingAt(const Grid& grid, bool parallel, Random& random) {
  LassoCut cut;
  const Quat turn = random.rotation();
  const Vec3 middle_W = grid.worldOf(middleOf(grid));
  cut.X_WC = poseOf(middle_W + 0.15 * (turn * Vec3::UnitZ()), turn);
  cut.parallel = parallel;
  return cut;
}

/// A place on the wall over the outline: at a share of an edge and a depth.
WallPoint onWall(const LassoCut& cut, std::size_t edge, double share, double depth) {
  const auto& a = cut.outline[edge];
  const auto& b = cut.outline[(edge + 1) % cut.outline.size()];
  const auto at = [&](double s, double d) -> Vec3 {
    const double grow = cut.parallel ? 1.0 : d;
    return cut.X_WC *
           Vec3{grow * (a[0] + s * (b[0] - a[0])), grow * (a[1] + s * (b[1] - a[1])), -d};
  };
  const Vec3 p = at(share, depth);
  // the outline turns to the left: inside is on the left of an edge, as it is seen
  const Vec3 along = at(share + 0.1, depth) - p, away = at(share, depth + 0.01) - p;
  const Vec3 inwards = along.cross(away).normalized();
  return {p, cut.inside ? inwards : Vec3{-inwards}};
}

TEST(LassoCut, LeavesAWallUnderItsOutline) {
  Random random{193};
  for (const Matter& matter : {kBone, kBytes})
    for (const bool parallel : {true, false}) {
      WallErrors at;
      for (int k = 0; k < 16; ++k) {
        const Grid grid =
            k < 8 ? datasets::centredGrid(48, 5e-4) : made::oddGrid(k, {60, 48, 24}, random);
        const auto scan = noisySolid(grid, matter, random);
        LassoCut cut = lookingAt(grid, parallel, random);
        cut.isovalue = matter.isovalue;
        cut.inside = k % 2 == 0;
        // one edge passes through the middle, the others beyond the grid
        const double size = (parallel ? 1.0 : 1.0 / 0.15) * 0.05;
        const double turn = random.in(0.0, 6.0), off = random.in(-0.04, 0.04) * size;
        for (const auto& [x, y] :
             {std::pair{off, -size}, {3.0 * size, -size}, {3.0 * size, size}, {off, size}})
          cut.outline.push_back(
              {x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)});
        const Volume volume = applied(scan, cut);
        std::vector<WallPoint> points;
        for (int n = 0; n < 120; ++n)
          points.push_back(onWall(cut, 3, random.in(0.4, 0.6), 0.15 + random.in(-0.01, 0.01)));
        measure(volume, matter.isovalue, points, 0.0, at);
      }
      expectAWall(parallel ? "lasso, parallel" : "lasso, perspective", at);
    }
}

TEST(LassoCut, EndsAtItsDepths) {
  Random random{194};
  for (const bool parallel : {true, false}) {
    WallErrors front, back;
    for (int k = 0; k < 8; ++k) {
      const Grid grid = made::oddGrid(k, {60, 48, 32}, random);
      const auto scan = noisySolid(grid, kBone, random);
      LassoCut cut = lookingAt(grid, parallel, random);
      cut.isovalue = kBone.isovalue;
      const double size = parallel ? 0.1 : 0.7;  // beyond the grid
      cut.outline = {{-size, -size}, {size, -size}, {size, size}, {-size, size}};
      const Vec3 view = -cut.X_WC.linear().col(2);
      const auto pointsAt = [&](double depth, const Vec3& normal) {
        std::vector<WallPoint> points;
        for (int n = 0; n < 100; ++n)
          points.push_back(
              {cut.X_WC * Vec3{random.in(-0.008, 0.008), random.in(-0.008, 0.008), -depth},
               normal});
        return points;
      };
      cut.until = 0.15 + random.in(-1e-3, 1e-3);
      measure(applied(scan, cut), kBone.isovalue, pointsAt(cut.until, -view), 0.0, back);
      cut.from = cut.until;
      cut.until = 1.0;
      measure(applied(scan, cut), kBone.isovalue, pointsAt(cut.from, view), 0.0, front);
    }
    expectAWall("depth, beginning", front);
    expectAWall("depth, end", back);
  }
}

TEST(LassoCut, TakesWhatLiesWithinAndLeavesTheRest) {
  Random random{195};
  for (int k = 0; k < 6; ++k) {
    const Grid grid = made::oddGrid(k, {40, 34, 22}, random);
    const auto scan = noisySolid(grid, kBone, random);
    LassoCut cut = lookingAt(grid, k % 2 == 0, random);
    cut.isovalue = kBone.isovalue;
    const double size = (cut.parallel ? 1.0 : 1.0 / 0.15) * 7e-3;
    // a star, so that some corners point inwards
    for (int n = 0; n < 40; ++n) {
      const double r = size * (n % 2 == 0 ? 1.0 : 0.6), turn = n * 2.0 * M_PI / 40.0;
      cut.outline.push_back({r * std::cos(turn), r * std::sin(turn)});
    }
    const Volume volume = applied(scan, cut);
    const auto* before = static_cast<const std::int16_t*>(scan->voxels.get());
    const auto* after = static_cast<const std::int16_t*>(volume.voxels.get());
    const Pose X_CW = cut.X_WC.inverse();
    int gone = 0, kept = 0;
    for (std::int64_t kk = 0, at = 0; kk < grid.dims[2]; ++kk)
      for (std::int64_t j = 0; j < grid.dims[1]; ++j)
        for (std::int64_t i = 0; i < grid.dims[0]; ++i, ++at) {
          const Vec3 u{double(i), double(j), double(kk)};
          const Vec3 p_C = X_CW * grid.worldOf(u);
          const double scale = cut.parallel ? 1.0 : -p_C.z();
          const double radius = std::hypot(p_C.x(), p_C.y()) / scale;
          // the ring between the star's inner and outer corners is not judged, nor what is as near
          // to it as a ramp reaches [m]: four voxels
          const double near = 4.0 * grid.spacing.maxCoeff() / scale;
          if (radius > size + near) {
            ++kept;
            ASSERT_EQ(after[at], before[at]) << i << " " << j << " " << kk;
          } else if (radius < 0.6 * std::cos(M_PI / 40.0) * size - near) {
            ++gone;
            ASSERT_EQ(after[at], -1024) << i << " " << j << " " << kk;
          }
        }
    EXPECT_GT(kept + gone, 300) << k;
  }
}

// Blocks of the cut have their middles at 3.5, 11.5, ...: on the edges of these outlines. Lengths
// are powers of two, so that nothing is rounded.
TEST(LassoCut, AnEdgeThroughTheMiddlesOfBlocksTurnsNothingInsideOut) {
  Random random{196};
  constexpr double kVoxel = 1.0 / 1024.0, kHalf = 12.0 * kVoxel;
  const Grid grid = datasets::centredGrid(48, kVoxel);
  const auto scan = noisySolid(grid, kBone, random);
  for (int k = 0; k < 8; ++k) {
    LassoCut cut;
    // from the front; the outline turns to the left or to the right, from any of its corners
    cut.X_WC.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    cut.X_WC.translation() = Vec3{0.0, -0.25, 0.0};
    cut.parallel = true;
    cut.isovalue = kBone.isovalue;
    cut.outline = {{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}};
    if (k % 2 == 1) std::reverse(cut.outline.begin(), cut.outline.end());
    std::rotate(cut.outline.begin(), cut.outline.begin() + k / 2, cut.outline.end());
    const Volume volume = applied(scan, cut);
    const auto* after = static_cast<const std::int16_t*>(volume.voxels.get());
    for (std::int64_t kk = 0, at = 0; kk < grid.dims[2]; ++kk)
      for (std::int64_t j = 0; j < grid.dims[1]; ++j)
        for (std::int64_t i = 0; i < grid.dims[0]; ++i, ++at) {
          if (at == 0) continue;  // air
          const Vec3 p_W = grid.worldOf(Vec3{double(i), double(j), double(kk)});
          const double reach = std::max(std::abs(p_W.x()), std::abs(p_W.z()));
          ASSERT_EQ(after[at] < kBone.isovalue, reach < kHalf)
              << k << ": " << (p_W / kVoxel).transpose();
        }
  }
}

}  // namespace
