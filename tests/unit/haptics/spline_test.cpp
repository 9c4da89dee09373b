// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/field/scalar_field.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"
#include "tests/unit/haptics/spline_reference.h"

namespace {

using datasets::Random;
using haptics::Budget;
using haptics::FieldKind;
using haptics::FieldSample;
using haptics::Grid;
using haptics::Isosurface;
using haptics::MaxPyramid;
using haptics::ScalarField;
using haptics::ScalarType;
using haptics::Vec3;
using haptics::Volume;
using millimetre::h;
using millimetre::unlimited;

Vec3 around(const Grid& grid, double margin, Random& random) {
  Vec3 u;
  for (int axis = 0; axis < 3; ++axis)
    u[axis] = random.in(-margin, double(grid.dims[static_cast<std::size_t>(axis)] - 1) + margin);
  return u;
}

TEST(SplineField, IsTheSplineOfItsVoxelsWhateverTheirTypeAndFrame) {
  Random random{1};
  int within = 0, falling = 0, beyond = 0, k = 0;
  for (const ScalarType type : made::kTypes)
    for (const std::array<std::int64_t, 3> dims :
         {std::array<std::int64_t, 3>{9, 7, 5}, {1, 2, 3}, {40, 1, 4}}) {
      SCOPED_TRACE(haptics::nameOf(type));
      const Grid grid = made::oddGrid(k++, dims, random);
      const auto volume = made::shared(made::randomVolume(grid, type, random));
      const ScalarField field{volume, FieldKind::CubicSpline};
      for (int n = 0; n < made::trials(1500); ++n) {
        const Vec3 u = around(grid, 3.0, random);
        const double value = field.value(u);
        // what legality keeps away from the isovalue must cover how far two evaluations differ
        ASSERT_NEAR(value, spline_reference::fieldAtIndex(*volume, u), field.roundingMargin());
        ASSERT_NEAR(field.sample(u).value, value, field.roundingMargin());
        const double past = std::max(
            (-u).maxCoeff(),
            (u - Vec3{double(dims[0] - 1), double(dims[1] - 1), double(dims[2] - 1)}).maxCoeff());
        ++(past <= 0.0 ? within : past < 1.0 ? falling : beyond);
        if (past >= 1.0) {
          ASSERT_EQ(value, volume->least);
        }
      }
    }
  EXPECT_GT(within, made::trials(1000));
  EXPECT_GT(falling, made::trials(4000));
  EXPECT_GT(beyond, made::trials(4000));
}

TEST(SplineField, GradientIsTheSlopeOfTheField) {
  Random random{2};
  int falling = 0;
  for (int k = 0; k < 6; ++k) {
    const Grid grid = made::oddGrid(k, {6, 7, 6}, random);
    const auto volume = made::shared(made::randomVolume(grid, ScalarType::Float32, random));
    const ScalarField field{volume, FieldKind::CubicSpline};
    for (int n = 0; n < 400; ++n) {
      const Vec3 u = around(grid, 1.0, random);
      // a face is a kink; a difference across it says nothing
      constexpr double d = 1e-4;
      bool kink = false;
      for (int axis = 0; axis < 3; ++axis)
        kink = kink || std::abs(u[axis] - std::round(u[axis])) < 2.0 * d;
      if (kink) continue;
      Vec3 slope;
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 a = u, b = u;
        a[axis] -= d;
        b[axis] += d;
        slope[axis] = (spline_reference::fieldAtIndex(*volume, b) -
                       spline_reference::fieldAtIndex(*volume, a)) /
                      (2.0 * d);
      }
      // voxels of +-3,000: third derivatives up to 1e4 a voxel cubed, times d²/6
      const Vec3 gradient = grid.spacing.asDiagonal() *
                            (grid.direction.transpose() * field.sample(u).gradient_W).eval();
      ASSERT_LT((gradient - slope).norm(), 1e-3);
      ASSERT_EQ(field.splineGradient(u), field.sample(u).gradient_W);
      falling += (u.minCoeff() < 0.0);
    }
  }
  EXPECT_GT(falling, 300);
}

TEST(SplineField, PyramidStatesOnlyBoundsThatHold) {
  Random random{4};
  int empty = 0, sloped = 0, k = 0;
  const auto check = [&](const Volume& made_volume) {
    const auto volume = made::shared(made_volume);
    const Grid& grid = volume->grid;
    const ScalarField field{volume, FieldKind::CubicSpline};
    const double range = volume->greatest - volume->least;
    for (int n = 0; n < made::trials(1000); ++n) {
      Vec3 u = around(grid, 8.0, random);
      // often at the very edge of a block of four cells, from where the ball reaches farthest
      for (int axis = 0; axis < 3; ++axis)
        if (random.below(2) == 0)
          u[axis] = 4.0 * std::floor(u[axis] / 4.0) - 1.0 + (random.below(2) == 0 ? 1e-3 : -1e-3);
      const Vec3 p_W = grid.worldOf(u);
      const double s = volume->least + std::fmax(range, 1.0) * random.in(0.01, 1.01);
      const MaxPyramid::Bound bound = field.pyramid().bound(u, s);
      const double here = spline_reference::fieldAtIndex(*volume, u);
      for (int i = 0; i < 12; ++i) {
        // half of them as far as the ball goes along an axis
        const bool far = i % 2 == 0;
        const double distance = bound.radius * (far ? 1.0 : std::cbrt(random.in(0.0, 1.0)));
        const Vec3 along = grid.direction.col(i / 2 % 3) * (random.below(2) == 0 ? 1.0 : -1.0);
        const Vec3 q_W = p_W + distance * (far ? along : random.direction());
        const double there = spline_reference::fieldAt(*volume, q_W);
        if (bound.lipschitz == 0.0)
          ASSERT_LT(there, s) << u.transpose();
        else
          ASSERT_LE(std::abs(there - here), bound.lipschitz * distance + 1e-9 * range);
      }
      ++(bound.lipschitz == 0.0 ? empty : sloped);
    }
  };
  for (const ScalarType type : made::kTypes) {
    SCOPED_TRACE(haptics::nameOf(type));
    check(made::randomVolume(made::oddGrid(k, {17 + k, 9, 30 - k}, random), type, random));
    // single bright and dark voxels: what lies one voxel beyond a block matters
    check(datasets::filled(made::oddGrid(k, {21, 18 + k, 26}, random), type, [&](auto, auto, auto) {
      return random.below(400) == 0 ? 120.0 : random.below(400) == 0 ? 10.0 : 20.0;
    }));
    ++k;
  }
  for (const std::array<std::int64_t, 3> dims :
       {std::array<std::int64_t, 3>{1, 1, 1}, {1, 40, 1}, {2, 2, 90}, {5, 4, 3}})
    check(datasets::filled(made::oddGrid(1, dims, random), ScalarType::Int16,
                           [&](auto, auto, auto) { return random.in(-9.0, 900.0); }));
  EXPECT_GT(sloped, made::trials(5000));
  EXPECT_GT(empty, made::trials(2000));
}

/// Along an axis through u, as far as the bound goes: nothing it says may be wrong.
void checkAlong(const ScalarField& field, const Vec3& u, int axis, double s, int& far) {
  const MaxPyramid::Bound bound = field.pyramid().bound(u, s);
  const double here = field.value(u);
  for (const double sign : {-1.0, 1.0})
    for (int i = 1; i <= 40; ++i) {
      const double distance = bound.radius * i / 40.0;
      const double there = field.value(u + sign * distance / h * Vec3::Unit(axis));
      if (bound.lipschitz == 0.0)
        ASSERT_LT(there, s) << u.transpose() << " along " << sign << " of axis " << axis;
      else
        ASSERT_LE(std::abs(there - here), bound.lipschitz * distance + 1e-6) << u.transpose();
    }
  far += bound.lipschitz == 0.0;
}

// a spline's cell is a mean of voxels one beyond it: of a block, and of the blocks about it
TEST(SplineField, PyramidSeesAVoxelThatReachesIntoABlockFromBeyondIt) {
  int far = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int bright = 12; bright < 20; ++bright) {
      const auto volume = made::shared(datasets::filled(
          datasets::centredGrid(32, h), ScalarType::Int16, [&](auto i, auto j, auto k) {
            const std::int64_t at[3] = {i, j, k};
            const auto a = static_cast<std::size_t>(axis);
            return at[a] == bright && at[(a + 1) % 3] == 15 && at[(a + 2) % 3] == 15 ? 1000. : 0.;
          }));
      const ScalarField field{volume, FieldKind::CubicSpline};
      for (int block = 1; block < 8; ++block)
        for (const double off : {-1e-3, 1e-3}) {
          Vec3 u = Vec3::Constant(15.0);
          u[axis] = 4.0 * block - 1.0 + off;
          checkAlong(field, u, axis, 0.01, far);
        }
    }
  EXPECT_GT(far, 50);
}

// the fall to the background is a slope, though all voxels beside the face are alike
TEST(SplineField, PyramidSeesTheFallAtAFace) {
  const auto volume = made::shared(
      datasets::filled(datasets::centredGrid(33, h), ScalarType::Int16,
                       [](auto i, auto j, auto k) { return i + j + k == 48 ? 0.0 : 1000.0; }));
  const ScalarField field{volume, FieldKind::CubicSpline};
  int far = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double place : {-1.5, -0.5, 0.5, 3.5, 28.5, 31.5, 32.5, 33.5}) {
      Vec3 u = Vec3::Constant(3.5);
      u[axis] = place;
      checkAlong(field, u, axis, 900.0, far);
    }
}

// SplineField tests hold the field itself to its definition; here it judges the crossings
TEST(FirstReach, OfBothKindsIsTheFirstThatDenseSamplesSee) {
  Random random{5};
  for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline}) {
    const auto volume = made::shared(datasets::whiteNoise(datasets::centredGrid(16, h), 6));
    const ScalarField field{volume, kind};
    int met = 0, passed = 0;
    for (int n = 0; n < made::trials(4000); ++n) {
      const Vec3 a = random.box(9.0) + Vec3::Constant(7.5);
      const Vec3 b = a + random.in(0.01, 4.0) * random.direction();
      const double level = random.in(0.1, 1.0) * (kind == FieldKind::Trilinear ? 150.0 : 60.0);
      const double tolerance = 1e-6;
      const auto value = [&](double t) { return field.value(a + t * (b - a)); };
      if (value(0.0) >= level) continue;
      Budget budget = unlimited();
      const double reach = field.firstReach(a, b, level, tolerance, budget);
      EXPECT_GT(budget.spent(), 0);
      double first = 2.0;
      constexpr int kSamples = 1000;
      for (int i = 0; i <= kSamples && first > 1.0; ++i)
        if (value(double(i) / kSamples) >= level) first = double(i) / kSamples;
      if (first <= 1.0) {
        ASSERT_LE(reach, first + 1e-9);
        ++met;
      }
      if (reach <= 1.0) {
        // what was met is there: within the tolerance, at the noise's steepest 600 a voxel
        double top = value(std::min(1.0, reach + tolerance));
        top = std::max(top, value(reach));
        ASSERT_GE(top, level - 600.0 * 4.0 * tolerance - 1e-6);
      } else {
        ++passed;
      }
    }
    EXPECT_GT(met, made::trials(400));
    EXPECT_GT(passed, made::trials(500));
  }
}

}  // namespace
