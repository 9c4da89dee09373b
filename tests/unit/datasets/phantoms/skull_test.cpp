// SPDX-License-Identifier: BSD-3-Clause
// The demo head holds what makes it worth touching.
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/phantoms.h"

namespace datasets {
namespace {

using evaluator::fieldAt;
using haptics::Vec3;

class Skull : public testing::Test {
 protected:
  static void SetUpTestSuite() { phantom_ = makePhantom("demo").value(); }
  static void TearDownTestSuite() { phantom_ = {}; }

  /// HU at a place given in mm of W.
  static double at(double x_mm, double y_mm, double z_mm) {
    return fieldAt(phantom_.volume, 1e-3 * Vec3{x_mm, y_mm, z_mm});
  }
  /// Thicknesses [mm] of the runs at or above 300 HU on a segment, in order.
  static std::vector<double> bones(const Vec3& from_mm, const Vec3& to_mm) {
    std::vector<double> runs;
    const double length = (to_mm - from_mm).norm(), step = 0.05;
    bool in = false;
    for (double s = 0.0; s <= length; s += step) {
      const Vec3 p = from_mm + s / length * (to_mm - from_mm);
      const bool bone = at(p.x(), p.y(), p.z()) >= 300.0;
      if (bone && !in) runs.push_back(0.0);
      if (bone) runs.back() += step;
      in = bone;
    }
    return runs;
  }
  static Phantom phantom_;
};
Phantom Skull::phantom_;

TEST_F(Skull, IsAHeadInHounsfieldUnits) {
  const haptics::Volume& volume = phantom_.volume;
  EXPECT_EQ(volume.unit, "HU");
  EXPECT_EQ(volume.modality, "CT");
  EXPECT_EQ(volume.type, haptics::ScalarType::Int16);
  EXPECT_EQ(phantom_.isovalue, 300.0);
  EXPECT_NEAR(at(0, 25, 40), 36.0, 60.0);          // brain
  EXPECT_NEAR(at(-90, -110, 100), -1000.0, 60.0);  // air
}

TEST_F(Skull, TheVaultIsTwoTablesWithASpongeBetween) {
  // along a line through the right of the vault, away from sutures
  int tables = 0, sponge = 0;
  for (double z_mm = 40.0; z_mm <= 60.0; z_mm += 2.0) {
    std::vector<double> line;
    for (double x_mm = -80.0; x_mm <= -45.0; x_mm += 0.25) line.push_back(at(x_mm, 10, z_mm));
    double first = 0.0, middle = 3000.0, last = 0.0;
    std::size_t outer = 0, inner = line.size() - 1;
    while (outer < line.size() && line[outer] < 300.0) ++outer;
    while (inner > outer && line[inner] < 300.0) --inner;
    const std::size_t third = (inner - outer) / 3;
    for (std::size_t n = outer; n <= inner; ++n) {
      if (n < outer + third)
        first = std::max(first, line[n]);
      else if (n > inner - third)
        last = std::max(last, line[n]);
      else
        middle = std::min(middle, line[n]);
    }
    tables += first > 900.0 && last > 900.0;
    sponge += middle < 800.0;
  }
  EXPECT_GE(tables, 9);  // of 11 lines
  EXPECT_GE(sponge, 6);
}

TEST_F(Skull, TheFloorsOfTheOrbitsAreThinPlates) {
  for (const double side : {1.0, -1.0}) {
    int thin = 0, lines = 0;
    for (double y_mm = -56.0; y_mm <= -46.0; y_mm += 2.0) {
      // from the orbit straight down into the sinus of the upper jaw
      const auto runs = bones({side * 29, y_mm, -4}, {side * 29, y_mm, -24});
      if (runs.empty()) continue;
      ++lines;
      thin += runs.size() == 1 && runs.front() > 0.3 && runs.front() < 3.0;
    }
    EXPECT_GE(lines, 4);
    EXPECT_GE(thin, 3);
  }
}

TEST_F(Skull, TheMastoidsAreFullOfAirCells) {
  for (const double side : {1.0, -1.0}) {
    int bubbles = 0;
    for (double y_mm = 22.0; y_mm <= 38.0; y_mm += 2.0)
      for (double z_mm = -36.0; z_mm <= -18.0; z_mm += 2.0) {
        // walls between bubbles on a line across
        const auto runs = bones({side * 44, y_mm, z_mm}, {side * 66, y_mm, z_mm});
        bubbles += static_cast<int>(runs.size()) - 1;
      }
    EXPECT_GT(bubbles, 40);
  }
}

TEST_F(Skull, TheBurrHoleIsOnTheLeft) {
  // down the hole's axis on the left, and down its mirror image
  EXPECT_TRUE(bones({48, 25, 106}, {36, 23.3, 68}).empty());
  EXPECT_FALSE(bones({-48, 25, 106}, {-36, 23.3, 68}).empty());
}

TEST_F(Skull, NoiseIsThatOfAScanner) {
  std::vector<double> air;
  for (double x_mm = -88; x_mm < -78; ++x_mm)
    for (double y_mm = -110; y_mm < -90; ++y_mm)
      for (double z_mm = 80; z_mm < 100; ++z_mm)
        air.push_back(at(x_mm + 0.5, y_mm + 0.5, z_mm + 0.5));
  const double mean =
      std::accumulate(air.begin(), air.end(), 0.0) / static_cast<double>(air.size());
  double squares = 0.0;
  for (const double v : air) squares += (v - mean) * (v - mean);
  EXPECT_NEAR(mean, -1000.0, 5.0);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(air.size())), 15.0, 3.0);
}

}  // namespace
}  // namespace datasets
