// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/field/isosurface.h"
#include "haptics/field/scalar_field.h"
#include "haptics/proxy/tick.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/simulation/hand.h"
#include "haptics/simulation/penetration.h"
#include "haptics/smoothing.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

namespace {

using datasets::Random;
using haptics::Budget;
using haptics::FieldKind;
using haptics::Grid;
using haptics::Isosurface;
using haptics::Pose;
using haptics::ScalarField;
using haptics::Vec3;
using haptics::Volume;
using haptics::VoxelBox;
using made::at;
using millimetre::h;
using millimetre::unlimited;
namespace lanes = haptics::lanes;

/// A volume of its own from the voxels of the box, with the background of the whole.
Volume cutOut(const Volume& whole, const VoxelBox& box) {
  Grid grid = whole.grid;
  Vec3 first;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    grid.dims[a] = box.end[a] - box.first[a];
    first[axis] = double(box.first[a]);
  }
  grid.origin = whole.grid.worldOf(first);
  Volume part = datasets::filled(grid, whole.type, [&](auto i, auto j, auto k) {
    return evaluator::voxelAt(whole, {i + box.first[0], j + box.first[1], k + box.first[2]});
  });
  part.least = whole.least;
  part.greatest = whole.greatest;
  return part;
}

Vec3 firstOf(const VoxelBox& box) {
  return {double(box.first[0]), double(box.first[1]), double(box.first[2])};
}

/// Within three voxels of the box, often on its faces; a whole number of 2^-20 voxels, so that the
/// same place in the cut volume is the same to the bit.
Vec3 placeAbout(const VoxelBox& box, Random& random) {
  Vec3 u;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    u[axis] = random.in(double(box.first[a]) - 3.0, double(box.end[a]) + 2.0);
    if (random.below(6) == 0) u[axis] = std::round(u[axis]);
    u[axis] = std::ldexp(std::round(std::ldexp(u[axis], 20)), -20);
  }
  return u;
}

/// Volumes of every type with a crop, as the box of the n-th test.
template <class F>
void forCrops(unsigned seed, F&& f) {
  Random random{seed};
  int k = 0;
  for (const haptics::ScalarType type : made::kTypes)
    for (int n = 0; n < 6; ++n) {
      const Grid grid = made::oddGrid(k++, {21, 18, 24}, random);
      const Volume whole = made::randomVolume(grid, type, random);
      const VoxelBox box =
          n == 0 ? VoxelBox{{5, 4, 6}, {16, 15, 18}} : made::randomBox(grid, random);
      SCOPED_TRACE(testing::Message() << haptics::nameOf(type) << " from " << box.first[0] << ' '
                                      << box.first[1] << ' ' << box.first[2] << " to " << box.end[0]
                                      << ' ' << box.end[1] << ' ' << box.end[2]);
      f(made::shared(made::cropped(whole, box)), made::shared(cutOut(whole, box)), box, random);
      if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(Crop, HasTheFieldOfAVolumeThatWasCut) {
  int within = 0, falling = 0, beyond = 0;
  forCrops(1, [&](auto cropped, auto was_cut, const VoxelBox& box, Random& random) {
    for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline}) {
      const ScalarField field{cropped, kind}, other{was_cut, kind};
      for (int n = 0; n < made::trials(400); ++n) {
        const Vec3 u = placeAbout(box, random), v = u - firstOf(box);
        const double value = field.value(u);
        ASSERT_EQ(value, other.value(v)) << u.transpose();
        const haptics::FieldSample one = field.sample(u), two = other.sample(v);
        ASSERT_EQ(one.value, two.value);
        ASSERT_EQ(one.gradient_W, two.gradient_W);
        ASSERT_EQ(field.centralGradient(u), other.centralGradient(v));
        ASSERT_EQ(field.splineGradient(u), other.splineGradient(v));
        double past = -1.0;
        for (int axis = 0; axis < 3; ++axis) {
          const auto a = static_cast<std::size_t>(axis);
          past = std::max({past, double(box.first[a]) - u[axis], u[axis] - double(box.end[a] - 1)});
        }
        ++(past <= 0.0 ? within : past < 1.0 ? falling : beyond);
        if (past >= 1.0) {
          ASSERT_EQ(value, cropped->least);
        }
      }
    }
  });
  EXPECT_GT(within, made::trials(3000));
  EXPECT_GT(falling, made::trials(3000));
  EXPECT_GT(beyond, made::trials(3000));
}

TEST(Crop, IsMetByAChordWhereAVolumeThatWasCutIs) {
  constexpr double kTolerance = 1e-6;
  int met = 0, passed = 0;
  forCrops(2, [&](auto cropped, auto was_cut, const VoxelBox& box, Random& random) {
    const double level = cropped->least + 0.7 * (cropped->greatest - cropped->least);
    for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline}) {
      const ScalarField field{cropped, kind}, other{was_cut, kind};
      for (int n = 0; n < made::trials(100); ++n) {
        const Vec3 a = placeAbout(box, random), b = placeAbout(box, random);
        Budget one = unlimited(), two = unlimited();
        const double reach = field.firstReach(a, b, level, kTolerance, one);
        ASSERT_NEAR(reach,
                    other.firstReach(a - firstOf(box), b - firstOf(box), level, kTolerance, two),
                    2.0 * kTolerance);
        ++(reach <= 1.0 ? met : passed);
      }
    }
  });
  EXPECT_GT(met, made::trials(500));
  EXPECT_GT(passed, made::trials(500));
}

void setPlace(const Vec3& p, int l, lanes::Places& u) {
  u.x[l] = p.x();
  u.y[l] = p.y();
  u.z[l] = p.z();
}

// lanes_test compares the lanes with the scalar code; here with what was cut
TEST(Crop, IsSurveyedAsAVolumeThatWasCut) {
  int looked = 0;
  forCrops(3, [&](auto cropped, auto was_cut, const VoxelBox& box, Random& random) {
    const ScalarField field{cropped}, other{was_cut};
    const double s = cropped->least + 0.8 * (cropped->greatest - cropped->least);
    const Isosurface solid{field, s};
    for (int n = 0; n < made::trials(60); ++n) {
      lanes::Places u{}, v{};
      for (int l = 0; l < lanes::kLanes; ++l) {
        const Vec3 p = placeAbout(box, random);
        setPlace(p, l, u);
        setPlace(p - firstOf(box), l, v);
      }
      lanes::Survey found;
      solid.survey(u, lanes::kLanes, found);
      lanes::Slopes slopes, expected;
      field.slopes(u, lanes::kLanes, true, slopes);
      other.slopes(v, lanes::kLanes, true, expected);
      for (int l = 0; l < lanes::kLanes; ++l) {
        ASSERT_EQ(slopes.value[l], expected.value[l]);
        ASSERT_EQ(slopes.exact.x[l], expected.exact.x[l]);
        ASSERT_EQ(slopes.exact.y[l], expected.exact.y[l]);
        ASSERT_EQ(slopes.exact.z[l], expected.exact.z[l]);
        ASSERT_EQ(slopes.central.z[l], expected.central.z[l]);
        if (found.empty >> l & 1) {
          ASSERT_LT(expected.value[l], s);
        } else {
          ASSERT_EQ(found.value[l], expected.value[l]);
          ++looked;
        }
      }
    }
  });
  EXPECT_GT(looked, made::trials(10'000));
}

// the spline's bounds: lanes and pyramid_test look at the trilinear field
TEST(Crop, HasBoundsThatHoldForTheSpline) {
  int empty = 0, sloped = 0;
  forCrops(4, [&](auto cropped, auto, const VoxelBox& box, Random& random) {
    const ScalarField field{cropped, FieldKind::CubicSpline};
    const Grid& grid = cropped->grid;
    const double range = cropped->greatest - cropped->least;
    for (int n = 0; n < made::trials(150); ++n) {
      const Vec3 p_W = grid.worldOf(placeAbout(box, random));
      const Vec3 u = field.indexOf(p_W);
      const double s = cropped->least + range * random.in(0.3, 1.1), here = field.value(u);
      const haptics::MaxPyramid::Bound bound = field.pyramid().bound(u, s);
      for (int i = 0; i < 12; ++i) {
        const double distance = bound.radius * std::cbrt(random.in(0.0, 1.0));
        const double there = field.value(field.indexOf(p_W + distance * random.direction()));
        if (bound.lipschitz == 0.0)
          ASSERT_LT(there, s);
        else
          ASSERT_LE(std::abs(there - here), bound.lipschitz * distance + 1e-9 * range);
      }
      ++(bound.lipschitz == 0.0 ? empty : sloped);
    }
  });
  EXPECT_GT(empty, made::trials(300));
  EXPECT_GT(sloped, made::trials(2000));
}

/// The solid below z = 0 of 40^3 voxels, without its right half: those above i = 19.
Volume halfOfTheFloor() {
  return made::cropped(
      datasets::solid(datasets::centredGrid(40, h), [](const Vec3& p) { return p.z(); }),
      {{0, 0, 0}, {20, 40, 40}});
}

// the cut face, at x = -0.5 mm, is as solid as that of a scan that ends there
TEST(Crop, LetsNoToolIntoItsCutFace) {
  constexpr double kRadius = 3e-3;
  for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline}) {
    const auto scene = haptics::makeScene(made::shared(halfOfTheFloor()),
                                          made::tool(datasets::ballPoints(300, kRadius)), {kind})
                           .value();
    // within what the whole floor would fill
    haptics::Proxy proxy{*scene, at(8e-3, 0.0, -10e-3)};
    double farthest = 1.0;
    for (int tick = 0; tick < 400; ++tick) {
      const Vec3 hand{8e-3 - 4e-5 * tick, 2e-3 * std::sin(0.05 * tick), -10e-3};
      Budget budget = Budget::counted(haptics::kTickWork);
      haptics::tick(*scene, datasets::kSolidIso, {.stiffness = 1000.0}, at(hand), proxy, budget,
                    1e-3);
      const Vec3 p = proxy.X_WP.translation();
      ASSERT_EQ(haptics::penetration(*scene, datasets::kSolidIso, proxy.X_WP), 0.0) << tick;
      if (hand.x() > kRadius + 0.6e-3) {
        ASSERT_LT((p - hand).norm(), 1e-9) << tick;  // nothing is left there
      }
      farthest = std::min(farthest, p.x());
    }
    // the face falls from 13,000 to the background within 1 mm: 1000 is near its foot
    EXPECT_GT(farthest, kRadius - 0.5e-3);
    EXPECT_LT(farthest, kRadius + 0.6e-3);
  }
}

TEST(Crop, IsFreeForASearchAndNoDepthIsCountedThere) {
  const auto scene = haptics::makeScene(made::shared(halfOfTheFloor()), made::point()).value();
  const auto found = haptics::legalPoseNear(*scene, datasets::kSolidIso, at(-1.5e-3, 0, -12e-3));
  ASSERT_TRUE(found);
  EXPECT_LT((found->translation() - Vec3{-1.5e-3, 0, -12e-3}).norm(), 4e-3);
  EXPECT_EQ(haptics::penetration(*scene, datasets::kSolidIso, at(3e-3, 0, -12e-3)), 0.0);
  // on a plateau: the nearest voxel outside is the first beyond the face
  EXPECT_NEAR(haptics::penetration(*scene, datasets::kSolidIso, at(-4.5e-3, 0.5e-3, -11.5e-3)),
              5e-3, 1e-9);
}

TEST(Crop, IsWhereASimulatedHandAims) {
  const Vec3 left{-9e-3, 0, 0}, right{9e-3, 0, 0};
  const Volume whole = datasets::solid(datasets::centredGrid(40, h), [&](const Vec3& p) {
    return std::min((p - left).norm(), (p - right).norm()) - 5e-3;
  });
  for (const bool keep_left : {true, false}) {
    const VoxelBox box =
        keep_left ? VoxelBox{{0, 0, 0}, {20, 40, 40}} : VoxelBox{{20, 0, 0}, {40, 40, 40}};
    const auto scene =
        haptics::makeScene(made::shared(made::cropped(whole, box)), made::point()).value();
    const auto hand =
        haptics::Hand::aimed(haptics::HandMotion::Tap, *scene, datasets::kSolidIso, 1e-3, 1);
    ASSERT_TRUE(hand);
    double nearest = 1.0;
    for (double t = 0.0; t < 2.0; t += 0.01)
      nearest = std::min(nearest, (hand->at(t).translation() - (keep_left ? left : right)).norm());
    EXPECT_LT(nearest, 6e-3);
  }
  const auto scene =
      haptics::makeScene(made::shared(made::cropped(whole, {{18, 0, 0}, {22, 40, 40}})),
                         made::point())
          .value();
  EXPECT_FALSE(
      haptics::Hand::aimed(haptics::HandMotion::Tap, *scene, datasets::kSolidIso, 1e-3, 1));
}

TEST(Crop, IsAllThatSmoothingIsJudgedBy) {
  Random random{5};
  const Grid grid = datasets::centredGrid(30, h);
  const Volume whole = made::randomVolume(grid, haptics::ScalarType::Int16, random);
  const VoxelBox box{{4, 6, 8}, {19, 24, 29}};
  const auto one = haptics::smoothingEffect(made::cropped(whole, box), 3000.0);
  const auto other = haptics::smoothingEffect(cutOut(whole, box), 3000.0);
  EXPECT_EQ(one.erased, other.erased);
  EXPECT_EQ(one.gained, other.gained);
  EXPECT_NE(one.erased, haptics::smoothingEffect(whole, 3000.0).erased);
}

}  // namespace
