// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>

#include "haptics/field/scalar_field.h"
#include "tests/unit/ui/volumes.h"

namespace {

using haptics::FieldKind;
using haptics::ScalarField;
using haptics::Vec3;
using ui::Patch;

// thick and thin walls, and the noise of a scanner: 30 to 40 per voxel at the surface's slope of
// some 250
std::shared_ptr<const haptics::Volume> knobbly() {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 35.0);
  return std::make_shared<const haptics::Volume>(
      volumes::made(volumes::turnedGrid({44, 36, 26}), [&](const Vec3& u) {
        const Vec3 from = u - Vec3{21.0, 17.0, 12.0};
        const double radius = 9.0 + 3.0 * std::sin(0.35 * u.x()) * std::cos(0.4 * u.y());
        const double ball = std::clamp(800.0 + 250.0 * (radius - from.norm()), 0.0, 1600.0);
        return ball + noise(random);
      }));
}

// 12 mm of the middle of the volume, on a plane that lies oblique to grid and patient
Patch obliquePatch(const haptics::Grid& grid) {
  const Vec3 normal = Vec3{0.3, -0.5, 0.8}.normalized();
  const Vec3 right = normal.unitOrthogonal();
  const Vec3 up = normal.cross(right);
  const Vec3 middle_mm = grid.worldOf({21.0, 17.0, 12.0}) * 1e3;
  return {.corner_W_mm = middle_mm - 10.0 * right - 9.0 * up,
          .right = right,
          .up = up,
          .width_mm = 20.0,
          .height_mm = 18.0};
}

std::function<double(const Vec3&)> valueOf(const ScalarField& field) {
  return [&field](const Vec3& p_W) { return field.value(field.indexOf(p_W)); };
}

/// Distances of evenly drawn places of the contour from the field's surface, in voxels, ascending.
std::vector<double> distances(const std::vector<QLineF>& pieces, const Patch& patch,
                              const ScalarField& field, double level, int count) {
  std::vector<double> lengths;
  for (const QLineF& piece : pieces) lengths.push_back(piece.length());
  std::mt19937 random(3);
  std::discrete_distribution<std::size_t> some(lengths.begin(), lengths.end());
  std::uniform_real_distribution<double> along(0.0, 1.0);
  std::vector<double> all;
  for (int n = 0; n < count; ++n) {
    const Vec3 p_W = patch.at(pieces[some(random)].pointAt(along(random))) * 1e-3;
    const haptics::FieldSample sample = field.sample(field.indexOf(p_W));
    all.push_back(std::abs(sample.value - level) / sample.gradient_W.norm() / field.voxel());
  }
  std::ranges::sort(all);
  return all;
}

TEST(Contour, IsTheTouchedSurfaceWithinATenthOfAVoxelForBothFieldsOnATurnedGrid) {
  const auto volume = knobbly();
  for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline}) {
    const ScalarField field(volume, kind);
    const Patch patch = obliquePatch(volume->grid);
    for (const double step_mm : {0.5, 0.125}) {  // a voxel, as for a whole slice; and close by
      const auto pieces =
          ui::contourOf(valueOf(field), 800.0, patch, {.step_mm = step_mm, .voxel_mm = 0.5});
      ASSERT_GT(pieces.size(), 50U);
      const auto apart = distances(pieces, patch, field, 800.0, 1'000);
      std::printf("%s, step %.3f mm: %zu pieces, distance median %.4f, greatest %.4f voxel\n",
                  kind == FieldKind::CubicSpline ? "spline" : "trilinear", step_mm, pieces.size(),
                  apart[500], apart.back());
      EXPECT_LT(apart.back(), 0.1);
    }
  }
}

// whoever goes from the solid to what is not crosses the contour
TEST(Contour, HasNoGapAndMissesNoSide) {
  const auto volume = knobbly();
  const ScalarField field(volume, FieldKind::Trilinear);
  const Patch patch = obliquePatch(volume->grid);
  const auto value = valueOf(field);
  const auto pieces = ui::contourOf(value, 800.0, patch, {.step_mm = 0.25, .voxel_mm = 0.5});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(0.5, 19.5), y(0.5, 17.5);
  int crossed = 0;
  for (int n = 0; n < 1'000; ++n) {
    const QLineF walk{x(random), y(random), x(random), y(random)};
    const bool from = value(patch.at(walk.p1()) * 1e-3) >= 800.0;
    const bool to = value(patch.at(walk.p2()) * 1e-3) >= 800.0;
    if (from == to) continue;
    ++crossed;
    EXPECT_TRUE(std::ranges::any_of(pieces,
                                    [&](const QLineF& piece) {
                                      return piece.intersects(walk, nullptr) ==
                                             QLineF::BoundedIntersection;
                                    }))
        << "walk " << n;
  }
  EXPECT_GT(crossed, 200);
}

TEST(Contour, IsClosedAtTheFacesWhereTheFieldFallsToTheBackground) {
  // solid up to all faces: the surface is in the ring of one voxel around them
  const haptics::Grid grid = volumes::turnedGrid({12, 10, 8});
  const auto volume = std::make_shared<const haptics::Volume>(
      volumes::made(grid, [](const Vec3& u) { return u.norm() < 1.0 ? -1000.0 : 1000.0; }));
  const ScalarField field(volume, FieldKind::Trilinear);
  const Vec3 corner_mm = grid.worldOf({-3.0, -3.0, 4.0}) * 1e3;
  const Patch patch{.corner_W_mm = corner_mm,
                    .right = grid.direction.col(0),
                    .up = grid.direction.col(1),
                    .width_mm = 9.0,
                    .height_mm = 11.2};
  const auto pieces = ui::contourOf(valueOf(field), 0.0, patch, {.step_mm = 0.25, .voxel_mm = 0.5});
  double length = 0.0;
  for (const QLineF& piece : pieces) length += piece.length();
  // half a voxel beyond the outermost centres; each corner is a hyperbola, 0.17 mm shorter
  EXPECT_NEAR(length, 2.0 * (12 * 0.5 + 10 * 0.7) - 4 * 0.17, 0.05);
  EXPECT_LT(distances(pieces, patch, field, 0.0, 1'000).back(), 0.1);
}

TEST(Contour, IsNothingWithoutAField) {
  EXPECT_TRUE(ui::contourOf({}, 0.0, {.width_mm = 5.0, .height_mm = 5.0}, {}).empty());
}

double cpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// what it costs, for the record: no limit is asserted
TEST(Contour, OfAWholeSlice) {
  haptics::Grid grid;
  grid.dims = {512, 512, 8};
  grid.spacing = {0.5e-3, 0.5e-3, 1e-3};
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 30.0);
  // a skull of 6 mm with a brain, and cells in it
  const auto volume =
      std::make_shared<const haptics::Volume>(volumes::made(grid, [&](const Vec3& u) {
        const double r = std::hypot(u.x() - 256.0, u.y() - 256.0) + 8.0 * std::sin(0.05 * u.x());
        const double wall = 1200.0 * std::exp(-0.5 * std::pow((r - 200.0) / 8.0, 2.0));
        const double cells =
            r > 60 && r < 120 ? 300.0 * std::sin(0.5 * u.x()) * std::sin(0.5 * u.y()) : 0.0;
        return wall + cells + noise(random);
      }));
  const Patch patch{.corner_W_mm = {0.0, 0.0, 4.3},
                    .right = Vec3::UnitX(),
                    .up = Vec3::UnitY(),
                    .width_mm = 255.5,
                    .height_mm = 255.5};
  for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline}) {
    const ScalarField field(volume, kind);
    const auto value = valueOf(field);
    for (const bool fine : {true, false}) {
      std::size_t pieces = 0;
      double best = 1e9;
      for (int n = 0; n < 3; ++n) {
        const double start = cpuSeconds();
        pieces = ui::contourOf(value, 250.0, patch,
                               {.step_mm = fine ? 0.5 : 1.0, .voxel_mm = 0.5, .bent = fine})
                     .size();
        best = std::min(best, cpuSeconds() - start);
      }
      std::printf("%s, %s: %.1f ms of a core, %zu pieces\n",
                  kind == FieldKind::CubicSpline ? "spline" : "trilinear", fine ? "fine" : "coarse",
                  1e3 * best, pieces);
      EXPECT_GT(pieces, 1'000U);
    }
  }
}

}  // namespace
