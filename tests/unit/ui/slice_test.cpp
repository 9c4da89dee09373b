// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/slice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/turned_scan.h"
#include "tests/unit/ui/volumes.h"
#include "ui/controls/lengths.h"
#include "ui/props/orientation.h"
#include "ui/views/grey_presets.h"
#include "ui/views/slice_readout.h"

namespace {

using haptics::Vec3;
using ui::Interpolation;
using ui::SlabKind;

double waves(const Vec3& u) {
  return 500.0 * std::sin(0.7 * u.x()) + 300.0 * std::cos(0.9 * u.y()) + 100.0 * u.z();
}

haptics::Grid straightGrid() {
  haptics::Grid grid;
  grid.dims = {20, 16, 12};
  grid.spacing = {1e-3, 1e-3, 2e-3};
  return grid;
}

std::shared_ptr<const haptics::Volume> cropped(const haptics::Grid& grid) {
  // what is cropped away is far brighter than what is kept
  haptics::Volume volume = volumes::made(grid, [](const Vec3& u) {
    const bool kept =
        u.x() > 4.5 && u.x() < 12.5 && u.y() > 3.5 && u.y() < 11.5 && u.z() > 2.5 && u.z() < 7.5;
    return kept ? 100.0 : u.norm() < 0.5 ? -1000.0 : 30000.0;
  });
  volume.crop = haptics::VoxelBox{{5, 4, 3}, {13, 12, 8}};
  return std::make_shared<const haptics::Volume>(std::move(volume));
}

TEST(Slice, OfASlabBelowAMillimetreIsAsThinAsIsChosen) {
  haptics::Grid grid = straightGrid();
  grid.spacing = {0.1e-3, 0.1e-3, 0.1e-3};
  // one bright layer, 0.4 mm from the plane
  const auto volume = std::make_shared<const haptics::Volume>(
      volumes::made(grid, [](const Vec3& u) { return u.y() == 12.0 ? 100.0 : 0.0; }));
  ui::Slice slice;
  slice.show(ui::pictureOf(volume));
  const auto greatestWithin = [&](double thickness_mm) {
    slice.cut(ui::axesOf(ui::Plane::Coronal), grid.worldOf({9.5, 8.0, 5.5}) * 1e3, {20, 12}, 0.1,
              {.slab = SlabKind::Maximum, .thickness_mm = thickness_mm});
    return slice.valueAt({10, 6}).value_or(-1.0);
  };
  EXPECT_NEAR(greatestWithin(0.1), 0.0, 1e-3);
  EXPECT_NEAR(greatestWithin(0.6), 0.0, 1e-3);
  EXPECT_NEAR(greatestWithin(0.8), 100.0, 1e-3);
}

TEST(Slice, OfASlabIsTheGreatestOrTheMeanOfItsPlanes) {
  const haptics::Grid grid = straightGrid();
  const auto volume = std::make_shared<const haptics::Volume>(volumes::made(grid, waves));
  ui::Slice slice;
  slice.show(ui::pictureOf(volume));
  const ui::PlaneAxes axes = ui::axesOf(ui::Plane::Coronal);  // along j, voxels of 1 mm
  const Vec3 centre_mm = grid.worldOf({9.5, 8.0, 5.5}) * 1e3;
  for (const SlabKind kind : {SlabKind::Maximum, SlabKind::Mean}) {
    slice.cut(axes, centre_mm, {20, 12}, 1.0, {.slab = kind, .thickness_mm = 4.0});
    int seen = 0;
    for (int i = 0; i < 20; ++i) {
      // the row of voxels k = 5 is 5 mm below the middle plus 1
      const double k = 5.0;
      const Vec3 at_mm = grid.worldOf({double(i), 8.0, k}) * 1e3 - centre_mm;
      const QPoint pixel{static_cast<int>(std::lround(at_mm.x() + 9.5)),
                         static_cast<int>(std::floor(5.5 - at_mm.z()))};
      const auto value = slice.valueAt(pixel);
      ASSERT_TRUE(value);
      // pixels lie half a millimetre beside the row: a quarter of the next one
      double greatest = -1e9, sum = 0.0;
      for (int j = 6; j <= 10; ++j) {
        const double here = std::round(waves({double(i), double(j), 5.0}));
        const double next = std::round(waves({double(i), double(j), 6.0}));
        const double mixed = 0.75 * here + 0.25 * next;
        greatest = std::max(greatest, mixed);
        sum += mixed;
      }
      EXPECT_NEAR(*value, kind == SlabKind::Maximum ? greatest : sum / 5.0, 0.51) << "voxel " << i;
      ++seen;
    }
    EXPECT_EQ(seen, 20);
  }
}

TEST(Slice, ShowsVoxelsAsTheyAreWhereItDoesNotInterpolate) {
  const haptics::Grid grid = volumes::turnedGrid({20, 16, 12});
  const auto volume = std::make_shared<const haptics::Volume>(volumes::made(grid, waves));
  ui::Slice slice;
  slice.show(ui::pictureOf(volume));
  const Vec3 centre_mm = grid.worldOf({9.5, 8.0, 5.5}) * 1e3;
  const ui::PlaneAxes axes = ui::axesOf(ui::Plane::Sagittal);
  int inside = 0;
  for (const auto interpolation : {Interpolation::Nearest, Interpolation::Linear}) {
    slice.cut(axes, centre_mm, {60, 60}, 0.13, {.interpolation = interpolation});
    int between = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x) {
        const auto value = slice.valueAt({x, y});
        if (!value) continue;
        ++inside;
        between += *value != std::round(*value);
      }
    if (interpolation == Interpolation::Nearest)
      EXPECT_EQ(between, 0);
    else
      EXPECT_GT(between, 500);
  }
  EXPECT_GT(inside, 2'000);
}

TEST(Slice, ShowsNothingOfWhatACropTookAway) {
  for (const haptics::Grid& grid : {straightGrid(), volumes::turnedGrid({20, 16, 12})}) {
    const auto volume = cropped(grid);
    ui::Slice slice;
    slice.show(ui::pictureOf(volume));
    int inside = 0, outside = 0;
    for (const ui::Plane plane : {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal})
      for (const auto& look :
           {ui::SliceLook{}, ui::SliceLook{.interpolation = Interpolation::Nearest},
            ui::SliceLook{.slab = SlabKind::Maximum, .thickness_mm = 30.0}})
        for (const double index : {3.0, 4.0, 5.2, 7.4, 7.6, 9.0}) {
          const Vec3 centre_mm = grid.worldOf({index, index, index}) * 1e3;
          slice.cut(ui::axesOf(plane), centre_mm, {64, 64}, 0.4, look);
          const QImage image = slice.picture({.level = 15000.0, .width = 30000.0});
          for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
              const auto value = slice.valueAt({x, y});
              value ? ++inside : ++outside;
              if (value) {
                ASSERT_NEAR(*value, 100.0, 0.5);
              }
              ASSERT_LT(qGray(image.pixel(x, y)), 10);  // the bright voxels would be white
            }
        }
    EXPECT_GT(inside, 5'000);
    EXPECT_GT(outside, 5'000);
  }
}

TEST(Slice, SaysDirectionsAsLetters) {
  EXPECT_EQ(ui::lettersTowards(Vec3::UnitX()), "L");
  EXPECT_EQ(ui::lettersTowards(-Vec3::UnitX()), "R");
  EXPECT_EQ(ui::lettersTowards(Vec3{0.1, -0.9, 0.1}.normalized()), "A");
  // little beside the main one
  EXPECT_EQ(ui::lettersTowards(Vec3{-0.42, 0.4, 0.8}.normalized()), "S");
  EXPECT_EQ(ui::lettersTowards(Vec3{0.8, -0.6, 0.0}), "L");
  EXPECT_EQ(ui::lettersTowards(Vec3{0.69, -0.68, 0.25}), "LA");
  EXPECT_EQ(ui::lettersTowards(Vec3{0.5, 0.6, -0.62}.normalized()), "IP");
  const auto letters = ui::lettersOf(ui::axesOf(ui::Plane::Coronal));
  EXPECT_EQ(letters, (std::array<QString, 4>{"R", "L", "S", "I"}));
}

TEST(Slice, SaysLengthsInTheUnitThatWasChosen) {
  EXPECT_EQ(ui::rulerWords(5.0), "5 mm");
  EXPECT_EQ(ui::rulerWords(0.02), "0.02 mm");
  EXPECT_EQ(ui::positionWords(Vec3{-12.34, 4.0, 34.5}, true), "LPS -12.3, 4.0, 34.5 mm");
  ui::setLengthUnit(ui::LengthUnit::Centimetres);
  EXPECT_EQ(ui::rulerWords(5.0), "0.5 cm");
  EXPECT_EQ(ui::rulerWords(0.02), "0.002 cm");
  EXPECT_EQ(ui::rulerWords(200.0), "20 cm");
  EXPECT_EQ(ui::positionWords(Vec3{-12.34, 4.0, 34.5}, true), "LPS -1.23, 0.40, 3.45 cm");
  ui::setLengthUnit(ui::LengthUnit::Millimetres);
}

TEST(GreyPresets, AreTheUsualWindowsAndTheFullRange) {
  const auto presets = ui::hounsfieldPresets();
  ASSERT_EQ(presets.size(), 6U);
  const auto black = [](const ui::GreyWindow& g) { return g.level - 0.5 * g.width; };
  const auto white = [](const ui::GreyWindow& g) { return g.level + 0.5 * g.width; };
  EXPECT_EQ(black(presets[0].grey), -160.0);  // soft tissue
  EXPECT_EQ(black(presets[1].grey), -500.0);  // bone
  EXPECT_EQ(white(presets[2].grey), 150.0);   // lung
  EXPECT_EQ(white(presets[3].grey), 80.0);    // brain
  EXPECT_EQ(black(presets[4].grey), -125.0);  // mediastinum
  EXPECT_EQ(white(presets[5].grey), 2700.0);  // temporal bone: to the densest
  const haptics::Volume volume = volumes::made(straightGrid(), waves);
  EXPECT_EQ(black(ui::fullRange(volume)), volume.least);
  EXPECT_EQ(white(ui::fullRange(volume)), volume.greatest);
}

TEST(Slice, FollowsTheConventionHoweverTheFileTurnsItsAxes) {
  // grows towards L, P and S, each at its own rate
  const auto rampAt = [](const Vec3& p_mm) {
    return Vec3(10.0, 25.0, 60.0).dot(p_mm - turned::kFirst_mm);
  };
  const Vec3 middle = turned::placeOf_mm({5.0, 7.0, 9.0});
  struct Shown {
    ui::Plane plane;
    Vec3 right, down;  // of the picture, in L, P and S
  };
  const Shown all[] = {{ui::Plane::Axial, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
                       {ui::Plane::Coronal, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}},
                       {ui::Plane::Sagittal, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}}};
  constexpr int kPixels = 9;
  constexpr double kPixel_mm = 1.5;
  for (const haptics::Mat3& axes : turned::orientations()) {
    const haptics::Grid grid = turned::gridAlong(axes);
    const auto volume = std::make_shared<const haptics::Volume>(
        volumes::made(grid, [&](const Vec3& index) { return rampAt(1e3 * grid.worldOf(index)); }));
    ui::Slice slice;
    slice.show(ui::pictureOf(volume));
    for (const Shown& shown : all) {
      slice.cut(ui::axesOf(shown.plane), middle, {kPixels, kPixels}, kPixel_mm, {});
      for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
          const Vec3 p_mm = middle + kPixel_mm * ((x - 4) * shown.right + (y - 4) * shown.down);
          ASSERT_NEAR(slice.valueAt({x, y}).value_or(-1e9), rampAt(p_mm), 0.1)
              << int(shown.plane) << " " << x << " " << y << "\n"
              << axes;
        }
    }
  }
}

}  // namespace
