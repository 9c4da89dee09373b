// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/sweep.h"

#include <gtest/gtest.h>

#include <iostream>

#include "app/study/arcs/arcs.h"
#include "app/study/arcs/one_point.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

namespace {

namespace arcs = study::arcs;
using arcs::Arc;
using arcs::Crossing;
using datasets::Random;
using haptics::Grid;
using haptics::Isosurface;
using haptics::ScalarField;
using haptics::Tolerances;
using haptics::Twist;
using haptics::Vec3;
using millimetre::h;

Crossing cross(const Isosurface& solid, const Arc& path) {
  return arcs::crossed(solid, path, Tolerances{h});
}

TEST(FirstCrossing, OfAPlaneIsWhereTheClosedFormSays) {
  // F falls by 4,000 a voxel with height: exact in trilinear samples
  const auto volume = made::shared(datasets::sampledFloat(
      datasets::centredGrid(60, h), [](const Vec3& p) { return 1000.0 - 4e6 * p.z(); }));
  const ScalarField field{volume};
  const Isosurface solid{field, 1000.0};
  Random random{31};
  int met = 0, missed = 0;
  for (int n = 0; n < 2000; ++n) {
    const Vec3 c{random.in(-5e-3, 5e-3), random.in(-5e-3, 5e-3), random.in(1e-4, 5e-3)};
    const Arc path{c, Vec3::Zero(), {5e-3 * random.direction(), Vec3::Zero()}};
    const double fall = c.z() - path.at(1.0).z();
    const Crossing crossing = cross(solid, path);
    if (fall < c.z()) {
      // not in reach: it may stop short only within the rounding margin
      EXPECT_TRUE(!crossing.met || fall > c.z() - 1e-6 * h);
      missed += !crossing.met;
    } else {
      ASSERT_TRUE(crossing.met);
      const double height = path.at(crossing.time).z();
      EXPECT_GE(height, 0.0);       // never later
      EXPECT_LE(height, 1e-4 * h);  // and early by the root's 1e-5 voxel and the margin
      ++met;
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(missed, 300);
}

// the point on a turning arm comes down on the plane: z0 + r sin(a t) = 0
TEST(FirstCrossing, OfAnArcWithAPlaneIsWhereTheClosedFormSays) {
  const auto volume = made::shared(datasets::sampledFloat(
      datasets::centredGrid(80, h), [](const Vec3& p) { return 1000.0 - 4e6 * p.z(); }));
  const ScalarField field{volume};
  const Isosurface solid{field, 1000.0};
  Random random{32};
  for (int n = 0; n < 500; ++n) {
    const double height = random.in(0.5e-3, 8e-3), arm = random.in(1.1, 2.0) * height;
    const double angle = 1.2 + random.in(0.0, 0.5);
    if (height / arm > std::sin(std::min(angle, M_PI / 2))) continue;
    const Arc path{{0, 0, height}, {arm, 0, 0}, {Vec3::Zero(), {0, angle, 0}}};
    const Crossing crossing = cross(solid, path);
    ASSERT_TRUE(crossing.met);
    const double z = path.at(crossing.time).z();
    EXPECT_GE(z, 0.0);
    EXPECT_LE(z, 5e-4 * h);  // four times the sagitta a chord may have, for guard and chord
  }
}

TEST(FirstCrossing, OfASphereIsWhereTheClosedFormSays) {
  const double radius = 12e-3;
  const auto volume = made::shared(datasets::solid(
      datasets::centredGrid(40, h), [&](const Vec3& p) { return p.norm() - radius; }));
  const ScalarField field{volume};
  const Isosurface solid{field, datasets::kSolidIso};
  Random random{33};
  int met = 0, passed = 0;
  for (int n = 0; n < 2000; ++n) {
    const Vec3 from = 18e-3 * random.direction();
    const Vec3 to = 15e-3 * random.direction();
    const Vec3 way = to - from;
    const Arc path{from, Vec3::Zero(), {way, Vec3::Zero()}};
    // |from + t way| = radius
    const double a = way.squaredNorm(), b = from.dot(way), c = from.squaredNorm() - radius * radius;
    const double inner = b * b - a * c;
    const double nearest = (from - way * (b / a)).norm();
    const Crossing crossing = cross(solid, path);
    // the trilinear surface lies within h² / 8 r · 3 = 0.03 voxel of the sphere
    if (inner < 0.0 && nearest > radius + 0.04 * h) {
      EXPECT_FALSE(crossing.met);
      ++passed;
    } else if (nearest < radius - 0.5 * h && -b / a > 0.0 && -b / a < 1.0) {
      ASSERT_TRUE(crossing.met);
      EXPECT_NEAR(path.at(crossing.time).norm(), radius, 0.04 * h);
      EXPECT_LT(crossing.time, -b / a);  // where it enters, not where it leaves
      ++met;
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(passed, 100);
}

/// Prints and judges: nothing missed, nothing late, and of both kinds enough.
void expectExact(const char* what, const arcs::Tally& tally, long least_met, long most_early) {
  std::cout << what << ": " << tally.arcs << " arcs, " << tally.met << " met, latest "
            << tally.latest << " voxel, " << tally.early << " early\n";
  EXPECT_EQ(tally.missed, 0);
  EXPECT_EQ(tally.late, 0);
  EXPECT_GT(tally.met, least_met);
  EXPECT_LT(tally.met, tally.arcs);
  // a point that starts within the guard may be held where it starts (it goes no deeper)
  EXPECT_LE(tally.early, most_early);
}

// by the ten thousand here; the study of accuracy shoots two hundred thousand
TEST(FirstCrossing, MissesNothingInWhiteNoise) {
  Random random{34};
  const arcs::Tally tally = arcs::shootPoints(arcs::noise(35), made::trials(20'000), random);
  expectExact("noise", tally, tally.arcs / 10, tally.met / 100);
}

TEST(FirstCrossing, MissesNoPlateDownToAFiftiethOfAVoxel) {
  Random random{36};
  arcs::Tally tally;
  for (int k = 0; k < 4; ++k)
    tally += arcs::shootPoints(arcs::slantedPlate(random), made::trials(2'000), random);
  tally += arcs::shootPoints(arcs::uprightPlates(), made::trials(8'000), random);
  expectExact("plates", tally, tally.arcs / 20, tally.met / 100);
}

TEST(FirstCrossing, MissesNothingOfAGyroid) {
  Random random{39};
  const arcs::Tally tally = arcs::shootPoints(arcs::gyroid(), made::trials(10'000), random);
  expectExact("gyroid", tally, tally.arcs / 10, tally.met / 100);
}

TEST(FirstCrossing, OfASplineMissesNothingInWhiteNoise) {
  Random random{7};
  // a spline leaves noise of 100 some 33
  const arcs::Target target{"noise",
                            datasets::whiteNoise(datasets::centredGrid(40, h), 8),
                            {15.0, 33.0, 50.0, 80.0},
                            18 * h,
                            500,
                            haptics::FieldKind::CubicSpline};
  const arcs::Tally tally = arcs::shootPoints(target, made::trials(4'000), random);
  expectExact("noise, spline", tally, tally.arcs / 10, std::max(1L, tally.met / 100));
}

// one voxel of plate, seen near the peak that the spline leaves of it
TEST(FirstCrossing, OfASplineMissesNoThinPlate) {
  Random random{9};
  const double peak = 1000.0 * 2.0 / 3.0;
  const arcs::Target target{
      "plates",
      datasets::filled(datasets::centredGrid(40, h), haptics::ScalarType::Int16,
                       [](auto i, auto, auto) { return i % 8 == 4 ? 1000.0 : 0.0; }),
      {0.8 * peak, 0.95 * peak, 0.99 * peak, 0.9999 * peak},
      15 * h,
      1000,
      haptics::FieldKind::CubicSpline};
  const arcs::Tally tally = arcs::shootPoints(target, made::trials(3'000), random);
  expectExact("plates, spline", tally, tally.arcs / 20, tally.arcs);
}

TEST(Sweep, OfAWholeShellMissesNothing) {
  Random random{40};
  for (const arcs::Target& target : {arcs::noise(41), arcs::uprightPlates(), arcs::gyroid()}) {
    const arcs::Tally tally = arcs::shootShells(target, made::trials(1'000), random);
    expectExact(target.name.c_str(), tally, tally.arcs / 10, tally.met / 100);
  }
}

TEST(FirstCrossing, ThatTheBudgetCutsIsFoundAllTheSame) {
  Random random{37};
  const auto volume = datasets::whiteNoise(datasets::centredGrid(30, h), 38);
  const ScalarField field{made::shared(volume)};
  const Isosurface solid{field, 150.0};
  int cut = 0, met = 0;
  for (int n = 0; n < 2000; ++n) {
    const Arc path{random.box(10e-3), random.box(5e-3), {random.box(8e-3), random.box(0.3)}};
    if (solid.inside(path.at(0.0))) continue;
    const Crossing whole = cross(solid, path);
    const Crossing parts = arcs::crossed(solid, path, Tolerances{h}, 2 + random.below(12));
    EXPECT_EQ(parts.time, whole.time);
    EXPECT_EQ(parts.met, whole.met);
    cut += parts.cuts > 0;
    met += whole.met;
  }
  EXPECT_GT(cut, 200);
  EXPECT_GT(met, 100);
}

}  // namespace
