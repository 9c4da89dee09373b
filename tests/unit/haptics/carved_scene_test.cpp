// SPDX-License-Identifier: BSD-3-Clause
// A scene that is cut while it is touched: no bound is too small, no arc is missed, and what is
// gone holds nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <vector>

#include "app/study/arcs/arcs.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/scene/carved_scene.h"
#include "tests/support/made.h"

namespace {

using datasets::Random;
using haptics::BurrCut;
using haptics::CarvedScene;
using haptics::Contacts;
using haptics::FieldKind;
using haptics::MaxPyramid;
using haptics::Vec3;
using haptics::Volume;
constexpr double kSide = study::arcs::h;  // m, of a voxel

std::unique_ptr<CarvedScene> carvedOf(const Volume& volume, FieldKind kind = FieldKind::Trilinear) {
  const auto scene =
      haptics::makeScene(made::shared(volume), made::point(), {.field = kind}).value();
  return CarvedScene::of(*scene).value();
}

/// As far as this work goes.
haptics::Removed advance(CarvedScene& carved, std::int64_t work) {
  auto budget = haptics::Budget::counted(1'000'000'000);
  return carved.advance({}, work, budget);
}

BurrCut anyCut(const Volume& volume, double s, Random& random) {
  const Vec3 from =
      volume.grid.worldOf(0.5 * Vec3(double(volume.grid.dims[0]), double(volume.grid.dims[1]),
                                     double(volume.grid.dims[2])));
  const Vec3 begin = from + random.box(0.5 * kSide * double(volume.grid.dims[0]));
  return {begin, begin + random.box(1.5 * kSide), random.in(0.6, 4.0) * kSide, s};
}

/// With a ball in the middle that may not be cut.
Volume keeping(Volume volume, double voxels) {
  const haptics::Grid& grid = volume.grid;
  std::vector<haptics::VoxelRun> runs;
  for (std::int32_t k = 0; k < grid.dims[2]; ++k)
    for (std::int32_t j = 0; j < grid.dims[1]; ++j)
      for (std::int32_t i = 0; i < grid.dims[0]; ++i)
        if ((2.0 * Vec3(i, j, k) -
             Vec3(double(grid.dims[0]), double(grid.dims[1]), double(grid.dims[2])))
                .norm() < 2.0 * voxels)
          runs.push_back({i, j, k, 1});
  const haptics::Tissues::Part part{runs, haptics::Tissues::kNever};
  volume.tissues = std::make_shared<const haptics::Tissues>(grid, std::span{&part, 1});
  return volume;
}

/// Every bound holds of the voxels as they are.
void expectBounds(const CarvedScene& carved) {
  const haptics::ScalarField& field = carved.scene()->field;
  const MaxPyramid fresh{*carved.scene()->volume, field.kind()};
  const auto& counts = fresh.finestCounts();
  for (std::int64_t n = 0; n < counts[0] * counts[1] * counts[2]; ++n) {
    ASSERT_GE(field.pyramid().finest()[n].greatest, fresh.finest()[n].greatest) << n;
    ASSERT_GE(field.pyramid().finest()[n].lipschitz, fresh.finest()[n].lipschitz) << n;
  }
}

TEST(CarvedScene, HasNoBoundThatIsTooSmall) {
  Random random{71};
  for (const auto kind : {FieldKind::Trilinear, FieldKind::CubicSpline})
    for (int n = 0; n < 7; ++n) {
      const auto type = made::kTypes[n];
      const haptics::Grid grid = made::oddGrid(n, {41, 38, 45}, random);
      Volume volume = made::randomVolume(grid, type, random);
      if (n % 2 == 1) volume = keeping(std::move(volume), 12.0);
      const auto carved = carvedOf(volume, kind);
      for (int round = 0; round < made::trials(20); ++round) {
        BurrCut cut = anyCut(volume, 0.0, random);
        cut.from_W = grid.worldOf(Vec3(20, 19, 22) + random.box(20.0));
        cut.to_W = cut.from_W + random.box(1e-3);
        cut.radius = random.in(0.5e-3, 4e-3);
        cut.isovalue = volume.least + random.in(0.1, 0.9) * (volume.greatest - volume.least);
        carved->begin(cut);
        while (!carved->isDone()) {
          advance(*carved, random.below(200) + 1);
          carved->refresh(3);
          if (round % 5 == 0) expectBounds(*carved);
          if (HasFatalFailure()) return;
        }
        carved->refresh(std::size_t(random.below(60)));
        expectBounds(*carved);
        if (HasFatalFailure()) return;
      }
    }
}

TEST(CarvedScene, IsMissedByNoArcBetweenCuts) {
  Random random{72};
  study::arcs::Tally tally;
  std::int64_t lowered = 0, cuts = 0;
  std::vector<study::arcs::Target> targets;
  targets.push_back(study::arcs::noise(5));
  targets.push_back(study::arcs::uprightPlates());
  targets.push_back(study::arcs::gyroid());
  // 100,000 cuts between a million arcs: a release has them
  const int batches = std::getenv("PALPATE_TEST_ALL") != nullptr ? 334 : 1;
  for (const study::arcs::Target& solid : targets)
    for (int batch = 0; batch < batches; ++batch) {
      const bool keeps = batch % 2 == 0 && &solid == &targets.back();
      const auto carved = carvedOf(keeps ? keeping(*solid.volume, 9.0) : *solid.volume);
      study::arcs::Target target{solid.name, *carved->scene()->volume, solid.isovalues, solid.half,
                                 solid.samples};
      const auto detect = [&carved](const study::arcs::Target&, double s,
                                    const study::arcs::Arc& arc) {
        return study::arcs::crossed({carved->scene()->field, s}, arc, haptics::Tolerances{kSide});
      };
      for (int round = 0; round < made::trials(100); ++round) {
        const double s = solid.isovalues[std::size_t(random.below(int(solid.isovalues.size())))];
        const BurrCut cut = anyCut(*target.volume, s, random);
        const haptics::BurrCarving asked{*target.volume, cut};
        target.steepest = std::max(target.steepest, std::sqrt(3.0) * asked.steepest() / kSide);
        carved->begin(cut);
        ++cuts;
        while (!carved->isDone()) {
          lowered += advance(*carved, 60).voxels;
          tally += study::arcs::shootPoints(target, 4, random, detect);
          carved->refresh(std::size_t(random.below(8)));
        }
      }
      expectBounds(*carved);
      if (HasFatalFailure()) return;
    }
  std::cout << cuts << " cuts, " << tally.arcs << " arcs, " << tally.met << " met, latest "
            << tally.latest << " voxel; " << lowered << " voxels lowered\n";
  EXPECT_EQ(tally.missed, 0);
  EXPECT_EQ(tally.late, 0);
  EXPECT_GT(tally.met, tally.arcs / 20);
  EXPECT_GT(lowered, made::trials(3000));
}

TEST(CarvedScene, IsExactAgainOnceAllIsRefreshed) {
  Random random{73};
  const Volume volume = datasets::whiteNoise(datasets::centredGrid(48, kSide), 3);
  const auto carved = carvedOf(volume);
  const Vec3 middle = volume.grid.worldOf(Vec3::Constant(24.0));
  carved->begin({middle, middle + Vec3(2.0 * kSide, 0.0, 0.0), 3.0 * kSide, 100.0});
  advance(*carved, 1'000'000);
  carved->rest();
  const auto waiting = carved->refresh(0);
  EXPECT_GT(waiting, 50U);
  EXPECT_EQ(carved->refresh(10), waiting - 10);
  EXPECT_EQ(carved->refresh(waiting), 0U);
  const MaxPyramid fresh{*carved->scene()->volume, FieldKind::Trilinear};
  const haptics::ScalarField& field = carved->scene()->field;
  const auto& counts = fresh.finestCounts();
  int looser = 0;
  for (std::int64_t n = 0; n < counts[0] * counts[1] * counts[2]; ++n) {
    EXPECT_EQ(field.pyramid().finest()[n].greatest, fresh.finest()[n].greatest);
    // the norm over 27 blocks together, not the greatest of their norms
    EXPECT_LE(field.pyramid().finest()[n].lipschitz, 1.5F * fresh.finest()[n].lipschitz);
    looser += field.pyramid().finest()[n].lipschitz > fresh.finest()[n].lipschitz;
  }
  EXPECT_GT(looser, 0);
  // the scan, and whoever has it, sees nothing of it
  EXPECT_EQ(std::memcmp(volume.voxels.get(),
                        datasets::whiteNoise(datasets::centredGrid(48, kSide), 3).voxels.get(),
                        std::size_t(volume.grid.voxelCount()) * sizeof(float)),
            0);
}

TEST(CarvedScene, DropsContactsWhoseCellIsCut) {
  const Volume volume = datasets::solid(datasets::centredGrid(32, kSide),
                                        [](const Vec3& p) { return p.norm() - 0.010; });
  const auto carved = carvedOf(volume);
  Contacts contacts;
  const Vec3 tool(0.0, 0.0, 0.010);
  for (const Vec3& r : {Vec3(0, 0, 0), Vec3(1e-3, 0, 0), Vec3(0.008, 0, -0.004)}) {
    haptics::Contact contact;
    contact.r_W = r;
    contacts.push(contact);
  }
  const double s = 0.5 * (volume.least + volume.greatest);
  carved->begin({tool, tool, 1.5e-3, s});
  EXPECT_GT(advance(*carved, 1'000'000).voxels, 10);
  carved->drop(contacts, tool);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].r_W.x(), 0.008);
}

}  // namespace
