// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <ctime>
#include <vector>

#include "datasets/phantoms/noise.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/phantoms/sampling.h"
#include "tests/support/made.h"
#include "tests/support/sentence.h"

namespace datasets {
namespace {

TEST(Phantoms, AnUnknownNameIsToldTheKnownOnes) {
  const auto phantom = makePhantom("sphare");
  ASSERT_FALSE(phantom.has_value());
  EXPECT_EQ(phantom.error().kind, haptics::Error::Kind::NotFound);
  EXPECT_NE(sentence(phantom.error()).find("sphare"), std::string::npos);
  for (const std::string& name : phantomNames())
    EXPECT_NE(sentence(phantom.error()).find(name), std::string::npos) << name;
}

TEST(Phantoms, CancelEndsTheMakingWithinALayer) {
  const std::atomic<bool> cancelled = true;
  for (const std::string& name : phantomNames()) {
    const auto phantom = makePhantom(name, &cancelled);
    ASSERT_FALSE(phantom.has_value()) << name;
    EXPECT_EQ(phantom.error().kind, haptics::Error::Kind::Cancelled) << name;
  }
  // the skull, which takes longest, is hardly begun
  const auto used = [](const std::atomic<bool>* cancel) {
    const std::clock_t begun = std::clock();  // the processor time of all threads
    EXPECT_EQ(makePhantom("demo", cancel).has_value(), cancel == nullptr);
    return std::clock() - begun;
  };
  EXPECT_LT(4 * used(&cancelled), used(nullptr));
  // counted: what is sampled after the cancel is the rest of its layer
  std::atomic<bool> cancel = false;
  int taken = 0;
  const auto volume = sampled<std::int16_t>(
      centredGrid(20, 1e-3), Ramp{},
      [&](const haptics::Vec3&) {
        if (++taken == 1'000) cancel = true;
        return 0.001;
      },
      {}, &cancel);
  ASSERT_FALSE(volume.has_value());
  EXPECT_EQ(volume.error().kind, haptics::Error::Kind::Cancelled);
  EXPECT_EQ(taken, 1'200);
}

TEST(Phantoms, EveryOneIsMadeTheSameTwiceAndIsFitToTouch) {
  for (const std::string& name : phantomNames()) {
    SCOPED_TRACE(name);
    const auto first = makePhantom(name);
    ASSERT_TRUE(first.has_value());
    const haptics::Volume& volume = first->volume;
    if (!made::kSanitized) {
      const auto second = makePhantom(name);
      ASSERT_TRUE(second.has_value());
      const auto bytes =
          static_cast<std::size_t>(volume.grid.voxelCount()) * haptics::sizeOf(volume.type);
      EXPECT_EQ(std::memcmp(volume.voxels.get(), second->volume.voxels.get(), bytes), 0);
    }
    EXPECT_FALSE(first->tool.empty());
    EXPECT_LT(volume.least, first->isovalue);
    EXPECT_GT(volume.greatest, first->isovalue);
    EXPECT_TRUE(volume.orientation_known);
    // centred on W's origin
    const haptics::Vec3 last =
        (Eigen::Map<const Eigen::Matrix<std::int64_t, 3, 1>>(volume.grid.dims.data()).array() - 1)
            .cast<double>();
    EXPECT_LT((volume.grid.origin + volume.grid.worldOf(last)).norm(), 1e-12);
  }
}

TEST(Phantoms, ThePapersScenesHaveItsIsovaluesAndTools) {
  if (made::kSanitized) GTEST_SKIP() << "they are large";
  struct Scene {
    const char* name;
    double isovalue;
    const char* tool;
  };
  const std::vector<Scene> scenes{
      {"bunny", 1500.0, "cane"}, {"engine", 90.0, "wrench"}, {"bone", 1400.0, "drill"}};
  EXPECT_EQ(paperSceneNames().size(), scenes.size());
  for (const Scene& scene : scenes) {
    const auto made = makePhantom(scene.name);
    ASSERT_TRUE(made.has_value()) << scene.name;
    EXPECT_EQ(made->isovalue, scene.isovalue) << scene.name;
    EXPECT_EQ(made->tool, scene.tool);
  }
}

TEST(Phantoms, SamplingRefusesNothingAndRoundsToTheNearest) {
  const auto volume = sampled<std::int16_t>(centredGrid(4, 4, 4, 0.001),
                                            {.isovalue = 10.0, .slope = 7.0, .reach = 1.0},
                                            [](const haptics::Vec3& p) { return p.x(); });
  ASSERT_TRUE(volume.has_value());
  const auto* v = static_cast<const std::int16_t*>(volume->voxels.get());
  EXPECT_EQ(v[0], 17);  // x = -1.5 mm: held at one voxel inside
  EXPECT_EQ(v[1], 14);  // x = -0.5 mm: 10 + 3.5, upwards
  EXPECT_EQ(v[2], 7);   // x = +0.5 mm: 10 - 3.5
  EXPECT_EQ(v[3], 3);
}

TEST(Noise, HasMeanZeroDeviationOneAndNoMemory) {
  double sum = 0.0, squares = 0.0, neighbours = 0.0;
  const int side = 60;
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double g = noise::gaussian(noise::hashed(i, j, k, 5));
        sum += g;
        squares += g * g;
        neighbours += g * noise::gaussian(noise::hashed(i + 1, j, k, 5));
      }
  const double n = side * side * side;  // 216,000 draws: one deviation of the mean is 0.0022
  EXPECT_NEAR(sum / n, 0.0, 0.01);
  EXPECT_NEAR(squares / n, 1.0, 0.02);
  EXPECT_NEAR(neighbours / n, 0.0, 0.01);
}

}  // namespace
}  // namespace datasets
