// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/field/scalar_field.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::Cell;
using haptics::FieldKind;
using haptics::Grid;
using haptics::Mat3;
using haptics::ScalarField;
using haptics::ScalarType;
using haptics::Vec3;

// what legality keeps away from the isovalue must cover how far two evaluations differ
TEST(ScalarField, IsTheTrilinearFieldOfItsVoxelsWhateverTheirTypeAndFrame) {
  Random random{1};
  int within = 0, falling = 0, beyond = 0, k = 0;
  for (const ScalarType type : made::kTypes) {
    SCOPED_TRACE(haptics::nameOf(type));
    const Grid grid = made::oddGrid(k++, {9, 7, 5}, random);
    const auto volume = made::shared(made::randomVolume(grid, type, random));
    const ScalarField field{volume};
    for (int n = 0; n < made::trials(4000); ++n) {
      const Vec3 u{random.in(-3.0, 11.0), random.in(-3.0, 9.0), random.in(-3.0, 7.0)};
      const Vec3 p_W = grid.worldOf(u);
      ASSERT_NEAR(field.value(field.indexOf(p_W)), evaluator::fieldAt(*volume, p_W),
                  field.roundingMargin());
      const double low = u.minCoeff();
      const double past = std::max({u.x() - 8.0, u.y() - 6.0, u.z() - 4.0});
      if (low >= 0.0 && past <= 0.0)
        ++within;
      else if (low > -1.0 && past < 1.0)
        ++falling;
      else
        ++beyond;
    }
  }
  EXPECT_GT(within, made::trials(3000));
  EXPECT_GT(falling, made::trials(3000));
  EXPECT_GT(beyond, made::trials(3000));
}

TEST(ScalarField, GivesAVoxelItsValueAndTheBackgroundBeyondTheGridToTheBit) {
  Random random{2};
  const Grid grid = datasets::centredGrid(6, 1e-3);
  const auto volume = made::shared(made::randomVolume(grid, ScalarType::Int16, random));
  const ScalarField field{volume};
  for (int k = -2; k < 8; ++k)
    for (int j = -2; j < 8; ++j)
      for (int i = -2; i < 8; ++i)
        EXPECT_EQ(field.value({double(i), double(j), double(k)}),
                  evaluator::voxelAt(*volume, {i, j, k}));
  for (const double far : {1.0 + 6.0, 1e3, 1e12, 1e300})
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        Vec3 u{2.5, 2.5, 2.5};
        u[axis] = sign * far;
        EXPECT_EQ(field.value(u), volume->least);
      }
}

TEST(ScalarField, CellGradientIsTheSlopeOfTheCell) {
  Random random{3};
  for (int k = 0; k < 6; ++k) {
    const Grid grid = made::oddGrid(k, {6, 6, 6}, random);
    const auto volume = made::shared(made::randomVolume(grid, ScalarType::Float32, random));
    const ScalarField field{volume};
    for (int n = 0; n < 300; ++n) {
      Vec3 u{random.in(-1.0, 6.0), random.in(-1.0, 6.0), random.in(-1.0, 6.0)};
      const Vec3 g_W = field.worldGradient(field.cellAround(u).gradient(u));
      const Vec3 p_W = grid.worldOf(u);
      // trilinear: relative agreement is bounded by the rounding of 8 corners only
      ASSERT_NEAR(g_W.norm(), evaluator::slopeAt(*volume, p_W), 1e-9 * g_W.norm() + 1e-6);
      // the field is linear along each axis of a cell: a difference within it is exact
      const Vec3 step_W = grid.direction.col(n % 3) * grid.spacing[n % 3];
      const double part = u[n % 3] - std::floor(u[n % 3]);
      const double go = part < 0.5 ? 0.4 : -0.4;
      const double rise =
          evaluator::fieldAt(*volume, p_W + go * step_W) - evaluator::fieldAt(*volume, p_W);
      ASSERT_NEAR(go * step_W.dot(g_W), rise, 1e-8 * 6000.0);  // of the range of 6,000
    }
  }
}

// n would point wrong on anisotropic voxels without the division by 2 delta on each axis
TEST(ScalarField, EveryGradientOfALinearFieldIsItsSlopeInAnyFrame) {
  Random random{4};
  for (int k = 0; k < 12; ++k) {
    const Grid grid = made::oddGrid(k, {12, 12, 12}, random);
    const Vec3 slope_W = 1e5 * random.direction();  // per m
    const auto volume = made::shared(
        datasets::sampledFloat(grid, [&](const Vec3& p) { return slope_W.dot(p - grid.origin); }));
    for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline}) {
      const ScalarField field{volume, kind};
      for (int n = 0; n < 50; ++n) {
        const Vec3 u{random.in(2.0, 9.0), random.in(2.0, 9.0), random.in(2.0, 9.0)};
        // voxels are floats: 24 bits of values up to 1e5 · 30 mm, over 2 · 0.3 mm
        EXPECT_LT((field.centralGradient(u) - slope_W).norm(), 2.0);
        EXPECT_LT((field.splineGradient(u) - slope_W).norm(), 2.0);
        EXPECT_LT((field.sample(u).gradient_W - slope_W).norm(), 4.0);
      }
    }
  }
}

TEST(ScalarField, IsTheSameTenMetresAway) {
  Random random{5};
  Grid near = datasets::centredGrid(8, 1.5e-4);
  Grid far = near;
  far.origin += Vec3{10.0, -10.0, 10.0};
  Random again{6}, same{6};
  const ScalarField here{made::shared(made::randomVolume(near, ScalarType::Int16, again))};
  const ScalarField there{made::shared(made::randomVolume(far, ScalarType::Int16, same))};
  for (int n = 0; n < 2000; ++n) {
    const Vec3 p{random.box(7e-4)};
    EXPECT_NEAR(here.value(here.indexOf(p)),
                there.value(there.indexOf(p + far.origin - near.origin)), here.roundingMargin());
  }
}

}  // namespace
