// SPDX-License-Identifier: BSD-3-Clause
// Cuts in a recording: to the bit, whatever the layout, and nothing unsound is carried out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/recording/cut_words.h"
#include "app/recording/database.h"
#include "app/recording/recorded_cuts.h"
#include "app/recording/recorder.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"
#include "tests/unit/app/recording/recorded_hand.h"

namespace recording_tests {
namespace {

namespace fs = std::filesystem;
using haptics::BurrCut;
using support::ScratchFolder;

/// What step n cuts: nothing in some, and in one block nothing at all.
std::optional<BurrCut> cutIn(std::int64_t n) {
  if (n % 3 == 1 || (n >= 1024 && n < 2048)) return {};
  const double t = 0.01 * double(n);
  return BurrCut{{0.01 * std::sin(t), 0.02 * std::cos(t), 1e-5 * t},
                 {0.01 * std::sin(t + 0.01), 0.02 * std::cos(t + 0.01), 1e-5 * t},
                 2.02e-3,
                 300.0 + 0.1 * t};
}

haptics::CutLaw anyLaw() {
  haptics::CutLaw law;
  law.burr = {{1e-6, -2e-6, -0.0319}, 2e-3};
  law.speed = 6283.185307179586;
  law.vibration = 0.125;
  law.material.count = 2;
  law.material.bands[0] = {-1024.0, 2e8};
  law.material.bands[1] = {700.0, 1e9};
  return law;
}

TEST(RecordedCuts, AreWhatTheyWereToTheBit) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate";
  for (const int hz : {1000, 4000}) {
    recorded(path, {.ticks = 3000, .rate = {hz}, .change = [](Step& step, std::int64_t n) {
                      step.cut = cutIn(n);
                    }});
    EXPECT_EQ(formatOf(path), hz == 1000 ? 7 : 8);
    auto recording = Recording::open(path);
    ASSERT_TRUE(recording) << sentence(recording.error());
    const auto steps = stepsIn(*recording);
    ASSERT_EQ(steps.size(), 3000U);
    for (std::size_t i = 0; i < steps.size(); ++i)
      ASSERT_EQ(steps[i].step.cut, cutIn(static_cast<std::int64_t>(i))) << i;
  }
}

/// Voxels of 1 mm that are all to be cut, but for the first.
std::shared_ptr<const haptics::Volume> filled(const std::array<std::int64_t, 3>& dims) {
  haptics::Grid grid;
  grid.dims = dims;
  grid.spacing = haptics::Vec3::Constant(1e-3);
  const auto voxels =
      haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16).value();
  auto* const first = static_cast<std::int16_t*>(voxels.get());
  std::fill_n(first, grid.voxelCount(), std::int16_t{1000});
  *first = -1000;
  return std::make_shared<const haptics::Volume>(
      haptics::makeVolume(grid, haptics::ScalarType::Int16, voxels).value());
}

TEST(RecordedCuts, AreCarriedOutLittleByLittleAndAnewBackInTime) {
  const auto volume = filled({40, 40, 40});
  std::vector<RecordedCut> all;
  for (std::uint64_t n = 0; n < 10; ++n) {
    const haptics::Vec3 at = 1e-3 * haptics::Vec3{10.0 + double(n), 20.0, 20.0};
    all.push_back({5 * n, 2, {at, at + haptics::Vec3{1e-3, 0.0, 0.0}, 3e-3, 300.0}});
  }
  all.push_back({50, 3, all.back().cut});  // of another scene
  CarvedCopy whole{volume};
  std::int64_t three_cuts = 0;
  for (std::size_t n = 0; n < 10; ++n) {
    const auto done = whole.carve(all[n].cut);
    ASSERT_TRUE(done && done->removed.voxels > 0);
    EXPECT_GE(done->looked, done->removed.voxels);
    three_cuts = 3 * done->looked;
  }
  const auto digestNow = [&](const CutsUntil& cuts) {
    return digestOfCuts(*volume, cuts.volume());
  };
  CutsUntil cuts;
  cuts.set(all);
  for (int round = 0; round < 2; ++round) {
    for (const std::size_t left : {7U, 4U, 1U, 0U}) {
      const auto moved = cuts.moveTo(volume, 2, 60, three_cuts);
      ASSERT_TRUE(moved);
      EXPECT_EQ(moved->whole, left == 0) << left;
      EXPECT_EQ(moved->anew, left == 7) << left;
      EXPECT_EQ(moved->changed.size(), 1U);
      EXPECT_EQ(digestNow(cuts) == whole.digest(), left == 0) << left;
    }
    const auto rests = cuts.moveTo(volume, 2, 60, three_cuts);
    ASSERT_TRUE(rests);
    EXPECT_TRUE(rests->whole && !rests->anew && rests->changed.empty());
    // back in time, and then again
    const auto back = cuts.moveTo(volume, 2, 12);
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->whole && back->anew);
    CarvedCopy three{volume};
    for (std::size_t n = 0; n < 3; ++n) ASSERT_TRUE(three.carve(all[n].cut));
    EXPECT_EQ(digestNow(cuts), three.digest());
    // where nothing was cut there is nothing to show
    const auto uncut = cuts.moveTo(volume, 9, 60);
    ASSERT_TRUE(uncut);
    EXPECT_TRUE(uncut->whole && uncut->anew && !cuts.isCarved());
    EXPECT_FALSE(cuts.moveTo(volume, 9, 61)->anew);
  }
}

TEST(RecordedCuts, FarApartHaveBoxesOfTheirOwn) {
  const auto volume = filled({200, 20, 20});
  std::vector<RecordedCut> all;
  for (const double x : {10.0, 30.0, 150.0, 180.0, 20.0})
    all.push_back({all.size(),
                   1,
                   {1e-3 * haptics::Vec3{x, 10.0, 10.0}, 1e-3 * haptics::Vec3{x + 1.0, 10.0, 10.0},
                    3e-3, 300.0}});
  CutsUntil cuts;
  cuts.set(all);
  const auto moved = cuts.moveTo(volume, 1, 10);
  ASSERT_TRUE(moved);
  ASSERT_EQ(moved->changed.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) {
    const haptics::VoxelBox& box = moved->changed[n];
    EXPECT_LE(box.end[0] - box.first[0], 64) << n;
    EXPECT_TRUE((box.first[0] <= 20) == (n != 1)) << n;
  }
}

TEST(RecordedCuts, ThatThereCannotBeAreRefused) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate";
  const BurrCut sound = *cutIn(0);
  const auto refusedWith = [&](const BurrCut& cut) {
    recorded(path, {.ticks = 10, .change = [&](Step& step, std::int64_t n) {
                      if (n == 5) step.cut = cut;
                    }});
    auto recording = Recording::open(path);
    if (!recording) return recording.error().reason == "damaged";
    return !recording->block(0).has_value();
  };
  EXPECT_FALSE(refusedWith(sound));
  for (const double radius : {0.0, -1e-3, 0.5, 1e-9, double(NAN), double(INFINITY)}) {
    BurrCut cut = sound;
    cut.radius = radius;
    EXPECT_TRUE(refusedWith(cut)) << radius;
  }
  for (const double place : {1e6, double(NAN), -double(INFINITY)}) {
    BurrCut cut = sound;
    cut.from_W.y() = place;
    EXPECT_TRUE(refusedWith(cut)) << place;
    cut = sound;
    cut.to_W.x() = place;
    EXPECT_TRUE(refusedWith(cut)) << place;
  }
  BurrCut cut = sound;
  cut.isovalue = NAN;
  EXPECT_TRUE(refusedWith(cut));
  cut = sound;
  cut.to_W += haptics::Vec3(0.05, 0.0, 0.0);
  EXPECT_TRUE(refusedWith(cut));
}

TEST(RecordedCuts, HaveALawThatIsReadAsItWasWritten) {
  const haptics::CutLaw law = anyLaw();
  const auto read = app::lawFrom(app::wordsOf(law));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->burr.centre_P, law.burr.centre_P);
  EXPECT_EQ(read->burr.radius, law.burr.radius);
  EXPECT_EQ(read->speed, law.speed);
  EXPECT_EQ(read->share, law.share);
  EXPECT_EQ(read->vibration, law.vibration);
  EXPECT_EQ(read->material.count, 2U);
  EXPECT_EQ(read->material, law.material);
  const std::string words = app::wordsOf(law);
  const auto with = [&](const std::string& old, const std::string& now) {
    std::string other = words;
    const auto at = other.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    other.replace(at, old.size(), now);
    return app::lawFrom(other).has_value();
  };
  EXPECT_TRUE(with("0.002", "0.003"));
  EXPECT_FALSE(with("0.002", "-0.002"));
  EXPECT_FALSE(with("0.002", "\"2\""));
  EXPECT_FALSE(with("\"share\"", "\"chare\""));
  EXPECT_FALSE(with("\"vibration\"", "\"vibrato\""));
  EXPECT_FALSE(with("-0.0319", "null"));
  EXPECT_FALSE(with("[{", "[[[[[[{"));
  EXPECT_FALSE(app::lawFrom("").has_value());
  EXPECT_FALSE(app::lawFrom("[]").has_value());
}

}  // namespace
}  // namespace recording_tests
