// SPDX-License-Identifier: BSD-3-Clause
// Table and holder go, ears and nose stay.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "datasets/edits/edit_history.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/support/made.h"

namespace {

using namespace datasets;
using namespace haptics;
using datasets::Random;

constexpr double kVoxel = 2e-3;  // m

/// A head on its back in a holder on a table; y runs down.
struct LyingHead {
  bool with_holder = true;
  bool in_units = true;
  bool hollow = false;  // a wall and a base of bone, open at the top; beside its holder

  static double head(const Vec3& p) {  // its distance [m], about
    const double skull = (p.cwiseQuotient(Vec3{0.075, 0.09, 0.11}).norm() - 1.0) * 0.075;
    // 6 mm of an ear on each side, a nose upwards
    const Vec3 beside{std::abs(p.x()), p.y(), p.z()};
    const Vec3 ear = (beside - Vec3{0.083, 0.0, 0.0}).cwiseAbs() - Vec3{0.012, 0.003, 0.02};
    const Vec3 nose = (p - Vec3{0.0, -0.1, 0.0}).cwiseAbs() - Vec3{0.008, 0.02, 0.015};
    return std::min({skull, ear.maxCoeff(), nose.maxCoeff()});
  }
  static double holder(const Vec3& p) {
    // a shell of 5 mm about the back of the head, 8 mm away; a table of 4 mm; a foot that joins
    // them; and a bar of 4 mm that reaches the head
    const double away = std::hypot(p.x(), p.y()) - 0.105;
    const double shell = std::max(std::abs(away) - 2.5e-3, -p.y());
    const double table = std::max(std::abs(p.y() - 0.118) - 2e-3, std::abs(p.x()) - 0.11);
    const Vec3 foot = (p - Vec3{0.0, 0.112, 0.0}).cwiseAbs() - Vec3{0.01, 0.006, 0.05};
    const Vec3 bar = (p - Vec3{0.0, 0.097, 0.0}).cwiseAbs() - Vec3{0.002, 0.01, 0.002};
    return std::min({shell, table, foot.maxCoeff(), bar.maxCoeff()});
  }
  /// Where it is hollow: its distance from the bone.
  static double skull(const Vec3& p) {
    const double wall = std::max(std::abs(head(p) + 0.003) - 0.003, p.z() - 0.07);
    return std::min(wall, std::max(head(p), p.z() + 0.06));
  }
  static double apart(const Vec3& p) {
    return std::max(holder(p), 0.102 - std::hypot(p.x(), p.y()));
  }
  double value(const Vec3& p, double grain) const {
    const auto filled = [](double d) { return std::clamp(0.5 - d / kVoxel, 0.0, 1.0); };
    if (hollow) return std::max(filled(skull(p)), filled(apart(p))) * 2000.0 - 1000.0 + grain;
    const double bone = filled(std::abs(head(p) + 0.012) - 0.003);
    const double matter = std::max(filled(head(p)) * (40.0 + 960.0 * bone + 1000.0),
                                   with_holder ? filled(holder(p)) * 1400.0 : 0.0);
    return matter - (in_units ? 1000.0 : 0.0) + grain;
  }
};

std::shared_ptr<const Volume> lying(const LyingHead& head) {
  const Grid grid = datasets::centredGrid(120, 128, 112, kVoxel);
  Random random{211};
  Volume volume = datasets::filled(
      grid, ScalarType::Int16, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return head.value(grid.worldOf(Vec3{double(i), double(j), double(k)}),
                          random.in(-20.0, 20.0));
      });
  if (head.in_units) volume.unit = "HU";
  return made::shared(std::move(volume));
}

TEST(RemoveHolder, TakesTableAndHolderAndLeavesEarsAndNose) {
  for (const bool in_units : {true, false})
    for (const double over_air : {700.0, 1300.0}) {  // skin, and bone
      const auto scan = lying({true, in_units});
      const double isovalue = over_air - (in_units ? 1000.0 : 0.0);
      const std::vector<Edit> edits{RemoveHolder{isovalue}};
      const auto result = edited(scan, edits);
      ASSERT_TRUE(result);
      const auto* before = static_cast<const std::int16_t*>(scan->voxels.get());
      const auto* after = static_cast<const std::int16_t*>((*result)->voxels.get());
      std::int64_t patient = 0, lost = 0, holder = 0, left = 0;
      for (std::int64_t n = 0; n < scan->grid.voxelCount(); ++n) {
        const auto& dims = scan->grid.dims;
        const Vec3 p = scan->grid.worldOf(Vec3{double(n % dims[0]), double(n / dims[0] % dims[1]),
                                               double(n / (dims[0] * dims[1]))});
        if (LyingHead::head(p) < 0.0 && before[n] >= isovalue) {
          ++patient;
          lost += after[n] != before[n];
        }
        // where the bar touches the head, some of it may stay
        if (LyingHead::holder(p) < 0.0 && LyingHead::head(p) > 5e-3 && before[n] >= isovalue) {
          ++holder;
          left += after[n] >= isovalue;
        }
      }
      EXPECT_GT(patient, 20'000);
      EXPECT_GT(holder, 8'000);
      EXPECT_EQ(lost, 0) << in_units << " " << over_air;
      EXPECT_EQ(left, 0) << in_units << " " << over_air;
    }
}

// The walls of a skull without a brain are as thin as a holder's, and its base is thick.
TEST(RemoveHolder, TakesNothingOfAHollowSkull) {
  const auto scan = lying({.hollow = true});
  const std::vector<Edit> edits{RemoveHolder{300.0}};
  const auto result = edited(scan, edits);
  ASSERT_TRUE(result);
  const auto* before = static_cast<const std::int16_t*>(scan->voxels.get());
  const auto* after = static_cast<const std::int16_t*>((*result)->voxels.get());
  std::int64_t skull = 0, lost = 0, left = 0;
  for (std::int64_t n = 0; n < scan->grid.voxelCount(); ++n) {
    if (before[n] < 300) continue;
    const auto& dims = scan->grid.dims;
    const Vec3 p = scan->grid.worldOf(
        Vec3{double(n % dims[0]), double(n / dims[0] % dims[1]), double(n / (dims[0] * dims[1]))});
    const bool bone = LyingHead::skull(p) < LyingHead::apart(p);
    skull += bone;
    lost += bone && after[n] != before[n];
    left += !bone && after[n] >= 300;
  }
  EXPECT_GT(skull, 50'000);
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(left, 0);
}

TEST(RemoveHolder, SaysSoWhereThereIsNone) {
  const auto removal = removalOf(*lying({false, true}), RemoveHolder{-300.0}, -300.0);
  ASSERT_FALSE(removal);
  EXPECT_EQ(removal.error().reason, "nothing");
  EXPECT_EQ(removal.error().message.id, "edit-no-holder");
  // and where nothing is solid
  const Grid grid = datasets::centredGrid(20, kVoxel);
  const auto air = made::shared(datasets::filled(
      grid, ScalarType::Int16, [](auto i, auto, auto) { return i == 0 ? -1000.0 : -990.0; }));
  EXPECT_FALSE(removalOf(*air, RemoveHolder{500.0}, 500.0));
}

}  // namespace
