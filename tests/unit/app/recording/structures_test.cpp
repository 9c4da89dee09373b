// SPDX-License-Identifier: BSD-3-Clause
// Distances to structures in a recording, and how structures were felt.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "app/recording/database.h"
#include "app/recording/felt_words.h"
#include "app/recording/recorder.h"
#include "app/recording/unfinished.h"
#include "app/recording/walls.h"
#include "tests/support/made_distances.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"
#include "tests/unit/app/recording/recorded_hand.h"

namespace recording_tests {
namespace {

namespace fs = std::filesystem;
using support::ScratchFolder;

/// What step n says: other structures from time to time, and in between none.
Nearnesses saidIn(std::int64_t n) {
  Nearnesses near;
  const int which = static_cast<int>(n / 700) % 3;
  if (which == 0) return near;
  for (const std::uint8_t structure : {std::uint8_t{4}, std::uint8_t{0}, std::uint8_t{254}})
    if (structure != 0 || which == 2)
      near.push({structure, static_cast<float>(0.02 * std::sin(0.01 * double(n) + structure)),
                 static_cast<float>(0.02 * std::cos(0.013 * double(n)))});
  return near;
}

TEST(RecordedStructures, AreAsFarAsTheyWere) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate";
  for (const int hz : {1000, 4000}) {
    recorded(path, {.ticks = 3000, .rate = {hz}, .change = [](Step& step, std::int64_t n) {
                      step.near = saidIn(n);
                    }});
    EXPECT_EQ(formatOf(path), hz == 1000 ? 5 : 6);
    auto recording = Recording::open(path);
    ASSERT_TRUE(recording) << sentence(recording.error());
    EXPECT_EQ(recording->structures(), (std::vector<std::uint8_t>{0, 4, 254}));
    const auto steps = stepsIn(*recording);
    ASSERT_EQ(steps.size(), 3000U);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Nearnesses& read = steps[i].step.near;
      const Nearnesses said = saidIn(static_cast<std::int64_t>(i));
      ASSERT_EQ(read.size(), said.size()) << i;
      for (std::size_t of = 0; of < said.size(); ++of) {
        ASSERT_EQ(read[of].structure, said[of].structure) << i;
        const float most = hz == 1000 ? 0.0F : 0.51e-7F;
        ASSERT_LE(std::abs(read[of].tip - said[of].tip), most) << i;
        ASSERT_LE(std::abs(read[of].nearest - said[of].nearest), most) << i;
      }
    }
  }
}

TEST(RecordedStructures, AreNotInTheFileWhereNoneWasWatched) {
  const ScratchFolder scratch;
  recorded(scratch / "r.palpate", HandMotion::Tap, 500);
  EXPECT_EQ(formatOf(scratch / "r.palpate"), 2);
  const auto recording = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(recording);
  EXPECT_TRUE(recording->structures().empty());
}

TEST(RecordedStructures, ThatSayNothingSoundAreRefused) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate";
  const auto reasonAfter = [&](const char* change) -> std::string {
    recorded(path,
             {.ticks = 1500, .change = [](Step& step, std::int64_t n) { step.near = saidIn(n); }});
    {
      auto database = Database::open(path, Database::Mode::Recover);
      EXPECT_TRUE(database && database->run(change)) << change;
    }
    auto recording = Recording::open(path);
    if (!recording) return recording.error().reason;
    const auto read = recording->forEach(-kEver, kEver, [](const RecordedStep&) { return true; });
    return read ? "" : read.error().reason;
  };
  EXPECT_EQ(reasonAfter("SELECT 1"), "");
  for (const char* words : {"'[]'", "'[0]'", "'[256]'", "'[5,5]'", "'[1.5]'", "'{}'", "'x'",
                            "'[[1]]'", "'[1,2,3,4,5,6,7,8,9,10,11,12,13]'", "'[5]'", "'[5,6,7]'"})
    EXPECT_EQ(reasonAfter((std::string{"UPDATE nearness SET structures = "} + words).c_str()),
              "damaged")
        << words;
  EXPECT_EQ(reasonAfter("UPDATE nearness SET data = zeroblob(40)"), "damaged");
  EXPECT_EQ(reasonAfter("UPDATE nearness SET data = x''"), "damaged");
  EXPECT_EQ(reasonAfter("DROP TABLE nearness"), "damaged");
  EXPECT_EQ(reasonAfter("PRAGMA user_version = 3"), "damaged");
}

TEST(RecordedStructures, OfAProcessThatWasKilledAreRecovered) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate";
  {
    auto recorder = Recorder::create(path, {"test", "a build", "a machine"}).value();
    std::int64_t n = 0;
    recorder->ring().start({});
    for (Step step : worked({.ticks = 1500})) {
      step.near = saidIn(n++);
      recorder->ring().push(step);
    }
  }
  const auto recovered = recover(partOf(path));
  ASSERT_TRUE(recovered) << sentence(recovered.error());
  const auto recording = Recording::open(*recovered);
  ASSERT_TRUE(recording) << sentence(recording.error());
  EXPECT_EQ(recording->structures().size(), 3U);
}

Watch watchOf(std::initializer_list<std::uint8_t> structures) {
  Watch watch;
  for (const std::uint8_t structure : structures) watch.structures.push_back({structure, {}});
  return watch;
}

TEST(FeltWords, SayHowStructuresAreFelt) {
  Watch watch = watchOf({0, 6, 30, 4, 5});
  EXPECT_EQ(wordsOf(watch), "");
  watch.structures[0].feel = {.kind = Feel::Kind::Softer, .stiffness = 321.5};
  watch.structures[2].feel = {.kind = Feel::Kind::Guarded, .margin = 0.0025, .most = 1.75};
  watch.structures[3].feel.kind = Feel::Kind::Solid;
  watch.structures[4].feel.kind = Feel::Kind::NotThere;
  const auto felt = feltAsSaid(wordsOf(watch), watchOf({30, 0, 6, 5, 4}));
  ASSERT_TRUE(felt) << sentence(felt.error());
  EXPECT_EQ(felt->structures[0].feel.kind, Feel::Kind::Guarded);
  EXPECT_EQ(felt->structures[0].feel.margin, 0.0025);
  EXPECT_EQ(felt->structures[0].feel.most, 1.75);
  EXPECT_EQ(felt->structures[1].feel.kind, Feel::Kind::Softer);
  EXPECT_EQ(felt->structures[1].feel.stiffness, 321.5);
  EXPECT_EQ(felt->structures[2].feel.kind, Feel::Kind::AsScan);
  EXPECT_EQ(felt->structures[3].feel.kind, Feel::Kind::NotThere);
  EXPECT_EQ(felt->structures[4].feel.kind, Feel::Kind::Solid);
  EXPECT_TRUE(felt->hasWalls());
  EXPECT_FALSE(feltAsSaid("", watch)->isFelt());
  EXPECT_FALSE(feltAsSaid("", watch)->hasWalls());
  const auto lacks = feltAsSaid(wordsOf(watch), watchOf({0, 6}));
  ASSERT_FALSE(lacks);
  EXPECT_EQ(lacks.error().reason, "no-structures");
  for (const char* words :
       {"x", "{}", "[3]", "[{}]", R"([{"number":1}])", R"([{"number":1,"feel":"hard"}])",
        R"([{"number":1,"feel":"softer"}])", R"([{"number":1,"feel":"softer","stiffness":0}])",
        R"([{"number":1.5,"feel":"softer","stiffness":5}])",
        R"([{"number":1,"feel":"guarded","margin":0.1}])",
        R"([{"number":1,"feel":"guarded","margin":0.1,"most":1e9}])", R"([[[[[[1]]]]]])"}) {
    const auto refused = feltAsSaid(words, watch);
    ASSERT_FALSE(refused) << words;
    EXPECT_EQ(refused.error().reason, "damaged") << words;
  }
}

/// Of scene(): a ball beside its ball is solid, and a hole in it not there.
Watch wallsInScene() {
  const auto map = [](const Vec3& middle, double radius) {
    return made::distanceMap(scene()->volume->grid,
                             [=](const Vec3& p) { return (p - middle).norm() - radius; });
  };
  Watch watch;
  watch.structures.push_back({4, map({0.0235, 0.0235, 0.040}, 4e-3), {.kind = Feel::Kind::Solid}});
  watch.structures.push_back(
      {9, map({0.0235, 0.030, 0.0345}, 5e-3), {.kind = Feel::Kind::NotThere}});
  watch.structures.push_back({1, map({0.03, 0.02, 0.02}, 2e-3)});
  return watch;
}

TEST(RecordedWalls, AreReplayedFromTheScanToTheBit) {
  const ScratchFolder scratch;
  const auto before = scene();
  const Watch watch = wallsInScene();
  EXPECT_EQ(wallsOf(&watch).size(), 2U);
  EXPECT_TRUE(wallsOf(nullptr).empty());
  for (const bool is_edited : {false, true}) {
    const fs::path path = scratch / (is_edited ? "edited.palpate" : "walls.palpate");
    std::vector<Edit> edits;
    if (is_edited)
      edits.push_back(PlaneCut{{0.0235, 0.0235, 0.0315}, Vec3{0.1, 0.2, 1.0}.normalized(), 0.0});
    const auto seen = edited(before->volume, edits).value();
    const auto volume = walled(seen, wallsOf(&watch), 0.0).value();
    const auto touched = *makeScene(volume, before->tool);
    recorded(path, HandMotion::Slide, 1500, 0.3, touched);
    auto recording = Recording::open(path);
    ASSERT_TRUE(recording) << sentence(recording.error());
    const RecordedScene& then = recording->scenes().front();
    EXPECT_EQ(then.walls, (std::vector<Walled::Wall>{{4, true}, {9, false}}));
    EXPECT_EQ(then.walls_isovalue, 0.0);
    EXPECT_EQ(then.edits.size(), edits.size());
    const auto made = touchedAsRecorded(scene()->volume, then, &watch);
    ASSERT_TRUE(made) << sentence(made.error());
    const ReplayDifference same = replayed(*recording, *made);
    EXPECT_EQ(same.differing, 0);
    EXPECT_EQ(same.steps, 1500);
    EXPECT_GT(replayed(*recording, seen).differing, 100);  // they were touched
    // what was seen has no walls, and needs no structures
    const auto shown = editedAsRecorded(before->volume, then);
    ASSERT_TRUE(shown);
    EXPECT_EQ(walledOf(**shown), nullptr);
    // without the structures, without one of them, and with another in its place
    Watch other = watch;
    other.structures[0].structure = 5;
    std::swap(other.structures[1].distances, other.structures[2].distances);
    for (const Watch* lacks : std::vector<const Watch*>{nullptr, &other}) {
      const auto refused = touchedAsRecorded(before->volume, then, lacks);
      ASSERT_FALSE(refused);
      EXPECT_EQ(refused.error().reason, "no-structures");
      EXPECT_FALSE(sentence(refused.error()).empty());
    }
    other.structures[0].structure = 4;
    const auto wrong = touchedAsRecorded(before->volume, then, &other);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().reason, "other-structures");
    EXPECT_FALSE(sentence(wrong.error()).empty());
  }
}

TEST(RecordedWalls, ThatSayNothingSoundAreRefused) {
  const Watch watch = wallsInScene();
  const auto before = scene();
  const SceneWords words =
      wordsOf(**makeScene(walled(before->volume, wallsOf(&watch), 0.0).value(), before->tool));
  ASSERT_TRUE(sceneFrom(words));
  for (const auto& [part, instead] : {std::pair{"\"digest\":\"", "\"digest\":\"x"},
                                      {"\"digest\":", "\"dig\":"},
                                      {"\"feel\":\"solid\"", "\"feel\":\"softer\""},
                                      {"\"number\":5", "\"number\":0"},
                                      {"\"number\":5", "\"number\":5.5"},
                                      {"\"isovalue\":0.0", "\"isovalue\":null"},
                                      {"\"structures\":[", "\"structures\":[7,"}}) {
    SceneWords damaged = words;
    const auto at = damaged.volume.find(part);
    ASSERT_NE(at, std::string::npos) << part << " in " << damaged.volume;
    damaged.volume.replace(at, std::string{part}.size(), instead);
    const auto read = sceneFrom(damaged);
    ASSERT_FALSE(read) << part;
    EXPECT_EQ(read.error().reason, "damaged");
  }
}

}  // namespace
}  // namespace recording_tests
