// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/core/voxel_memory.h"
#include "haptics/field/max_pyramid.h"
#include "haptics/field/scalar_field.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::Grid;
using haptics::MaxPyramid;
using haptics::ScalarField;
using haptics::ScalarType;
using haptics::Vec3;
using haptics::Volume;

/// Constant blocks, far apart in value: plateaus with steep walls, and much of nothing.
Volume plateaus(const Grid& grid, ScalarType type, Random& random) {
  std::vector<double> levels(64);
  for (double& level : levels) level = random.below(3) == 0 ? random.in(20.0, 120.0) : 0.0;
  return datasets::filled(grid, type, [&](auto i, auto j, auto k) {
    return levels[static_cast<std::size_t>((i / 20) % 4 + 4 * ((j / 20) % 4) + 16 * (k / 20 % 4))];
  });
}

struct Seen {
  int empty = 0, sloped = 0, wide = 0, inside = 0;
};

/// Samples what `bound` states about places in and around the volume.
void check(const ScalarField& field, Random& random, int places, Seen& seen) {
  const Volume& volume = field.volume();
  const Grid& grid = volume.grid;
  const double range = volume.greatest - volume.least;
  for (int n = 0; n < places; ++n) {
    Vec3 u;
    for (int axis = 0; axis < 3; ++axis) u[axis] = random.in(-8.0, double(grid.dims[axis]) + 8.0);
    const Vec3 p_W = grid.worldOf(u);
    const double s = volume.least + std::fmax(range, 1.0) * random.in(0.01, 1.01);
    const MaxPyramid::Bound bound = field.pyramid().bound(u, s);
    ASSERT_GT(bound.radius, 0.0);
    const double here = evaluator::fieldAt(volume, p_W);
    seen.inside += here >= s;
    for (int i = 0; i < 24; ++i) {
      const double distance = bound.radius * std::cbrt(random.in(0.0, 1.0));
      const double there = evaluator::fieldAt(volume, p_W + distance * random.direction());
      if (bound.lipschitz == 0.0)
        ASSERT_LT(there, s) << "proven empty within " << bound.radius << " m of index "
                            << u.transpose();
      else
        ASSERT_LE(std::abs(there - here), bound.lipschitz * distance + 1e-9 * range);
    }
    ++(bound.lipschitz == 0.0 ? seen.empty : seen.sloped);
    seen.wide += bound.lipschitz == 0.0 && bound.radius > 1.5 * field.pyramid().finestRadius();
    // and the statement of the finest level, whatever the isovalue
    const double rate = field.pyramid().lipschitz(u);
    const Vec3 a = p_W + field.pyramid().finestRadius() * random.in(0.0, 1.0) * random.direction();
    ASSERT_LE(std::abs(evaluator::fieldAt(volume, a) - here),
              rate * (a - p_W).norm() + 1e-9 * range);
  }
}

TEST(MaxPyramid, StatesOnlyBoundsThatHoldInNoiseOfEveryTypeAndFrame) {
  Random random{11};
  Seen seen;
  int k = 0;
  for (const ScalarType type : made::kTypes) {
    SCOPED_TRACE(haptics::nameOf(type));
    const Grid grid = made::oddGrid(k, {17 + k, 9, 30 - k}, random);
    ++k;
    check(ScalarField{made::shared(made::randomVolume(grid, type, random))}, random,
          made::trials(2000), seen);
  }
  EXPECT_GT(seen.sloped, made::trials(5000));
  EXPECT_GT(seen.empty, made::trials(500));
}

// a plateau at or above the isovalue has no slope, and is as inside as can be
TEST(MaxPyramid, StatesOnlyBoundsThatHoldOnPlateausOfEveryTypeAndFrame) {
  Random random{12};
  Seen seen;
  int k = 0;
  for (const ScalarType type : made::kTypes) {
    SCOPED_TRACE(haptics::nameOf(type));
    const Grid grid = made::oddGrid(k++, {60, 47, 80}, random);
    check(ScalarField{made::shared(plateaus(grid, type, random))}, random, made::trials(2000),
          seen);
  }
  EXPECT_GT(seen.empty, made::trials(3000));
  EXPECT_GT(seen.wide, made::trials(300));
  EXPECT_GT(seen.sloped, made::trials(2000));
  EXPECT_GT(seen.inside, made::trials(500));
}

/// The finest blocks of the trilinear field as their definition has them, voxel by voxel.
std::vector<haptics::lanes::BlockBound> finestByDefinition(const Volume& volume,
                                                           const std::array<std::int64_t, 3>& n) {
  const haptics::VoxelBox box = volume.bounds();
  const auto& dims = volume.grid.dims;
  const auto valueAt = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    const std::int64_t at[3] = {i, j, k};
    for (std::size_t a = 0; a < 3; ++a)
      if (at[a] < box.first[a] || at[a] >= box.end[a]) return volume.least;
    return haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* v) {
      return static_cast<double>(v[(k * dims[1] + j) * dims[0] + i]);
    });
  };
  const auto upwards = [](double x) {
    const auto f = static_cast<float>(x);
    return double{f} < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
  };
  std::vector<haptics::lanes::BlockBound> own, dilated;
  const auto each = [&](auto&& f) {
    for (std::int64_t k = 0; k < n[2]; ++k)
      for (std::int64_t j = 0; j < n[1]; ++j)
        for (std::int64_t i = 0; i < n[0]; ++i) f(i, j, k);
  };
  each([&](std::int64_t bi, std::int64_t bj, std::int64_t bk) {
    double top = volume.least;
    Vec3 rise = Vec3::Zero();
    for (std::int64_t k = 4 * bk - 1; k < 4 * bk + 4; ++k)
      for (std::int64_t j = 4 * bj - 1; j < 4 * bj + 4; ++j)
        for (std::int64_t i = 4 * bi - 1; i < 4 * bi + 4; ++i) {
          const double v = valueAt(i, j, k);
          top = std::fmax(top, v);
          if (i < 4 * bi + 3) rise[0] = std::fmax(rise[0], std::abs(valueAt(i + 1, j, k) - v));
          if (j < 4 * bj + 3) rise[1] = std::fmax(rise[1], std::abs(valueAt(i, j + 1, k) - v));
          if (k < 4 * bk + 3) rise[2] = std::fmax(rise[2], std::abs(valueAt(i, j, k + 1) - v));
        }
    own.push_back({upwards(top), upwards(rise.cwiseQuotient(volume.grid.spacing).norm())});
  });
  each([&](std::int64_t bi, std::int64_t bj, std::int64_t bk) {
    haptics::lanes::BlockBound most = own[static_cast<std::size_t>((bk * n[1] + bj) * n[0] + bi)];
    each([&](std::int64_t i, std::int64_t j, std::int64_t k) {
      if (std::max({std::abs(i - bi), std::abs(j - bj), std::abs(k - bk)}) > 1) return;
      const auto& one = own[static_cast<std::size_t>((k * n[1] + j) * n[0] + i)];
      most = {std::max(most.greatest, one.greatest), std::max(most.lipschitz, one.lipschitz)};
    });
    dilated.push_back(most);
  });
  return dilated;
}

bool isSame(const haptics::lanes::BlockBound* a, const haptics::lanes::BlockBound* b,
            std::size_t count) {
  return std::memcmp(a, b, count * sizeof *a) == 0;
}

TEST(MaxPyramid, HasTheBoundsOfItsDefinitionInEveryType) {
  Random random{15};
  int k = 0;
  for (const ScalarType type : made::kTypes)
    for (const bool cropped : {false, true}) {
      SCOPED_TRACE(haptics::nameOf(type));
      ++k;
      const Grid grid = made::oddGrid(k, {17 + k, 9 + 2 * k, 30 - k}, random);
      Volume volume = made::randomVolume(grid, type, random);
      if (cropped) volume.crop = made::randomBox(grid, random);
      const MaxPyramid pyramid{volume};
      const auto wanted = finestByDefinition(volume, pyramid.finestCounts());
      EXPECT_TRUE(isSame(pyramid.finest(), wanted.data(), wanted.size()));
    }
}

TEST(MaxPyramid, IsTheSameToTheBitOnAnyNumberOfThreads) {
  Random random{16};
  int k = 0;
  for (const ScalarType type : made::kTypes)
    for (const haptics::FieldKind kind :
         {haptics::FieldKind::Trilinear, haptics::FieldKind::CubicSpline})
      for (const bool cropped : {false, true}) {
        SCOPED_TRACE(haptics::nameOf(type));
        ++k;
        const Grid grid = made::oddGrid(k, {31 + k, 67 - k, 43 + 2 * k}, random);
        Volume volume = made::randomVolume(grid, type, random);
        if (cropped) volume.crop = made::randomBox(grid, random);
        const MaxPyramid alone{volume, kind, nullptr, 1};
        const auto [i, j, l] = alone.finestCounts();
        for (const int threads : {2, 3, 7}) {
          const MaxPyramid shared{volume, kind, nullptr, threads};
          EXPECT_EQ(shared, alone) << threads << " threads";
          EXPECT_TRUE(isSame(shared.finest(), alone.finest(), static_cast<std::size_t>(i * j * l)));
        }
      }
}

TEST(MaxPyramid, StatesOnlyBoundsThatHoldInACrop) {
  Random random{14};
  Seen seen;
  int k = 0;
  for (const ScalarType type : made::kTypes) {
    SCOPED_TRACE(haptics::nameOf(type));
    const Grid grid = made::oddGrid(k++, {60, 47, 80}, random);
    for (int n = 0; n < 4; ++n) {
      Volume volume =
          n % 2 == 0 ? plateaus(grid, type, random) : made::randomVolume(grid, type, random);
      volume.crop = made::randomBox(grid, random);
      check(ScalarField{made::shared(std::move(volume))}, random, made::trials(1000), seen);
    }
  }
  EXPECT_GT(seen.empty, made::trials(3000));
  EXPECT_GT(seen.wide, made::trials(300));
  EXPECT_GT(seen.sloped, made::trials(1500));
  EXPECT_GT(seen.inside, made::trials(300));
}

/// Few high voxels: lowering one changes the bounds far about it.
Volume peaks(const Grid& grid, ScalarType type, Random& random) {
  return datasets::filled(grid, type, [&](auto, auto, auto) {
    return random.below(300) == 0 ? random.in(20.0, 120.0) : random.in(0.0, 6.0);
  });
}

/// Makes most voxels of a box background.
void lower(const Volume& volume, const haptics::VoxelBox& box, Random& random) {
  const auto& dims = volume.grid.dims;
  haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    auto* v = const_cast<std::remove_const_t<std::remove_pointer_t<decltype(voxels)>>*>(voxels);
    for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
        for (std::int64_t i = box.first[0]; i < box.end[0]; ++i)
          if (random.below(3) > 0)
            v[(k * dims[1] + j) * dims[0] + i] =
                static_cast<std::remove_reference_t<decltype(*v)>>(volume.least);
  });
}

haptics::VoxelBox smallBox(const Grid& grid, Random& random) {
  haptics::VoxelBox box = made::randomBox(grid, random);
  for (std::size_t axis = 0; axis < 3; ++axis)
    box.end[axis] = std::min(box.end[axis], box.first[axis] + 1 + random.below(12));
  return box;
}

// after crops, voxels lowered in one box or in many, and both taken back
TEST(MaxPyramid, IsRenewedToWhatANewOneWouldBe) {
  Random random{15};
  int other = 0, k = 0;
  for (const haptics::FieldKind kind :
       {haptics::FieldKind::Trilinear, haptics::FieldKind::CubicSpline})
    for (const ScalarType type : {ScalarType::UInt8, ScalarType::Int16, ScalarType::Float32})
      for (const std::array<std::int64_t, 3> dims :
           {std::array<std::int64_t, 3>{70, 45, 150}, {131, 3, 66}, {1, 30, 7}}) {
        const Grid grid = made::oddGrid(k++, dims, random);
        Volume volume = peaks(grid, type, random);
        MaxPyramid pyramid{volume, kind};
        for (int step = 0; step < 12; ++step) {
          SCOPED_TRACE(step);
          const Volume before = volume;
          std::vector<haptics::VoxelBox> changed;
          if (step % 3 == 0) volume.crop = made::randomBox(grid, random);
          if (step == 7) volume.crop = {};
          if (step % 3 != 0 || step == 9) {
            volume.voxels = volume.memory->privateView().value();
            const std::size_t bytes = volume.memory->bytes();
            std::memcpy(const_cast<void*>(volume.voxels.get()), before.voxels.get(), bytes);
            for (int n = 0; n < (step % 2 == 0 ? 1 : 6); ++n) {
              changed.push_back(smallBox(grid, random));
              lower(volume, changed.back(), random);
            }
          }
          const MaxPyramid fresh{volume, kind};
          other += fresh != pyramid;
          const MaxPyramid renewed{pyramid, volume, changed, kind};
          ASSERT_TRUE(renewed == fresh);
          // and back again: an undo
          const MaxPyramid undone{renewed, before, changed, kind};
          ASSERT_TRUE(undone == pyramid);
          pyramid = renewed;
        }
      }
  EXPECT_GT(other, 90);  // of 216
}

TEST(MaxPyramid, ReachesAsFarAsTheFarthestLevelInEmptySpace) {
  Grid grid = datasets::centredGrid(200, 1e-3);
  const Volume volume = datasets::filled(grid, ScalarType::UInt8, [](auto i, auto j, auto k) {
    return i == 199 && j == 199 && k == 199 ? 200.0 : 0.0;
  });
  const MaxPyramid pyramid{volume};
  EXPECT_EQ(pyramid.bound({30, 30, 30}, 100.0).lipschitz, 0.0);
  EXPECT_GE(pyramid.bound({30, 30, 30}, 100.0).radius, 0.064 - 1e-12);  // 64 cells
  EXPECT_GT(pyramid.bound({198, 198, 198}, 100.0).lipschitz, 0.0);
  // far outside: at least the way to the grid
  EXPECT_GE(pyramid.bound({-500, 100, 100}, 100.0).radius, 0.499);
}

TEST(MaxPyramid, IsSmallBesideItsVolume) {
  const Volume volume = datasets::filled(datasets::centredGrid(128, 1e-3), ScalarType::Int16,
                                         [](auto i, auto, auto) { return double(i); });
  // 2 floats for 4^3 voxels of two bytes are 6 %, the coarser levels a seventh of one of them
  EXPECT_LT(MaxPyramid{volume}.bytes(), 0.10 * 2 * 128 * 128 * 128);
}

TEST(MaxPyramid, HoldsForASingleVoxelAndForThinVolumes) {
  Random random{13};
  for (const std::array<std::int64_t, 3> dims :
       {std::array<std::int64_t, 3>{1, 1, 1}, {1, 40, 1}, {2, 2, 90}, {5, 4, 3}}) {
    Grid grid = made::oddGrid(1, dims, random);
    Seen seen;
    check(ScalarField{made::shared(datasets::filled(
              grid, ScalarType::Int16, [&](auto, auto, auto) { return random.in(-9.0, 900.0); }))},
          random, 300, seen);
  }
}

}  // namespace
