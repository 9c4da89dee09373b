// SPDX-License-Identifier: BSD-3-Clause
// Structures that are solid or not there: where their walls lie, what stays as it was, and what is
// built over them.
#include "datasets/edits/walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "app/study/arcs/arcs.h"
#include "app/study/reference/evaluator.h"
#include "datasets/edits/edit_history.h"
#include "datasets/phantoms/making.h"
#include "haptics/carving/wall.h"
#include "haptics/field/scalar_field.h"
#include "haptics/scene/scene.h"
#include "tests/support/made.h"
#include "tests/support/made_distances.h"
#include "tests/support/millimetre.h"

namespace walls_tests {
namespace {

using namespace datasets;
using namespace haptics;
using datasets::Random;
using SignedDistance = std::function<double(const Vec3& p_W)>;

constexpr double kMost = 0.020;  // m, beyond which distances are not told here
constexpr double kIsovalue = 300.0, kAir = -1024.0;

/// A scan of one matter with grain; one voxel is air, and one the greatest.
std::shared_ptr<const Volume> matter(const Grid& grid, double value, double grain, Random& random,
                                     ScalarType type = ScalarType::Int16) {
  const bool bytes = type == ScalarType::UInt8;
  return made::shared(filled(grid, type, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    if (i + j + k == 0) return bytes ? 0.0 : kAir;
    if (i + j + k == 1) return bytes ? 255.0 : 3071.0;
    return std::max(bytes ? 0.0 : kAir, value + random.in(-grain, grain) * std::sqrt(3.0));
  }));
}

Vec3 middleOf(const Grid& grid) {
  return grid.worldOf({0.5 * double(grid.dims[0] - 1), 0.5 * double(grid.dims[1] - 1),
                       0.5 * double(grid.dims[2] - 1)});
}

StructureWall wallOf(const Grid& grid, const SignedDistance& distance, bool solid,
                     std::uint8_t structure = 0) {
  // as maps do, it goes beyond the scan
  constexpr std::int64_t kBeyond = 4;
  Grid samples = grid;
  samples.origin = grid.worldOf(Vec3::Constant(-double(kBeyond)));
  for (std::int64_t& dim : samples.dims) dim += 2 * kBeyond;
  return {structure, solid, made::distanceMap(samples, distance, kMost)};
}

std::shared_ptr<const Volume> walledBy(const std::shared_ptr<const Volume>& volume,
                                       const std::vector<StructureWall>& walls,
                                       double isovalue = kIsovalue,
                                       const std::shared_ptr<const Volume>& previous = {}) {
  return walled(volume, walls, isovalue, previous).value();
}

double valueAt(const Volume& volume, std::int64_t i, std::int64_t j, std::int64_t k) {
  return evaluator::voxelAt(volume, {i, j, k});
}

template <class Each>
void eachVoxel(const Grid& grid, const Each& each) {
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i) each(i, j, k);
}

/// A ball, a cylinder, a plane: distance, and a place of its surface with the normal.
struct Shape {
  SignedDistance distance;
  std::function<Vec3(Random&)> place;
};
Shape shapeOf(int kind, const Vec3& middle, double size, Random& random) {
  const Vec3 axis = random.direction();
  switch (kind) {
    case 0:
      return {[=](const Vec3& p) { return (p - middle).norm() - size; },
              [=](Random& at) { return Vec3{middle + size * at.direction()}; }};
    case 1:
      return {
          [=](const Vec3& p) { return ((p - middle) - axis * axis.dot(p - middle)).norm() - size; },
          [=](Random& at) {
            const Vec3 out = axis.cross(at.direction()).normalized();
            return Vec3{middle + size * out + at.in(-0.3, 0.3) * size * axis};
          }};
    default:
      return {[=](const Vec3& p) { return axis.dot(p - middle); },
              [=](Random& at) {
                const Vec3 off = size * at.direction();
                return Vec3{middle + off - axis * axis.dot(off)};
              }};
  }
}

struct Errors {
  double mean = 0.0, worst = 0.0;   // longest sides of a voxel, outwards
  double turned = 0.0, most = 0.0;  // degrees: mean square, and worst
  int places = 0;
};

/// How the isosurface lies to a shape.
void measure(const Volume& volume, double isovalue, const Shape& shape, int places, bool solid,
             Random& random, Errors& errors) {
  const ScalarField field{made::shared(volume)};
  const Grid& grid = volume.grid;
  const double side = grid.spacing.maxCoeff();
  for (int n = 0; n < places; ++n) {
    const Vec3 at = shape.place(random);
    Vec3 out;
    for (int axis = 0; axis < 3; ++axis)
      out[axis] = shape.distance(at + 1e-7 * Vec3::Unit(axis)) -
                  shape.distance(at - 1e-7 * Vec3::Unit(axis));
    out.normalize();
    const Vec3 free = solid ? out : Vec3{-out};  // the side on which the tool is
    const auto within = [&](const Vec3& p_W) {
      const Vec3 u = grid.indexOf(p_W);
      for (int axis = 0; axis < 3; ++axis)
        if (!(u[axis] > 2.0 && u[axis] < double(grid.dims[std::size_t(axis)] - 3))) return false;
      return true;
    };
    const Vec3 from = at + 1.4 * side * free, to = at - 1.4 * side * free;
    if (!within(from) || !within(to)) continue;
    Budget budget = millimetre::unlimited();
    const double share =
        field.firstReach(grid.indexOf(from), grid.indexOf(to), isovalue, 1e-9, budget);
    ASSERT_LE(share, 1.0) << "no wall";
    ASSERT_GT(share, 0.0) << "the tool's side is not free";
    const double off = shape.distance(from + share * (to - from)) / side;
    errors.mean += off;
    errors.worst = std::max(errors.worst, std::abs(off));
    const Vec3 normal =
        -field.centralGradient(grid.indexOf(from + share * (to - from))).normalized();
    const double turn = std::acos(std::clamp(normal.dot(free), -1.0, 1.0)) * 180.0 / M_PI;
    errors.turned += turn * turn;
    errors.most = std::max(errors.most, turn);
    ++errors.places;
  }
}

/// Prints them and returns them as means.
Errors told(const std::string& name, Errors errors) {
  errors.mean /= errors.places;
  errors.turned = std::sqrt(errors.turned / errors.places);
  std::cout << name << ": " << errors.places << " places, mean " << errors.mean << ", worst "
            << errors.worst << " voxel, normals " << errors.turned << ", worst " << errors.most
            << " degrees\n";
  EXPECT_GT(errors.places, 500);
  return errors;
}

Errors errorsIn(double value, double grain, bool solid, ScalarType type = ScalarType::Int16,
                double isovalue = kIsovalue) {
  Random random{401};
  Errors errors;
  for (int k = 0; k < 12; ++k) {
    const Grid grid = k < 6 ? centredGrid(44, 5e-4) : made::oddGrid(k, {70, 50, 40}, random);
    const double side = grid.spacing.maxCoeff();
    const auto scan = matter(grid, value, grain, random, type);
    const Vec3 middle = middleOf(grid) + random.box(side);
    const Shape shape = shapeOf(k % 3, middle, (k < 6 ? 8.0 : 6.0) * side, random);
    const auto made = walledBy(scan, {wallOf(grid, shape.distance, solid)}, isovalue);
    measure(*made, isovalue, shape, 400, solid, random, errors);
  }
  return errors;
}

TEST(Walls, OfSolidStructuresLieWhereTheyDo) {
  for (const auto& [value, grain] : {std::pair{kAir, 0.0}, {-100.0, 40.0}, {40.0, 40.0}}) {
    const Errors errors =
        told("solid in " + std::to_string(int(value)) + ", grain " + std::to_string(int(grain)),
             errorsIn(value, grain, true));
    EXPECT_LT(std::abs(errors.mean), 0.03);
    EXPECT_LT(errors.worst, 0.1);
  }
  const Errors bytes = told("solid, 8 bits", errorsIn(20.0, 3.0, true, ScalarType::UInt8, 100.0));
  EXPECT_LT(bytes.worst, 0.1);
  // near the isovalue the scan itself reaches out between the voxels
  told("solid in 200", errorsIn(200.0, 20.0, true));
}

TEST(Walls, OfStructuresThatAreNotThereLieWhereTheyDo) {
  for (const auto& [value, grain] : {std::pair{2500.0, 0.0}, {1200.0, 40.0}}) {
    const Errors errors =
        told("not there in " + std::to_string(int(value)) + ", grain " + std::to_string(int(grain)),
             errorsIn(value, grain, false));
    EXPECT_LT(std::abs(errors.mean), 0.03);
    EXPECT_LT(errors.worst, 0.1);
    EXPECT_LT(errors.most, 6.0);
  }
  told("not there in 700", errorsIn(700.0, 40.0, false));
  const Errors bytes =
      told("not there, 8 bits", errorsIn(200.0, 5.0, false, ScalarType::UInt8, 100.0));
  EXPECT_LT(bytes.worst, 0.1);
}

TEST(Walls, MoveWithAnotherIsovalueAsStated) {
  Random random{402};
  const Grid grid = centredGrid(44, 5e-4);
  const auto scan = matter(grid, -1000.0, 0.0, random);
  for (const double other : {200.0, 450.0}) {
    Errors errors;
    for (int k = 0; k < 6; ++k) {
      const Shape shape = shapeOf(2, middleOf(grid), 0.006, random);
      const auto made = walledBy(scan, {wallOf(grid, shape.distance, true)});
      measure(*made, other, shape, 200, true, random, errors);
    }
    errors = told("solid, felt at " + std::to_string(int(other)), errors);
    EXPECT_NEAR(errors.mean, 3.0 * (kIsovalue - other) / (kIsovalue - kAir), 0.02);
    EXPECT_LT(errors.worst, 0.4);
  }
}

/// The distance map of a label map's voxels, as datasets/labels makes it: to the nearest midpoint
/// between a voxel that belongs to the shape and a neighbour that does not.
DistanceMap mapOfLabels(const Grid& grid, const SignedDistance& truth) {
  const auto place = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return grid.worldOf({double(i), double(j), double(k)});
  };
  std::vector<Vec3> midpoints;
  eachVoxel(grid, [&](auto i, auto j, auto k) {
    const Vec3 here = place(i, j, k);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 next = place(i + (axis == 0), j + (axis == 1), k + (axis == 2));
      if ((truth(here) <= 0.0) != (truth(next) <= 0.0)) midpoints.push_back(0.5 * (here + next));
    }
  });
  const double near = 4.0 * grid.spacing.maxCoeff();
  return made::distanceMap(
      grid,
      [&](const Vec3& p) {
        const double sign = truth(p) <= 0.0 ? -1.0 : 1.0;
        if (std::abs(truth(p)) > near) return sign * kMost;
        double nearest = kMost * kMost;
        for (const Vec3& midpoint : midpoints)
          nearest = std::min(nearest, (midpoint - p).squaredNorm());
        return sign * std::sqrt(nearest);
      },
      kMost);
}

TEST(Walls, OfVoxelsThatBelongOrDoNotLieWithinHalfAVoxel) {
  Random random{408};
  for (const bool solid : {true, false}) {
    Errors errors;
    for (int k = 0; k < 6; ++k) {
      const Grid grid = centredGrid(36, 5e-4);
      const auto scan = matter(grid, solid ? -1000.0 : 1200.0, 20.0, random);
      const Shape shape = shapeOf(k % 3, middleOf(grid) + random.box(5e-4), 4e-3, random);
      const auto made = walledBy(scan, {{0, solid, mapOfLabels(grid, shape.distance)}});
      measure(*made, kIsovalue, shape, 400, solid, random, errors);
    }
    errors = told(solid ? "solid, of labels" : "not there, of labels", errors);
    EXPECT_LT(std::abs(errors.mean), 0.1);
    EXPECT_LT(errors.worst, 0.55);
    EXPECT_GT(errors.worst, 0.1);
  }
}

/// Three balls in noise: two are walls of either kind that overlap.
struct Mixed {
  explicit Mixed(Random& random, ScalarType type = ScalarType::Int16, int odd = -1,
                 bool apart = false)
      : grid{apart     ? centredGrid(130, 34, 34, 5e-4)
             : odd < 0 ? centredGrid(44, 40, 36, 5e-4)
                       : made::oddGrid(odd, {44, 40, 30}, random)},
        scan{made::shared(
            filled(grid, type, [&](auto, auto, auto) { return random.in(-1000.0, 1500.0); }))} {
    const double side = grid.spacing.minCoeff();
    const Vec3 middle = middleOf(grid);
    const auto ball = [&](const Vec3& at, double radius) {
      return [=](const Vec3& p) { return (p - at).norm() - radius; };
    };
    gone = wallOf(grid, ball(middle - 4.0 * side * Vec3::UnitX(), 7.3 * side), false, 3);
    solid = wallOf(grid, ball(middle + 5.0 * side * random.direction(), 5.2 * side), true, 7);
    if (!apart) return;
    gone = wallOf(grid, ball(middle - 50.0 * side * Vec3::UnitX(), 7.3 * side), false, 3);
    solid = wallOf(grid, ball(middle + 50.0 * side * Vec3::UnitX(), 5.2 * side), true, 7);
  }
  std::vector<StructureWall> both() const { return {gone, solid}; }
  double distance(const StructureWall& wall, std::int64_t i, std::int64_t j, std::int64_t k) const {
    return wall.distances.at(grid.worldOf({double(i), double(j), double(k)})) /
           grid.spacing.maxCoeff();
  }
  Grid grid;
  std::shared_ptr<const Volume> scan;
  StructureWall gone, solid;
};

TEST(Walls, ChangeNothingBeyondTheirReachAndDecideWhatLiesWithin) {
  Random random{403};
  for (int k = -1; k < 6; ++k) {
    const Mixed mixed{random, ScalarType::Int16, k};
    const auto made = walledBy(mixed.scan, mixed.both());
    int kept = 0, inside = 0, away = 0, near = 0;
    eachVoxel(mixed.grid, [&](auto i, auto j, auto l) {
      const double then = valueAt(*mixed.scan, i, j, l), now = valueAt(*made, i, j, l);
      const double gone = mixed.distance(mixed.gone, i, j, l);
      const double solid = mixed.distance(mixed.solid, i, j, l);
      ASSERT_GE(now, made->least);
      ASSERT_LE(now, made->greatest);
      if (std::min(gone, solid) >= WallProfile::kReach) {
        ++kept;
        ASSERT_EQ(now, then);
      } else if (solid < 0.0) {
        ++inside;
        ASSERT_GE(now, kIsovalue);  // solid comes after what is not there
      } else if (gone < -0.01 && solid > 0.01) {
        ++away;
        ASSERT_LT(now, kIsovalue);
      } else {
        ++near;  // neither makes solid what was not, nor free what was solid
        if (gone > 0.0 && solid > 0.01) {
          ASSERT_EQ(now >= kIsovalue, then >= kIsovalue);
        }
      }
    });
    EXPECT_GT(kept, 1000);
    EXPECT_GT(inside, 30);
    EXPECT_GT(away, 50);
    EXPECT_GT(near, 100);
    // what one sees is the scan
    EXPECT_EQ(seenOf(made), mixed.scan);
    EXPECT_EQ(made->derivation->scan, mixed.scan);
    EXPECT_EQ(made->least, mixed.scan->least);
    EXPECT_EQ(made->greatest, mixed.scan->greatest);
  }
}

TEST(Walls, AreTheVolumeItselfWhereThereAreNone) {
  Random random{404};
  const Mixed mixed{random};
  EXPECT_EQ(walledBy(mixed.scan, {}), mixed.scan);
  const auto made = walledBy(mixed.scan, mixed.both());
  EXPECT_NE(made, mixed.scan);
  EXPECT_EQ(walledBy(made, {}), mixed.scan);
  // far from the volume
  StructureWall far = mixed.solid;
  far.distances.grid.origin += Vec3(1.0, 0.0, 0.0);
  EXPECT_EQ(walledBy(mixed.scan, {far}), mixed.scan);
  const std::atomic<bool> cancel{true};
  const auto none = walled(mixed.scan, mixed.both(), kIsovalue, {}, &cancel);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, Error::Kind::Cancelled);
}

bool hasSameVoxels(const Volume& one, const Volume& other) {
  return std::memcmp(one.voxels.get(), other.voxels.get(),
                     std::size_t(one.grid.voxelCount()) * sizeOf(one.type)) == 0;
}

TEST(Walls, AreMadeAgainToTheBitOverEditsToo) {
  Random random{405};
  for (int k = -1; k < 3; ++k) {
    const Mixed mixed{random, k == 1 ? ScalarType::Float32 : ScalarType::Int16, k};
    const std::vector<Edit> edits{PlaneCut{middleOf(mixed.grid), random.direction(), kIsovalue},
                                  Crop{{{2, 3, 1}, {40, 39, 28}}}};
    for (const std::size_t count : {0U, 1U, 2U}) {
      const auto seen = edited(mixed.scan, std::span{edits}.first(count)).value();
      const auto one = walledBy(seen, mixed.both());
      // from other walls at another isovalue
      const auto other = walledBy(one, {mixed.solid}, 500.0, one);
      const auto again = walledBy(other, mixed.both(), kIsovalue, other);
      EXPECT_TRUE(hasSameVoxels(*one, *again));
      EXPECT_FALSE(hasSameVoxels(*one, *other));
      EXPECT_EQ(walledOf(*one)->digest_of_walls, walledOf(*again)->digest_of_walls);
      EXPECT_NE(walledOf(*one)->digest_of_walls, walledOf(*other)->digest_of_walls);
      // beyond the walls it is the edited scan
      eachVoxel(mixed.grid, [&](auto i, auto j, auto l) {
        if (std::min(mixed.distance(mixed.gone, i, j, l), mixed.distance(mixed.solid, i, j, l)) >
            WallProfile::kReach) {
          ASSERT_EQ(valueAt(*again, i, j, l), valueAt(*seen, i, j, l));
        }
      });
      EXPECT_EQ(seenOf(again), seen);
      EXPECT_EQ(again->crop, seen->crop);
      EXPECT_EQ(walledOf(*again)->edits.size(), count);
      EXPECT_EQ(walledOf(*again)->digest, count == 0 ? 0 : editedOf(*seen)->digest);
      EXPECT_EQ(walledOf(*again)->scan, mixed.scan);
      EXPECT_EQ(walledOf(*again)->walls, (std::vector<Walled::Wall>{{3, false}, {7, true}}));
      EXPECT_EQ(walledOf(*again)->isovalue, kIsovalue);
    }
  }
}

/// What a pyramid states holds for every voxel near, and for every step between two.
void expectBounds(const ScalarField& field) {
  const Volume& volume = field.volume();
  const MaxPyramid& pyramid = field.pyramid();
  const auto& spacing = volume.grid.spacing;
  eachVoxel(volume.grid, [&](auto i, auto j, auto k) {
    const VoxelBox box = volume.bounds();
    const std::int64_t voxel[] = {i, j, k};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (voxel[axis] < box.first[axis] || voxel[axis] >= box.end[axis]) return;
    const double here = valueAt(volume, i, j, k);
    Vec3 step;
    for (int axis = 0; axis < 3; ++axis)
      step[axis] =
          std::abs(valueAt(volume, i + (axis == 0), j + (axis == 1), k + (axis == 2)) - here) /
          spacing[axis];
    const Vec3 at{double(i), double(j), double(k)};
    ASSERT_GE(pyramid.lipschitz(at), step.norm() * (1.0 - 1e-6)) << at.transpose();
    ASSERT_GT(pyramid.bound(at, here).lipschitz, 0.0) << at.transpose();  // it is not empty
  });
}

TEST(Walls, HaveTheBoundsOfANewPyramid) {
  Random random{406};
  for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline})
    for (int k = -2; k < 2; ++k) {
      // the first are so far apart that what changes between two volumes is not the whole
      const Mixed mixed{random, ScalarType::Int16, k, k == -2};
      EditHistory history{mixed.scan};
      std::shared_ptr<const Scene> scene;
      int renewed = 0;
      const auto touch = [&](const std::shared_ptr<const Volume>& volume) {
        renewed += scene && derivationBetween(volume, scene->volume) != nullptr;
        scene = makeScene(volume, made::point(), {.field = kind}, scene.get()).value();
        const ScalarField anew{volume, kind};
        ASSERT_EQ(scene->field.pyramid(), anew.pyramid());
        if (kind == FieldKind::Trilinear) expectBounds(scene->field);
      };
      const auto walls = [&](const std::vector<StructureWall>& which, double isovalue) {
        touch(walledBy(history.present(), which, isovalue, scene->volume));
      };
      touch(mixed.scan);
      walls({mixed.solid}, kIsovalue);  // raised
      walls({mixed.solid}, 600.0);      // at another isovalue
      walls({mixed.gone}, 600.0);       // lowered where it was raised
      walls(mixed.both(), kIsovalue);
      // an edit below the walls, and the walls over it
      (void)history.apply(PlaneCut{middleOf(mixed.grid), random.direction(), kIsovalue}).value();
      walls(mixed.both(), kIsovalue);
      (void)history.apply(Crop{{{4, 4, 4}, {30, 30, 28}}}).value();
      walls({mixed.solid}, kIsovalue);
      (void)history.undo().value();
      walls({mixed.solid}, 200.0);
      EXPECT_EQ(renewed, 7);
      touch(history.present());
      walls(mixed.both(), kIsovalue);
      (void)history.reset().value();
      touch(mixed.scan);
    }
}

/// A solid structure beside the isosurface of noise, of plates and of grain, and one that is not
/// there.
struct MixedTarget {
  study::arcs::Target target;
  std::shared_ptr<const Scene> scene;  ///< with bounds renewed from those of the scan
};
MixedTarget mixedTarget(int kind, Random& random) {
  using study::arcs::h;
  const Grid grid = centredGrid(40, h);
  const Vec3 slant = random.direction();
  const auto scan = made::shared(
      filled(grid, ScalarType::Int16, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        const Vec3 p = grid.worldOf({double(i), double(j), double(k)});
        if (kind == 0) return random.in(-1000.0, 700.0);
        if (kind == 1) return i % 8 == 4 ? 1000.0 : -1000.0;
        return (slant.dot(p) > 2.0 * h ? 900.0 : -900.0) + random.in(-100.0, 100.0);
      }));
  std::vector<StructureWall> walls;
  for (int n = 0; n < 4; ++n) {
    const Vec3 middle = random.box(14.0 * h), axis = random.direction();
    const double radius = random.in(0.4, 4.0) * h;  // thinner than a voxel, too
    walls.push_back(wallOf(
        grid,
        [=](const Vec3& p) {
          const Vec3 off = p - middle;
          return (n % 2 == 0 ? Vec3{off - axis * axis.dot(off)} : off).norm() - radius;
        },
        n != 3, std::uint8_t(n)));
  }
  const auto made = walledBy(scan, walls);
  const auto before = makeScene(scan, made::point()).value();
  return {{"mixed", *made, {kIsovalue, 250.0, 450.0}, 17.0 * h, 600},
          makeScene(made, made::point(), {}, before.get()).value()};
}

TEST(Walls, AreMissedByNoArc) {
  // packaging/test --all shoots 10^5
  const long all = std::getenv("PALPATE_TEST_ALL") != nullptr ? 100'000 : 6'000;
  Random random{407};
  study::arcs::Tally tally;
  const long each = made::trials(int(all)) / 12;
  for (int n = 0; n < 12; ++n) {
    const auto [target, scene] = mixedTarget(n % 3, random);
    tally += study::arcs::shootPoints(
        target, each, random,
        [&field = scene->field](const auto&, double s, const study::arcs::Arc& arc) {
          return study::arcs::crossed({field, s}, arc, Tolerances{study::arcs::h});
        });
    if (n < 3) tally += study::arcs::shootShells(target, each / 8, random);
  }
  std::cout << tally.arcs << " arcs, " << tally.met << " met, latest " << tally.latest << " voxel, "
            << tally.early << " early\n";
  EXPECT_EQ(tally.missed, 0);
  EXPECT_EQ(tally.late, 0);
  EXPECT_LE(tally.early, tally.met / 100);
  EXPECT_GT(tally.met, tally.arcs / 10);
  EXPECT_LT(tally.met, tally.arcs);
}

}  // namespace
}  // namespace walls_tests
