// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/collision/motion_rows.h"
#include "haptics/core/voxel_memory.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"

namespace {

using datasets::Random;
using haptics::Budget;
using haptics::FieldKind;
using haptics::Isosurface;
using haptics::makeScene;
using haptics::MotionRow;
using haptics::NormalKind;
using haptics::Pose;
using haptics::Scene;
using haptics::Vec3;
using made::at;
using millimetre::h;
using millimetre::unlimited;

TEST(Scene, SharesTheFieldOfTheOneBeforeWhereVolumeAndKindAreTheSame) {
  const auto volume = made::shared(
      datasets::solid(datasets::centredGrid(24, h), [](const Vec3& p) { return p.z(); }));
  const auto first = makeScene(volume, made::point()).value();
  const auto same =
      makeScene(volume, made::tool(datasets::ballPoints(50, 3e-3)), {}, first.get()).value();
  EXPECT_EQ(&same->field, &first->field);
  EXPECT_NE(same->id, first->id);
  const auto smooth =
      makeScene(volume, made::point(), {FieldKind::CubicSpline, NormalKind::Cell}, first.get())
          .value();
  EXPECT_NE(&smooth->field, &first->field);
  EXPECT_EQ(smooth->field.kind(), FieldKind::CubicSpline);
  EXPECT_EQ(smooth->normal, NormalKind::Cell);
  const auto other = made::shared(*volume);
  EXPECT_NE(&makeScene(other, made::point(), {}, first.get()).value()->field, &first->field);
}

/// A volume one edit away from another: the voxel (12, 12, 2) is lowered in a view of its own.
std::shared_ptr<const haptics::Volume> oneVoxelLowered(
    const std::shared_ptr<const haptics::Volume>& before,
    const std::vector<haptics::VoxelBox>& told) {
  haptics::Volume after = *before;
  const auto view = before->memory->privateView().value();
  static_cast<float*>(view.get())[(2 * 24 + 12) * 24 + 12] = static_cast<float>(before->least);
  after.voxels = view;
  auto edit = std::make_shared<haptics::Derivation>();
  edit->scan = before;
  edit->neighbour = before;
  edit->changed = told;
  after.derivation = edit;
  return made::shared(std::move(after));
}

TEST(Scene, RenewsTheBoundsOfItsNeighbourWhereAnEditChangedIt) {
  const auto scan = made::shared(
      datasets::solid(datasets::centredGrid(24, h), [](const Vec3& p) { return p.z(); }));
  const auto first = makeScene(scan, made::point()).value();
  const auto volume = oneVoxelLowered(scan, {{{12, 12, 2}, {13, 13, 3}}});
  const auto second = makeScene(volume, made::point(), {}, first.get()).value();
  EXPECT_TRUE((second->field.pyramid() == haptics::MaxPyramid{*volume}));
  EXPECT_FALSE(second->field.pyramid() == first->field.pyramid());
  // back to the scan, which knows of no edit
  const auto third = makeScene(scan, made::point(), {}, second.get()).value();
  EXPECT_TRUE(third->field.pyramid() == first->field.pyramid());
  // what an edit does not tell of is not looked at: the renewal is used
  const auto silent = oneVoxelLowered(scan, {});
  EXPECT_TRUE(makeScene(silent, made::point(), {}, first.get()).value()->field.pyramid() ==
              first->field.pyramid());
  // no neighbour, or another kind of field: all is built
  const auto other = makeScene(made::shared(*scan), made::point()).value();
  for (const auto& [scene, kind] :
       {std::pair{other, FieldKind::Trilinear}, {first, FieldKind::CubicSpline}}) {
    const auto built = makeScene(silent, made::point(), {kind}, scene.get()).value();
    EXPECT_TRUE((built->field.pyramid() == haptics::MaxPyramid{*silent, kind}));
  }
}

/// The volume with another crop, one edit after `before`.
std::shared_ptr<const haptics::Volume> croppedTo(
    const std::shared_ptr<const haptics::Volume>& before,
    const std::optional<haptics::VoxelBox>& crop, const std::vector<haptics::VoxelBox>& told) {
  haptics::Volume after = *before;
  after.crop = crop;
  auto edit = std::make_shared<haptics::Derivation>();
  edit->scan = before->derivation ? before->derivation->scan : before;
  edit->neighbour = before;
  edit->changed = told;
  after.derivation = edit;
  return made::shared(std::move(after));
}

TEST(Scene, TakesTheScansFieldWhereACropIsTakenBack) {
  const haptics::VoxelBox narrow{{8, 6, 2}, {16, 20, 24}}, wide{{4, 6, 1}, {20, 23, 24}};
  for (const FieldKind kind : {FieldKind::Trilinear, FieldKind::CubicSpline}) {
    const haptics::SceneOptions options{.field = kind};
    const auto scan = made::shared(
        datasets::solid(datasets::centredGrid(24, h), [](const Vec3& p) { return p.z(); }));
    const auto first = makeScene(scan, made::point(), options).value();
    EXPECT_EQ(first->scan_field, first->shared_field);
    const auto one = croppedTo(scan, narrow, {});
    const auto cropped = makeScene(one, made::point(), options, first.get()).value();
    EXPECT_TRUE((cropped->field.pyramid() == haptics::MaxPyramid{*one, kind}));
    EXPECT_EQ(cropped->scan_field, first->shared_field);
    // a wider crop looks at no voxel: what an edit tells of it is not needed
    const auto two = croppedTo(one, wide, {});
    const auto wider = makeScene(two, made::point(), options, cropped.get()).value();
    EXPECT_TRUE((wider->field.pyramid() == haptics::MaxPyramid{*two, kind}));
    const auto again = makeScene(scan, made::point(), options, wider.get()).value();
    EXPECT_EQ(&again->field, &first->field);
    // a cut within a crop, and the crop taken back: the voxels are no longer the scan's
    const auto cut = oneVoxelLowered(scan, {{{12, 12, 2}, {13, 13, 3}}});
    const auto lowered = makeScene(cut, made::point(), options, first.get()).value();
    const auto both = croppedTo(cut, narrow, {});
    const auto beneath = makeScene(both, made::point(), options, lowered.get()).value();
    EXPECT_TRUE((beneath->field.pyramid() == haptics::MaxPyramid{*both, kind}));
    const auto without = croppedTo(both, {}, {});
    const auto back = makeScene(without, made::point(), options, beneath.get()).value();
    EXPECT_TRUE((back->field.pyramid() == haptics::MaxPyramid{*without, kind}));
    EXPECT_FALSE(back->field.pyramid() == first->field.pyramid());
    // another kind of field has another pyramid
    const auto other_kind =
        kind == FieldKind::Trilinear ? FieldKind::CubicSpline : FieldKind::Trilinear;
    const auto other = makeScene(scan, made::point(), {.field = other_kind}, cropped.get()).value();
    EXPECT_TRUE((other->field.pyramid() == haptics::MaxPyramid{*scan, other_kind}));
  }
}

TEST(Scene, OutlivesTheOneWhoseFieldItShares) {
  const auto volume = made::shared(
      datasets::solid(datasets::centredGrid(24, h), [](const Vec3& p) { return p.z(); }));
  auto first = makeScene(volume, made::point()).value();
  const auto second = makeScene(volume, made::point(), {}, first.get()).value();
  first.reset();
  EXPECT_NEAR(second->field.value(second->field.indexOf(Vec3::Zero())), datasets::kSolidIso, 1e-3);
}

TEST(Scene, TellsWhatWasBuiltForIt) {
  const auto volume = made::shared(
      datasets::solid(datasets::centredGrid(40, h), [](const Vec3& p) { return p.z(); }));
  const auto scene = makeScene(volume, made::tool(datasets::ballPoints(500, 3e-3))).value();
  ASSERT_GE(scene->structures.size(), 2u);
  EXPECT_EQ(scene->structures[0].name, "pyramid");
  EXPECT_EQ(scene->structures[0].bytes, scene->field.pyramid().bytes());
  EXPECT_GT(scene->structures[0].build_time, 0.0);
  EXPECT_EQ(scene->structures[1].name, "shell_tree");
  EXPECT_GE(scene->structures[1].bytes, 500 * 3 * sizeof(double));
  const auto again = makeScene(volume, made::point(), {}, scene.get()).value();
  EXPECT_EQ(again->structures[0].build_time, 0.0);
}

/// The rows of a tool at a pose, and the angle of each normal from the truth: rms in degrees.
template <class Normal>
double offTruth(const Scene& scene, NormalKind kind, const Pose& X_WP, Normal&& normal,
                int& count) {
  const Isosurface solid{scene.field, datasets::kSolidIso};
  haptics::Clearance clearance{scene.tree};
  Budget budget = unlimited();
  EXPECT_EQ(clearance.collect(solid, scene.tree, X_WP, scene.lengths.band, budget),
            haptics::Clearance::Verdict::Legal);
  haptics::SurfaceRows surface;
  haptics::gatherRows({solid, scene.tree, X_WP, clearance}, scene.lengths, kind, {}, surface,
                      budget);
  double sum = 0.0;
  for (const MotionRow& row : surface.rows) {
    const Vec3 n = normal(X_WP.translation() + row.r_W);
    const double angle = std::acos(std::clamp(n.dot(row.n_W), -1.0, 1.0)) * 180.0 / M_PI;
    sum += angle * angle;
  }
  count += static_cast<int>(surface.rows.size());
  return sum;
}

// a tick cut anywhere in the rows goes on with them in the next: the same rows, to the bit
TEST(Rows, AreTheSameWhereverTheyWereCut) {
  Random random{64};
  int chosen = 0;
  for (const haptics::FieldKind field :
       {haptics::FieldKind::Trilinear, haptics::FieldKind::CubicSpline})
    for (const NormalKind kind : {NormalKind::Central, NormalKind::Cell, NormalKind::Spline}) {
      const auto scene =
          makeScene(
              made::shared(datasets::sampledFloat(
                  datasets::centredGrid(40, h),
                  [&](const Vec3& p) { return 1e5 * (0.0103 - p.norm()) + random.in(-2, 2); })),
              made::tool(datasets::ballPoints(500, 12.35e-3)), {.field = field})
              .value();
      const Isosurface solid{scene->field, -200.0};
      const Pose X = Pose::Identity();
      haptics::Clearance clearance{scene->tree};
      Budget budget = unlimited();
      ASSERT_EQ(clearance.collect(solid, scene->tree, X, scene->lengths.band, budget),
                haptics::Clearance::Verdict::Legal);
      const auto gather = [&](haptics::SurfaceRows& surface, Budget& some) {
        return haptics::gatherRows({solid, scene->tree, X, clearance}, scene->lengths, kind, {},
                                   surface, some);
      };
      haptics::SurfaceRows whole;
      budget = unlimited();
      ASSERT_TRUE(gather(whole, budget));
      chosen += whole.candidates.size() > haptics::kMostSurfaceRows;
      for (const int least : {2, 50, 300}) {
        haptics::SurfaceRows parts;
        int cuts = 0;
        for (;; ++cuts) {
          ASSERT_LT(cuts, 2000);
          const int work = least + random.below(least);
          Budget some = Budget::counted(work);
          const bool through = gather(parts, some);
          ASSERT_LE(some.spent(), work + 250);  // what is done between two looks at the budget
          if (through) break;
        }
        EXPECT_GT(cuts, 0);
        ASSERT_EQ(parts.candidates.size(), whole.candidates.size());
        ASSERT_EQ(parts.rows.size(), whole.rows.size());
        for (std::size_t i = 0; i < whole.rows.size(); ++i) {
          ASSERT_EQ(parts.rows[i].n_W, whole.rows[i].n_W);
          ASSERT_EQ(parts.rows[i].r_W, whole.rows[i].r_W);
          ASSERT_EQ(parts.rows[i].room, whole.rows[i].room);
        }
        // and they are kept
        Budget none = Budget::counted(0);
        EXPECT_TRUE(gather(parts, none));
      }
    }
  EXPECT_GT(chosen, 0);
}

TEST(Normals, AreThoseOfALinearFieldWhateverTheKind) {
  Random random{61};
  for (int k = 0; k < 8; ++k) {
    const haptics::Grid grid = made::oddGrid(k, {20, 20, 20}, random);
    const Vec3 n = random.direction();
    const Vec3 middle = grid.worldOf({9.5, 9.5, 9.5});
    const auto scene =
        makeScene(made::shared(datasets::sampledFloat(
                      grid, [&](const Vec3& p) { return 1000.0 - 4e6 * n.dot(p - middle); })),
                  made::point())
            .value();
    for (const NormalKind kind : {NormalKind::Central, NormalKind::Cell, NormalKind::Spline}) {
      int count = 0;
      const Pose X = at(middle + 0.05 * grid.spacing.minCoeff() * n);
      EXPECT_LT(std::sqrt(offTruth(
                    *scene, kind, X, [&](const Vec3&) { return n; }, count)),
                0.05);
      EXPECT_EQ(count, 1);
    }
  }
}

// points just outside a ball in noise of 2 % of the step over a voxel
TEST(Normals, OfWideGradientsAreNearerTheTruthInNoise) {
  std::mt19937 engine{62};
  std::normal_distribution<double> grain{0.0, 80.0};
  const double radius = 10.3e-3;
  const auto scene =
      makeScene(made::shared(datasets::sampledFloat(datasets::centredGrid(40, h),
                                                    [&](const Vec3& p) {
                                                      const double d = (p.norm() - radius) / h;
                                                      return 1000.0 - 4000.0 * d + grain(engine);
                                                    })),
                made::point())
          .value();
  Random random{63};
  double off[3] = {};
  int counts[3] = {};
  const Isosurface solid{scene->field, datasets::kSolidIso};
  for (int trial = 0; trial < 3000; ++trial) {
    const Vec3 p = (radius + 0.05 * h) * random.direction();
    if (solid.inside(p)) continue;
    for (const NormalKind kind : {NormalKind::Central, NormalKind::Cell, NormalKind::Spline}) {
      const auto i = static_cast<std::size_t>(kind);
      off[i] += offTruth(
          *scene, kind, at(p), [](const Vec3& q) { return q.normalized().eval(); }, counts[i]);
    }
  }
  double rms[3];
  for (int i = 0; i < 3; ++i) rms[i] = std::sqrt(off[i] / counts[i]);
  EXPECT_GT(counts[0], 1000);
  EXPECT_LT(rms[0], 0.7 * rms[1]);
  EXPECT_LT(rms[2], 0.7 * rms[1]);
  EXPECT_LT(rms[0], 3.0);
}

}  // namespace
