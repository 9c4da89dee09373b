// SPDX-License-Identifier: BSD-3-Clause
// The structures of phantoms: their distances are the true ones, they lie where README.md says, and
// the voxels hold what they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/mastoid.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/phantoms/structures.h"

namespace datasets {
namespace {

using haptics::Vec3;

constexpr const char* kWithStructures[] = {"mastoid", "demo"};

const PhantomStructure& structureOf(const std::vector<PhantomStructure>& all, const char* name) {
  return *std::ranges::find(all, std::string{name}, &PhantomStructure::name);
}

Vec3 gradientAt(const PhantomStructure& structure, const Vec3& p) {
  const double h = 1e-7;
  Vec3 gradient;
  for (Eigen::Index a = 0; a < 3; ++a)
    gradient[a] =
        (structure.distance(p + h * Vec3::Unit(a)) - structure.distance(p - h * Vec3::Unit(a))) /
        (2 * h);
  return gradient;
}

TEST(Structures, HaveNamesAndColoursOfTheirOwn) {
  EXPECT_TRUE(phantomStructures("sphere").empty());
  for (const char* phantom : kWithStructures) {
    const auto all = phantomStructures(phantom);
    EXPECT_GE(all.size(), 8U);
    for (const PhantomStructure& one : all) {
      EXPECT_EQ(std::ranges::count(all, one.name, &PhantomStructure::name), 1) << one.name;
      for (const double channel : one.colour) EXPECT_TRUE(channel >= 0.0 && channel <= 1.0);
    }
  }
}

TEST(Structures, DistancesGrowNoFasterThanTheWay) {
  Random random{3};
  for (const char* phantom : kWithStructures)
    for (const PhantomStructure& one : phantomStructures(phantom)) {
      if (!one.exact) continue;
      SCOPED_TRACE(one.name);
      for (int trial = 0; trial < 5'000; ++trial) {
        const Vec3 p = random.box(0.1);
        const Vec3 q = p + std::pow(10.0, random.in(-6.0, -1.5)) * random.direction();
        ASSERT_LE(std::abs(one.distance(p) - one.distance(q)), (p - q).norm() + 1e-12);
      }
    }
}

// every place within the distance is on the same side, and one just beyond it is not
TEST(Structures, DistancesAreThoseOfAFineLattice) {
  Random random{4};
  const double h = 0.12e-3;
  for (const char* phantom : kWithStructures)
    for (const PhantomStructure& one : phantomStructures(phantom)) {
      if (!one.exact) continue;
      SCOPED_TRACE(one.name);
      int compared = 0, inside = 0;
      for (int trial = 0; trial < 60; ++trial) {
        Vec3 p = random.box(0.04);
        for (int step = 0; step < 3; ++step) p -= one.distance(p) * gradientAt(one, p);
        if (std::abs(one.distance(p)) > 1e-8) continue;  // from a crease
        p += random.in(0.0, 1.2e-3) * random.direction();
        const double distance = one.distance(p);
        const bool is_inside = distance <= 0.0;
        const int reach = int(std::abs(distance) / h) + 4;
        double least = HUGE_VAL;
        for (int k = -reach; k <= reach; ++k)
          for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) {
              const Vec3 by = h * Vec3(i, j, k);
              if (by.norm() < least && (one.distance(p + by) <= 0.0) != is_inside)
                least = by.norm();
            }
        EXPECT_GE(least, std::abs(distance) - 1e-9);
        EXPECT_LE(least, std::abs(distance) + 3.0 * h);
        ++compared;
        inside += is_inside;
      }
      EXPECT_GT(compared, 40);
      EXPECT_GT(inside, 5);
      EXPECT_LT(inside, compared - 5);
    }
}

// the sizes that README.md states, in numbers of their own
TEST(Structures, LieWhereTheyAreSaidToLie) {
  const auto expectAt = [](const char* phantom, const char* name, const Vec3& p_mm, double mm) {
    const auto all = phantomStructures(phantom);
    EXPECT_NEAR(1e3 * structureOf(all, name).distance(1e-3 * p_mm), mm, 1e-4)
        << name << ' ' << p_mm;
  };
  for (const auto& [name, radius] : {std::pair{"Facial nerve", 0.6}, {"Facial canal", 0.9}}) {
    expectAt("mastoid", name, {-16.0, -13.5, 8.8}, -radius);    // fundus
    expectAt("mastoid", name, {-14.8, -14.25, 8.65}, -radius);  // labyrinthine
    expectAt("mastoid", name, {-9.25, -10.5, 6.65}, -radius);   // tympanic
    expectAt("mastoid", name, {-5.5, -4.5, -2.5}, -radius);     // mastoid
    expectAt("mastoid", name, {-4.5, -4.0, -10.0}, -radius);    // foramen
    // the genus pass their corners by r (1 / cos(turn / 2) - 1)
    expectAt("mastoid", name, {-12.0, -16.0, 8.3}, 0.69234 - radius);
    expectAt("mastoid", name, {-6.5, -5.0, 5.0}, 0.52033 - radius);
  }
  expectAt("mastoid", "Sigmoid sinus", {9, 16, 8.5}, -4.5);
  expectAt("mastoid", "Sigmoid sinus", {8.5, 14.75, 6.375}, -4.5);
  expectAt("mastoid", "Sigmoid sinus", {-5, 9.5, -2.25}, -4.5);
  expectAt("mastoid", "Ear canal", {11.15, -9.4, 2.5}, -3.75);
  expectAt("mastoid", "Tympanic cavity", {-4.2, -10.4, -5}, 0.3);
  expectAt("mastoid", "Antrum", {-1, 3, 14}, 1.0);
  expectAt("mastoid", "Dura plate", {-1, 0, 15}, -0.5);
  expectAt("mastoid", "Lateral semicircular canal", {-10.5, -1.5, 8}, 3.2 - 0.5);
  expectAt("mastoid", "Lateral semicircular canal", {-7.3, -1.5, 8}, -0.5);
  expectAt("demo", "Left eye", {33, -68, 2}, -12.0);
  expectAt("demo", "Right eye", {-33, -68, 2}, -12.0);
  expectAt("demo", "Burr hole", {41, 24, 86}, -5.5);
  expectAt("demo", "Left carotid canal", {20, 11, -30}, -3.0);
  expectAt("demo", "Right jugular canal", {-29, 29, -24}, -4.0);
  expectAt("demo", "Spinal canal", {0, 48, -84}, -8.0);
  EXPECT_LT(structureOf(phantomStructures("demo"), "Brain").distance({0, 0.02, 0.04}), 0.0);
  EXPECT_GT(structureOf(phantomStructures("demo"), "Brain").distance({0, -0.08, 0}), 0.0);
}

class Mastoid : public testing::Test {
 protected:
  static void SetUpTestSuite() { phantom_ = makePhantom("mastoid").value(); }
  static void TearDownTestSuite() { phantom_ = {}; }
  static Phantom phantom_;
};
Phantom Mastoid::phantom_;

TEST_F(Mastoid, IsSampledFromItsFormula) {
  const haptics::Volume& volume = phantom_.volume;
  EXPECT_EQ(volume.unit, "HU");
  const auto* voxels = static_cast<const std::int16_t*>(volume.voxels.get());
  Random random{5};
  for (int trial = 0; trial < 5'000; ++trial) {
    const int i = random.below(120), j = random.below(128), k = random.below(120);
    const double value = mastoid::valueAt(volume.grid.worldOf(Vec3(i, j, k)));
    EXPECT_NEAR(voxels[(k * 128 + j) * 120 + i], value, 0.5);
  }
}

TEST_F(Mastoid, LiesWithinItsGridInAir) {
  const haptics::Grid& grid = phantom_.volume.grid;
  const auto* voxels = static_cast<const std::int16_t*>(phantom_.volume.voxels.get());
  const auto structures = phantomStructures("mastoid");
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
        const bool border = i == 0 || j == 0 || k == 0 || i == grid.dims[0] - 1 ||
                            j == grid.dims[1] - 1 || k == grid.dims[2] - 1;
        if (!border) continue;
        ASSERT_EQ(voxels[(k * grid.dims[1] + j) * grid.dims[0] + i], -1000);
        const Vec3 p = grid.worldOf({double(i), double(j), double(k)});
        for (const PhantomStructure& one : structures) ASSERT_GT(one.distance(p), 0.0) << one.name;
      }
}

TEST_F(Mastoid, ItsStructuresHoldWhatTheyAre) {
  const auto at = [](double x, double y, double z) {
    return mastoid::valueAt(1e-3 * Vec3{x, y, z});
  };
  EXPECT_EQ(at(-5.5, -4.5, -2.5), 40.0);   // nerve
  EXPECT_EQ(at(8.5, 14.75, 6.375), 45.0);  // sinus
  EXPECT_EQ(at(-1, 0, 15), 60.0);          // dura
  EXPECT_EQ(at(-1, 0, 18), 36.0);          // brain above it
  EXPECT_EQ(at(-7.3, -1.5, 8), 10.0);      // fluid
  EXPECT_EQ(at(-1, 3, 9), -1000.0);        // antrum
  EXPECT_EQ(at(11.15, -9.4, 2.5), -1000.0);
  // a wall of dense bone about what the air cells surround
  const auto structures = phantomStructures("mastoid");
  Random random{6};
  for (const char* name : {"Sigmoid sinus", "Lateral semicircular canal", "Facial canal", "Antrum",
                           "Tympanic cavity", "Ear canal"}) {
    SCOPED_TRACE(name);
    const PhantomStructure& one = structureOf(structures, name);
    int places = 0, dense = 0;
    for (int trial = 0; trial < 2'000; ++trial) {
      Vec3 p = random.box(0.02);
      p -= (one.distance(p) - 0.5e-3) * gradientAt(one, p);
      if (std::abs(one.distance(p) - 0.5e-3) > 1e-6) continue;
      const auto near = [&](const PhantomStructure& other) { return other.distance(p) < 1e-3; };
      // beyond the bone, which the nerve leaves at its bottom, or where two of them meet
      if (p.z() < -9.3e-3 || mastoid::valueAt(p) < -990.0 ||
          std::ranges::count_if(structures, near) >
              1 + (&one == &structureOf(structures, "Facial canal")))
        continue;
      ++places;
      dense += mastoid::valueAt(p) > 1200.0;
    }
    EXPECT_GT(places, 200);
    EXPECT_GT(dense, 0.9 * places);
  }
}

TEST_F(Mastoid, IsALeftEarFullOfAirCells) {
  // a probe slides in through the canal from the left, and not from the right
  for (double x = 23; x > 0; x -= 0.5) {
    const double t = (x - 2.8) / 16.7, y = -10.3 + 1.8 * t, z = 3.0 - t;
    EXPECT_EQ(mastoid::valueAt(1e-3 * Vec3{x, y, z}), -1000.0);
  }
  int bone = 0, cells = 0;
  for (double x = 22; x > 0; x -= 0.2) bone += mastoid::valueAt(1e-3 * Vec3{-x, -8.5, 2}) > 300.0;
  EXPECT_GT(bone, 30);
  // within the process: air and walls in turn
  bone = 0;
  for (double z = -18; z < -6; z += 0.1)
    for (double y = 0; y < 10; y += 0.5) {
      const double value = mastoid::valueAt(1e-3 * Vec3{10, y, z});
      cells += value < -600.0;
      bone += value > 300.0;
    }
  EXPECT_GT(cells, 300);
  EXPECT_GT(bone, 300);
}

TEST(SkullStructures, HoldNoBone) {
  const Phantom phantom = makePhantom("demo").value();
  const haptics::Grid& grid = phantom.volume.grid;
  const auto* voxels = static_cast<const std::int16_t*>(phantom.volume.voxels.get());
  for (const PhantomStructure& one : phantomStructures("demo")) {
    std::int64_t within = 0, bone = 0;
    for (std::int64_t k = 0; k < grid.dims[2]; k += 2)
      for (std::int64_t j = 0; j < grid.dims[1]; j += 2)
        for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
          const double off = one.distance(grid.worldOf({double(i), double(j), double(k)})) + 1.5e-3;
          if (off > 0.0) {
            i += std::int64_t(0.5 * off / grid.spacing.x());  // none is nearer
            continue;
          }
          ++within;
          bone += voxels[(k * grid.dims[1] + j) * grid.dims[0] + i] >= 300;
        }
    EXPECT_GT(within, 30) << one.name;
    EXPECT_EQ(bone, 0) << one.name;
  }
}

}  // namespace
}  // namespace datasets
