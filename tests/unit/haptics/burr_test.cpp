// SPDX-License-Identifier: BSD-3-Clause
// A burr leaves a wall that has its place and its normal, and counts what it took, on any grid and
// type of voxel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/carving/burr.h"
#include "haptics/field/scalar_field.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::BurrCarving;
using haptics::BurrCut;
using haptics::Grid;
using haptics::Removed;
using haptics::ScalarField;
using haptics::ScalarType;
using haptics::Vec3;
using haptics::Volume;

/// A solid that fills its grid, and a voxel of air, which is the background.
struct Matter {
  ScalarType type;
  double solid, isovalue, background;
};
constexpr Matter kBone{ScalarType::Int16, 1200.0, 300.0, -1024.0};
constexpr Matter kBytes{ScalarType::UInt8, 200.0, 90.0, 0.0};
constexpr Matter kFloats{ScalarType::Float32, 1200.0, 300.0, -1024.0};

Volume solidOf(const Grid& grid, const Matter& matter) {
  return datasets::filled(grid, matter.type, [&](auto i, auto j, auto k) {
    return i + j + k == 0 ? matter.background : matter.solid;
  });
}

Grid gridOf(double radius, const Vec3& spacing, Random& random) {
  Grid grid;
  grid.spacing = spacing;
  for (int a = 0; a < 3; ++a)
    grid.dims[std::size_t(a)] = 2 * std::int64_t(std::ceil(radius / spacing[a])) + 13;
  grid.direction = random.rotation().toRotationMatrix();
  grid.origin = random.box(0.1);
  return grid;
}

Vec3 middleOf(const Grid& grid) {
  return 0.5 * Vec3(double(grid.dims[0] - 1), double(grid.dims[1] - 1), double(grid.dims[2] - 1));
}

/// The voxels of a volume that nobody else has.
void* voxelsOf(const Volume& volume) { return const_cast<void*>(volume.voxels.get()); }

Removed carve(const Volume& volume, const BurrCut& cut) {
  BurrCarving carving{volume, cut};
  Removed removed;
  while (!carving.isDone())
    removed.add(carving.lowerRow(voxelsOf(volume), volume.voxels.get(), {}));
  return removed;
}

struct Errors {
  double place = 0.0, normal = 0.0;  ///< rms: voxels, degrees
  double mean = 0.0;                 ///< voxels
};

/// Of the wall around a ball at `centre` [m].
Errors errorsAround(const Volume& volume, const BurrCut& cut, Random& random) {
  const ScalarField field{made::shared(volume)};
  const double voxel = std::cbrt(volume.grid.spacing.prod());
  Errors errors;
  constexpr int kRays = 600;
  for (int n = 0; n < kRays; ++n) {
    const Vec3 way = random.direction();
    auto budget = haptics::Budget::counted(1'000'000);
    const Vec3 from = cut.to_W + (cut.radius - 1.5 * voxel) * way,
               to = cut.to_W + (cut.radius + 1.5 * voxel) * way;
    const double t =
        field.firstReach(field.indexOf(from), field.indexOf(to), cut.isovalue, 1e-9, budget);
    EXPECT_LT(t, 1.5);
    const Vec3 met = from + t * (to - from);
    const double off = ((met - cut.to_W).norm() - cut.radius) / voxel;
    const Vec3 normal = field.centralGradient(field.indexOf(met)).normalized();
    const double turned = std::acos(std::clamp(normal.dot(way), -1.0, 1.0)) * 180.0 / M_PI;
    errors.place += off * off / kRays;
    errors.mean += off / kRays;
    errors.normal += turned * turned / kRays;
  }
  errors.place = std::sqrt(errors.place);
  errors.normal = std::sqrt(errors.normal);
  return errors;
}

TEST(Burr, LeavesABall) {
  Random random{47};
  for (const Matter& matter : {kBone, kBytes, kFloats})
    for (const double radius : {1.5, 2.0, 3.0, 4.0, 6.0, 10.0}) {
      Errors worst;
      for (int n = 0; n < made::trials(10); ++n) {
        const Grid grid = gridOf(1e-3 * radius, Vec3::Constant(1e-3), random);
        const Volume volume = solidOf(grid, matter);
        const Vec3 centre = grid.worldOf(middleOf(grid) + random.box(0.5));
        const BurrCut cut{centre, centre, 1e-3 * radius, matter.isovalue};
        carve(volume, cut);
        const Errors errors = errorsAround(volume, cut, random);
        worst.place = std::max(worst.place, errors.place);
        worst.normal = std::max(worst.normal, errors.normal);
        worst.mean = std::max(worst.mean, std::abs(errors.mean));
      }
      const bool large = radius >= 3.0;
      EXPECT_LE(worst.place, large ? 0.02 : 0.04) << haptics::nameOf(matter.type) << radius;
      EXPECT_LE(worst.normal, large ? 1.3 : 2.5) << haptics::nameOf(matter.type) << radius;
      EXPECT_LE(worst.mean, 0.01) << haptics::nameOf(matter.type) << radius;
      std::printf("%s %g: %.3f voxel, mean %.3f, %.2f degrees\n", haptics::nameOf(matter.type),
                  radius, worst.place, worst.mean, worst.normal);
    }
}

TEST(Burr, LeavesABallWhereVoxelsAreUneven) {
  Random random{48};
  for (const double radius : {3.0, 6.0}) {
    Errors worst;
    for (int n = 0; n < made::trials(10); ++n) {
      const Grid grid = gridOf(1e-3 * radius, 1e-3 * Vec3(0.5, 0.8, 1.0), random);
      const Volume volume = solidOf(grid, kBone);
      const Vec3 centre = grid.worldOf(middleOf(grid) + random.box(0.5));
      const BurrCut cut{centre, centre, 1e-3 * radius, kBone.isovalue};
      carve(volume, cut);
      const Errors errors = errorsAround(volume, cut, random);
      worst.place = std::max(worst.place, errors.place);
      worst.normal = std::max(worst.normal, errors.normal);
    }
    EXPECT_LE(worst.place, 0.04) << radius;
    EXPECT_LE(worst.normal, 2.5) << radius;
    std::printf("uneven %g: %.3f voxel, %.2f degrees\n", radius, worst.place, worst.normal);
  }
}

TEST(Burr, CountsTheVolumeOfABall) {
  Random random{49};
  for (const Matter& matter : {kBone, kBytes, kFloats})
    for (const double radius : {1.5, 1.75, 2.0, 2.5, 3.0, 5.0, 8.0, 12.0})
      for (const bool uneven : {false, true}) {
        const Vec3 spacing = 1e-3 * (uneven ? Vec3(0.6, 0.8, 1.0) : Vec3(1.0, 1.0, 1.0));
        double worst = 0.0;
        for (int n = 0; n < made::trials(radius < 3.0 ? 100 : 4); ++n) {
          const Grid grid = gridOf(1e-3 * radius, spacing, random);
          const Volume volume = solidOf(grid, matter);
          const Vec3 centre = grid.worldOf(middleOf(grid) + random.box(0.5));
          const BurrCut cut{centre, centre, 1e-3 * radius, matter.isovalue};
          const double ball = 4.0 / 3.0 * M_PI * std::pow(1e-3 * radius, 3);
          worst = std::max(worst, std::abs(carve(volume, cut).volume / ball - 1.0));
          EXPECT_EQ(carve(volume, cut).volume, 0.0);
        }
        // a byte is a thirtieth of a voxel, and voxels that are no cubes bend the ball
        const bool fine = matter.type != ScalarType::UInt8 && !uneven;
        EXPECT_LE(worst, radius >= 2.0 || fine ? 0.0105 : 0.02)
            << haptics::nameOf(matter.type) << " " << radius << (uneven ? " uneven" : "");
        std::printf("%s %g%s: %.2f %%\n", haptics::nameOf(matter.type), radius,
                    uneven ? " uneven" : "", 1e2 * worst);
      }
}

// as a burr moves on, tick by tick
TEST(Burr, CountsTheVolumeOfAGroove) {
  Random random{52};
  for (const Matter& matter : {kBone, kBytes})
    for (const double radius : {3.0, 6.0}) {
      const Grid grid = gridOf(1e-3 * (radius + 5.0), Vec3::Constant(1e-3), random);
      const Volume volume = solidOf(grid, matter);
      const Vec3 way = 10e-3 * random.direction();
      const Vec3 begin = grid.worldOf(middleOf(grid)) - 0.5 * way;
      Removed removed;
      constexpr int kTicks = 200;
      for (int n = 0; n < kTicks; ++n)
        removed.add(carve(volume, {begin + n * way / kTicks, begin + (n + 1) * way / kTicks,
                                   1e-3 * radius, matter.isovalue}));
      const double R = 1e-3 * radius;
      const double groove = 4.0 / 3.0 * M_PI * R * R * R + M_PI * R * R * way.norm();
      EXPECT_NEAR(removed.volume / groove, 1.0, 0.015) << haptics::nameOf(matter.type) << radius;
      std::printf("%s groove %g: %.2f %%\n", haptics::nameOf(matter.type), radius,
                  1e2 * (removed.volume / groove - 1.0));
    }
}

TEST(Burr, CutsTheSameInAnyOrderAndTwice) {
  Random random{50};
  for (const ScalarType type : made::kTypes) {
    const Grid grid = made::oddGrid(int(type), {33, 29, 31}, random);
    const Volume volume = made::randomVolume(grid, type, random);
    const std::size_t bytes = std::size_t(grid.voxelCount()) * haptics::sizeOf(type);
    std::vector<std::vector<char>> ends;
    std::vector<BurrCut> cuts;
    const double s = volume.least + 0.4 * (volume.greatest - volume.least);
    for (int n = 0; n < 12; ++n) {
      const Vec3 from = grid.worldOf(middleOf(grid) + random.box(12.0));
      cuts.push_back({from, from + random.box(3e-3), random.in(1e-3, 4e-3), s});
    }
    std::vector<char> scan(bytes);
    std::memcpy(scan.data(), volume.voxels.get(), bytes);
    for (int order = 0; order < 4; ++order) {
      std::memcpy(voxelsOf(volume), scan.data(), bytes);
      for (const BurrCut& cut : cuts) carve(volume, cut);
      if (order == 3) carve(volume, cuts[0]);
      ends.emplace_back(bytes);
      std::memcpy(ends.back().data(), volume.voxels.get(), bytes);
      std::ranges::reverse(cuts);
      std::rotate(cuts.begin(), cuts.begin() + 5, cuts.end());
    }
    for (const auto& end : ends) EXPECT_EQ(end, ends[0]) << haptics::nameOf(type);
    EXPECT_NE(ends[0], scan);
    haptics::visitVoxels(type, ends[0].data(), [&](const auto* after) {
      using T = std::remove_cvref_t<decltype(*after)>;
      const T* before = reinterpret_cast<const T*>(scan.data());
      for (std::int64_t n = 0; n < grid.voxelCount(); ++n) ASSERT_LE(after[n], before[n]);
    });
  }
}

/// A ball of structure voxels, as runs of whole rows.
std::vector<haptics::VoxelRun> ballOf(const Grid& grid, const Vec3& middle, double voxels) {
  std::vector<haptics::VoxelRun> runs;
  for (std::int32_t k = 0; k < grid.dims[2]; ++k)
    for (std::int32_t j = 0; j < grid.dims[1]; ++j) {
      const double square = voxels * voxels - std::pow(double(j) - middle.y(), 2) -
                            std::pow(double(k) - middle.z(), 2);
      if (!(square > 0.0)) continue;
      const auto first = std::int32_t(std::max(0.0, std::ceil(middle.x() - std::sqrt(square))));
      const auto last = std::int32_t(
          std::min(double(grid.dims[0] - 1), std::floor(middle.x() + std::sqrt(square))));
      if (first <= last) runs.push_back({first, j, k, last - first + 1});
    }
  return runs;
}

TEST(Burr, WritesNoSteeperThanItSaysAndNothingBeyondItsBox) {
  Random random{51};
  for (int n = 0; n < made::trials(40); ++n) {
    const ScalarType type = made::kTypes[n % 7];
    // beside what may not be cut it is steeper than a wall, where that is not steep
    const bool keeps = n % 2 == 1;
    Grid grid = made::oddGrid(n, {37, 29, 33}, random);
    if (keeps) grid.spacing.setConstant(grid.spacing.minCoeff());
    const double top = type == ScalarType::Int8 ? 120.0 : 250.0;
    Volume volume = datasets::filled(
        grid, type, [&](auto i, auto j, auto k) { return i + j + k == 0 ? 0.0 : top; });
    const Vec3 from = grid.worldOf(middleOf(grid) + random.box(10.0));
    const auto never = ballOf(grid, grid.indexOf(from) + random.box(2.0), 4.0);
    const haptics::Tissues::Part part{never, haptics::Tissues::kNever};
    if (keeps) volume.tissues = std::make_shared<const haptics::Tissues>(grid, std::span{&part, 1});
    const BurrCut cut{from, from + random.box(2e-3), random.in(1e-3, 4e-3),
                      keeps ? 110.0 : random.in(20.0, 110.0)};
    const BurrCarving asked{volume, cut};
    carve(volume, cut);
    haptics::visitVoxels(type, volume.voxels.get(), [&](const auto* v) {
      const std::int64_t by[3] = {1, grid.dims[0], grid.dims[0] * grid.dims[1]};
      for (std::int64_t k = 0; k < grid.dims[2]; ++k)
        for (std::int64_t j = 0; j < grid.dims[1]; ++j)
          for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
            const std::int64_t at[3] = {i, j, k};
            const std::int64_t here = k * by[2] + j * by[1] + i;
            bool within = true;
            for (std::size_t a = 0; a < 3; ++a)
              within = within && at[a] >= asked.box().first[a] && at[a] < asked.box().end[a];
            if (!within && i + j + k > 0) {
              ASSERT_EQ(double(v[here]), top);
            }
            for (std::size_t a = 0; a < 3; ++a) {
              if (at[a] + 1 == grid.dims[a] || i + j + k == 0) continue;
              ASSERT_LE(std::abs(double(v[here + by[a]]) - double(v[here])), asked.steepest());
            }
          }
    });
  }
}

TEST(Tissues, AreKeptToTheVoxelAndCountedByTheirEnergy) {
  Random random{52};
  std::int64_t kept = 0, known = 0;
  for (int n = 0; n < made::trials(28); ++n) {
    const ScalarType type = made::kTypes[n % 7];
    const Grid grid = made::oddGrid(n, {140, 29, 33}, random);  // rows of three chunks
    const Volume free = made::randomVolume(grid, type, random);
    Volume volume = free;
    const auto never = ballOf(grid, middleOf(grid) + random.box(6.0), random.in(2.0, 12.0)),
               hard = ballOf(grid, middleOf(grid) + random.box(6.0), random.in(2.0, 12.0)),
               soft = ballOf(grid, middleOf(grid) + random.box(6.0), random.in(2.0, 12.0));
    constexpr double kHard = 4e9, kSoft = 2e8;
    const haptics::Tissues::Part parts[] = {
        {never, haptics::Tissues::kNever}, {hard, kHard}, {soft, kSoft}};
    volume.tissues = std::make_shared<const haptics::Tissues>(grid, parts);
    // which of them a voxel has, read from the runs themselves
    std::vector<double> energies(std::size_t(grid.voxelCount()), 0.0);
    for (const auto& part : {parts[1], parts[2], parts[0]})
      for (const haptics::VoxelRun& run : part.runs)
        for (std::int32_t i = run.i; i < run.i + run.count; ++i)
          energies[std::size_t((run.k * grid.dims[1] + run.j) * grid.dims[0] + i)] = part.energy;
    const std::size_t bytes = energies.size() * haptics::sizeOf(type);
    std::vector<char> scan(bytes), without(bytes), with(bytes);
    std::memcpy(scan.data(), free.voxels.get(), bytes);
    const Vec3 from = grid.worldOf(middleOf(grid) + random.box(6.0));
    const BurrCut cut{from, from + random.box(2e-3), random.in(1e-3, 8e-3),
                      free.least + 0.4 * (free.greatest - free.least)};
    carve(free, cut);
    std::memcpy(without.data(), free.voxels.get(), bytes);
    std::memcpy(voxelsOf(free), scan.data(), bytes);
    const haptics::Material plain{.bands = {{{0.0, 1e9}}}};
    BurrCarving carving{volume, cut};
    Removed removed;
    double energy = 0.0;
    while (!carving.isDone()) removed.add(carving.lowerRow(voxelsOf(volume), scan.data(), plain));
    std::memcpy(with.data(), volume.voxels.get(), bytes);
    // each voxel by itself: only those of one energy may be cut
    std::int64_t lowered = 0;
    for (const double only : {0.0, kHard, kSoft}) {
      std::memcpy(voxelsOf(volume), scan.data(), bytes);
      std::vector<haptics::VoxelRun> others;
      for (std::size_t at = 0; at < energies.size(); ++at)
        if (energies[at] != only)
          others.push_back(
              {std::int32_t(at % std::size_t(grid.dims[0])),
               std::int32_t(at / std::size_t(grid.dims[0]) % std::size_t(grid.dims[1])),
               std::int32_t(at / std::size_t(grid.dims[0] * grid.dims[1])), 1});
      const haptics::Tissues::Part part{others, haptics::Tissues::kNever};
      Volume alone = volume;
      alone.tissues = std::make_shared<const haptics::Tissues>(grid, std::span{&part, 1});
      energy += carve(alone, cut).volume * (only == 0.0 ? 1e9 : only);
    }
    haptics::visitVoxels(type, scan.data(), [&](const auto* before) {
      using T = std::remove_cvref_t<decltype(*before)>;
      const T* uncut = reinterpret_cast<const T*>(without.data());
      const T* after = reinterpret_cast<const T*>(with.data());
      for (std::size_t at = 0; at < energies.size(); ++at) {
        const bool is_kept = energies[at] == haptics::Tissues::kNever;
        ASSERT_EQ(after[at], is_kept ? before[at] : uncut[at]) << at;
        kept += is_kept && uncut[at] != before[at];
        known += energies[at] > 0.0 && after[at] != before[at];
        lowered += after[at] != before[at];
      }
    });
    EXPECT_EQ(removed.voxels, lowered);
    EXPECT_NEAR(removed.energy, energy, 1e-6 * energy);
  }
  EXPECT_GT(kept, made::trials(1000));
  EXPECT_GT(known, made::trials(1000));
}

TEST(Tissues, AreFoundInEveryBoxThatHasThem) {
  Random random{53};
  int found = 0, none = 0;
  for (int n = 0; n < 2000; ++n) {
    const Grid grid{.dims = {std::int64_t(random.below(40)) + 1, std::int64_t(random.below(40)) + 1,
                             std::int64_t(random.below(40)) + 1}};
    haptics::VoxelBox box;
    std::int32_t at[3];
    bool within = true, far = false;
    for (std::size_t a = 0; a < 3; ++a) {
      const int dim = int(grid.dims[a]);
      at[a] = random.below(dim);
      box.first[a] = random.below(dim);
      box.end[a] = box.first[a] + 1 + random.below(dim - int(box.first[a]));
      within = within && at[a] >= box.first[a] && at[a] < box.end[a];
      far = far || at[a] < box.first[a] - 8 || at[a] >= box.end[a] + 8;
    }
    const std::vector<haptics::VoxelRun> runs{{at[0], at[1], at[2], 1}};
    const haptics::Tissues::Part never{runs, haptics::Tissues::kNever}, soft{runs, 1e8};
    const haptics::Tissues tissues{grid, std::span{&never, 1}};
    EXPECT_TRUE(!within || tissues.mayKeep(box)) << n;
    EXPECT_TRUE(!far || !tissues.mayKeep(box)) << n;
    EXPECT_FALSE(haptics::Tissues(grid, std::span{&soft, 1}).mayKeep(box));
    found += within;
    none += far;
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(none, 50);
}

}  // namespace
