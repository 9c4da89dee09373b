// SPDX-License-Identifier: BSD-3-Clause
// A recording holds what was, to the bit, and gives it back after whatever became of the process.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <thread>

#include "app/recording/columns.h"
#include "app/recording/database.h"
#include "app/recording/recorder.h"
#include "app/recording/recording.h"
#include "app/recording/replay.h"
#include "app/recording/unfinished.h"
#include "datasets/edits/edit_history.h"
#include "datasets/edits/edited.h"
#include "haptics/core/latest_value.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/servo/servo_loop.h"
#include "haptics/simulation/closed_loop.h"
#include "haptics/simulation/simulated.h"
#include "tests/support/places.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"
#include "tests/unit/app/recording/recorded_hand.h"

namespace recording_tests {
namespace {

namespace fs = std::filesystem;
using support::ScratchFolder;
TEST(Recording, HoldsEveryTickToTheBit) {
  const ScratchFolder scratch;
  const auto rows = recorded(scratch / "r.palpate", HandMotion::Slide, 3000);
  auto recording = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(recording) << sentence(recording.error());
  EXPECT_EQ(recording->version(), "test");
  EXPECT_EQ(recording->machine(), "a machine");
  EXPECT_EQ(recording->lostCount(), 0);
  const auto steps = stepsIn(*recording);
  ASSERT_EQ(steps.size(), rows.size());
  std::size_t touching = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i].step;
    ASSERT_EQ(step.sequence, i);
    ASSERT_TRUE(same(step.X_WD, rows[i].X_WD)) << i;
    ASSERT_EQ(steps[i].device, numbersOf(rows[i].X_WD)) << i;
    ASSERT_EQ(steps[i].proxy, numbersOf(rows[i].X_WP)) << i;
    ASSERT_EQ(step.sent_W.force, rows[i].sent_W.force) << i;
    ASSERT_EQ(step.sent_W.torque, rows[i].sent_W.torque) << i;
    ASSERT_EQ(step.contacts.size(), std::size_t(rows[i].contacts)) << i;
    for (std::size_t c = 0; c < step.contacts.size(); ++c) {
      ASSERT_EQ(step.contacts[c].n_W.cast<float>(), rows[i].bearing[c].n_W.cast<float>());
      ASSERT_EQ(float(step.contacts[c].push), float(rows[i].bearing[c].push));
    }
    touching += step.contacts.size();
  }
  EXPECT_GT(touching, 500U);
  EXPECT_FALSE(fs::exists(scratch / "r.palpate.part"));
  EXPECT_FALSE(fs::exists(scratch / "r.palpate-wal"));
}

// the list in README.md is this table
TEST(Recording, ItsColumnsAreThoseOfTheReadme) {
  std::string table = "| column | type | unit | meaning |\n|---|---|---|---|\n";
  for (const StepColumn& column : stepColumns())
    table += std::string{"| `"} + column.name + "` | " + nameOf(column.type) + " | " + column.unit +
             " | " + column.meaning + " |\n";
  std::ifstream file(places::source("app/recording/README.md"));
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(readme.empty());
  EXPECT_NE(readme.find(table), std::string::npos) << "The list should be:\n\n" << table;
}

TEST(Recording, WhatPushesAddsUpToTheForce) {
  const ScratchFolder scratch;
  recorded(scratch / "r.palpate", HandMotion::Slide, 3000);
  auto recording = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(recording);
  int seen = 0;
  for (const RecordedStep& recorded : stepsIn(*recording)) {
    const Step& step = recorded.step;
    if (step.contacts.empty() || step.sent_W.force.norm() < 0.5) continue;
    Vec3 pushed = Vec3::Zero();
    for (const BearingContact& c : step.contacts) pushed += c.push * c.n_W;
    // at rest; while it moves the reactions are those of the last try
    if ((pushed - step.sent_W.force).norm() < 0.02 * step.sent_W.force.norm()) ++seen;
  }
  EXPECT_GT(seen, 300);
}

TEST(Recording, IsReplayedToTheBit) {
  const ScratchFolder scratch;
  for (const HandMotion motion : {HandMotion::Tap, HandMotion::Slide, HandMotion::Hook}) {
    recorded(scratch / "r.palpate", motion, 2500, motion == HandMotion::Hook ? 0.4 : 0.0);
    auto recording = Recording::open(scratch / "r.palpate");
    ASSERT_TRUE(recording);
    const ReplayDifference difference = replayed(*recording, scene()->volume);
    EXPECT_EQ(difference.steps, 2500);
    EXPECT_EQ(difference.skipped, 0);
    EXPECT_EQ(difference.differing, 0) << difference.distance;
    // and over another volume it is not
    const ReplayDifference other = replayed(*recording, scene(0.0149)->volume);
    EXPECT_GT(other.differing, 200);
    EXPECT_GT(other.distance, 0.00005);
    ASSERT_TRUE(other.first);
    EXPECT_GT(*other.first, 10U);  // before the touch it is the same
  }
}

/// A servo loop that the test steps itself, a hand on the ball, and its recorder.
struct Bench {
  explicit Bench(const fs::path& target) : path{target} {
    auto made = Recorder::create(target, {"test", "a build", "a machine"});
    EXPECT_TRUE(made) << sentence(made.error());
    recorder = std::move(*made);
    first = scene();
    recorder->describe(first, "egg");
    auto hand = Hand::aimed(HandMotion::Slide, *first, 0.0, 0.012, 1);
    EXPECT_TRUE(hand);
    Grip grip;
    grip.gyration = std::sqrt(first->tool.shell.inertia.trace() / 3.0);
    const Pose X_start = hand->at(0.0);
    grip.X_WD = X_start;
    loop = std::make_unique<ServoLoop>(openSimulated(std::move(*hand), grip, ServoRate{}.period()),
                                       settings);
    loop->scenes.offer(std::make_unique<Engagement>(first, X_start));
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) loop->step(1e-3 * double(n++));
  }
  fs::path path;
  std::unique_ptr<Recorder> recorder;
  std::shared_ptr<const Scene> first;
  Settings settings;
  std::unique_ptr<ServoLoop> loop;
  int n = 0;
};

/// A plane and a notch through the ball of scene(), and a crop.
std::vector<Edit> someEdits() {
  LassoCut lasso;
  lasso.outline = {{-0.002, -0.02}, {0.004, -0.02}, {0.004, 0.02}, {-0.002, 0.02}};
  lasso.X_WC = poseOf({0.0235, 0.0235, 0.1235}, Quat::Identity());
  lasso.parallel = true;
  lasso.until = 0.1;
  return {PlaneCut{{0.0235, 0.0235, 0.0315}, Vec3{0.1, 0.2, 1.0}.normalized(), 0.0}, lasso,
          Crop{{{0, 0, 0}, {48, 48, 46}}}};
}

TEST(Recording, OfAnEditedVolumeIsReplayedFromTheScanToTheBit) {
  const ScratchFolder scratch;
  const auto path = scratch / "edited.palpate", plain = scratch / "plain.palpate";
  const auto before = scene();
  const auto volume = edited(before->volume, someEdits());
  ASSERT_TRUE(volume) << sentence(volume.error());
  const auto touched = *makeScene(*volume, before->tool);
  for (const HandMotion motion : {HandMotion::Slide, HandMotion::Pry}) {
    fs::remove(path);
    const auto rows = recorded(path, motion, 1500, 0.3, touched);
    ASSERT_EQ(rows.size(), 1500U);
    auto recording = Recording::open(path);
    ASSERT_TRUE(recording) << sentence(recording.error());
    ASSERT_EQ(recording->scenes().size(), 1U);
    const RecordedScene& then = recording->scenes().front();
    ASSERT_EQ(then.edits.size(), 3U);
    EXPECT_EQ(textOf(then.edits[1]), textOf(someEdits()[1]));
    EXPECT_EQ(then.edits_digest, datasets::editedOf(**volume)->digest);
    // another program has the scan, and makes the rest
    const auto made = editedAsRecorded(scene()->volume, then);
    ASSERT_TRUE(made) << sentence(made.error());
    const ReplayDifference same = replayed(*recording, *made);
    EXPECT_EQ(same.differing, 0);
    EXPECT_EQ(same.steps, 1500);
    // over the scan the way is another: the edits were touched
    EXPECT_GT(replayed(*recording, scene()->volume).differing, 100);
  }
  EXPECT_EQ(formatOf(path), 3);
  recorded(plain, HandMotion::Slide, 50);
  EXPECT_EQ(formatOf(plain), 2);
  EXPECT_TRUE(Recording::open(plain)->scenes().front().edits.empty());
}

TEST(Recording, OfAnEditedVolumeIsNotReplayedOverOneThatComesOutOtherwise) {
  const auto before = scene();
  const auto touched = *makeScene(*edited(before->volume, someEdits()), before->tool);
  const SceneWords words = wordsOf(*touched);
  RecordedScene then = *sceneFrom(words);
  ASSERT_TRUE(editedAsRecorded(before->volume, then));
  // another scan, and a digest that is not the one
  const auto other = editedAsRecorded(scene(0.0149)->volume, then);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().reason, "other-edits");
  then.edits_digest ^= 1;
  const auto wrong = editedAsRecorded(before->volume, then);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().reason, "other-edits");
  EXPECT_FALSE(sentence(wrong.error()).empty());
  // damage
  for (const auto& [part, instead] : {std::pair{"\"edits_digest\":\"", "\"edits_digest\":\"x"},
                                      {"\"edit\":\"plane\"", "\"edit\":\"x\""},
                                      {"\"edits\":[", "\"edits\":[7,"},
                                      {"\"edits_digest\":", "\"digest\":"}}) {
    SceneWords damaged = words;
    const auto at = damaged.volume.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    damaged.volume.replace(at, std::strlen(part), instead);
    const auto read = sceneFrom(damaged);
    ASSERT_FALSE(read) << part;
    EXPECT_EQ(read.error().reason, "damaged");
  }
}

TEST(Recording, OfALiveLoopIsReplayedToTheBitThroughAllThatTheUserDoes) {
  const ScratchFolder scratch;
  Bench bench(scratch / "r.palpate");
  // begun in the middle of a touch
  bench.run(1200);
  bench.loop->recording.store(&bench.recorder->ring());
  bench.run(600);
  bench.settings.isovalue = -4.0;  // the proxy is inside now, and is brought out
  bench.loop->settings.publish(bench.settings);
  bench.run(400);
  bench.loop->armed.store(false);
  bench.run(100);
  bench.loop->armed.store(true);
  bench.settings.stiffness = 1500.0;
  bench.settings.friction = 0.3;
  bench.loop->settings.publish(bench.settings);
  bench.run(400);
  // another scene, of another volume
  const auto second = scene(0.0155);
  bench.recorder->describe(second, "egg");
  Snapshot now;
  ASSERT_TRUE(bench.loop->snapshots.take(now));
  const auto legal = legalPoseNear(*second, -4.0, now.X_WP);
  ASSERT_TRUE(legal);
  bench.loop->scenes.offer(std::make_unique<Engagement>(second, *legal));
  bench.run(500);
  bench.loop->recording.store(nullptr);
  bench.run(5);
  ASSERT_TRUE(bench.recorder->finish());

  auto recording = Recording::open(bench.path);
  ASSERT_TRUE(recording) << sentence(recording.error());
  ASSERT_EQ(recording->scenes().size(), 2U);
  const auto difference = replay(
      *recording,
      [&](std::uint32_t id) {
        const auto& volume = id == second->id ? second->volume : bench.first->volume;
        const RecordedScene* then = recording->scene(id);
        return *makeScene(volume, then->tool, then->options);
      },
      [](double) { return true; });
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->steps, 2000);
  EXPECT_EQ(difference->skipped, 0);
  EXPECT_EQ(difference->differing, 0)
      << "first " << difference->first.value_or(0) << ", " << difference->distance << " m, "
      << difference->force << " N";
  // the events tell what was done
  std::map<std::string, std::vector<double>> events;
  for (const RecordedEvent& event : recording->events())
    if (event.value) events[event.kind].push_back(*event.value);
  EXPECT_EQ(events["isovalue"], (std::vector<double>{0.0, -4.0}));
  EXPECT_EQ(events["stiffness"], (std::vector<double>{1000.0, 1500.0}));
  EXPECT_EQ(events["friction"], (std::vector<double>{0.0, 0.3}));
  EXPECT_EQ(events["scene"], (std::vector<double>{double(bench.first->id), double(second->id)}));
  EXPECT_GE(events["force"].size(), 5U);  // on, recovering, ramping, off, ramping, …
  EXPECT_EQ(recording->starts().size(), 2U);
}

TEST(Recording, BegunAtAnyMomentIsReplayedToTheBit) {
  // what the proxy remembers matters most where it is held and the hand rests
  const ScratchFolder scratch;
  const auto touched = scene();
  for (const HandMotion motion : {HandMotion::Tap, HandMotion::Wedge, HandMotion::Hook})
    for (int moment = 600; moment < 2600; moment += 250) {
      auto recorder = Recorder::create(scratch / "r.palpate", {"test", "", ""});
      ASSERT_TRUE(recorder);
      (*recorder)->describe(touched, "egg");
      const auto hand = Hand::aimed(motion, *touched, 0.0, 0.012, 1);
      ASSERT_TRUE(hand);
      LatestValue<Pose> mouse;  // a hand that can be stopped
      mouse.publish(hand->at(0.0));
      Grip grip;
      grip.gyration = std::sqrt(touched->tool.shell.inertia.trace() / 3.0);
      grip.X_WD = hand->at(0.0);
      Settings settings;
      settings.friction = moment % 500 == 0 ? 0.0 : 0.3;
      ServoLoop loop(openMouse(mouse, grip, ServoRate{}.period()), settings);
      loop.scenes.offer(std::make_unique<Engagement>(touched, hand->at(0.0)));
      for (int n = 0; n < moment + 300; ++n) {
        // it rests from a hundred ticks before the recording begins
        if (n < moment - 100) mouse.publish(hand->at(1e-3 * n));
        if (n == moment) loop.recording.store(&(*recorder)->ring());
        loop.step(1e-3 * n);
      }
      ASSERT_TRUE((*recorder)->finish());
      auto recording = Recording::open(scratch / "r.palpate");
      ASSERT_TRUE(recording);
      const ReplayDifference difference = replayed(*recording, touched->volume);
      EXPECT_EQ(difference.steps, 300);
      EXPECT_EQ(difference.differing, 0) << int(motion) << " at " << moment;
    }
}

TEST(Recording, AfterALossNothingGoesInBeforeAStart) {
  StepRing ring{0};
  ASSERT_TRUE(ring.startIsDue());
  ring.start({});
  Step step;
  while (ring.push(step)) {
  }
  EXPECT_FALSE(ring.startIsDue());  // there is no room yet
  Step taken;
  for (int n = 0; n < 100; ++n) ring.take(taken);
  EXPECT_FALSE(ring.push(step));
  while (ring.take(taken)) {
  }
  const std::uint64_t kept = taken.sequence;
  EXPECT_FALSE(ring.push(step));
  ASSERT_TRUE(ring.startIsDue());
  ring.start({});
  EXPECT_FALSE(ring.startIsDue());
  EXPECT_TRUE(ring.push(step));
  ASSERT_TRUE(ring.take(taken));
  EXPECT_EQ(taken.sequence, kept + 4);
  ProxyStart start;
  ASSERT_TRUE(ring.take(start) && ring.take(start));
  EXPECT_EQ(start.sequence, taken.sequence);
}

TEST(Recording, AFullRingLosesStepsCountsThemAndGoesOnExactly) {
  const ScratchFolder scratch;
  Recorder::Options slow;
  slow.commit_every = std::chrono::hours(1);
  auto recorder = Recorder::create(scratch / "r.palpate", {"test", "", ""}, slow);
  ASSERT_TRUE(recorder);
  const auto touched = scene();
  (*recorder)->describe(touched, "egg");
  auto hand = Hand::aimed(HandMotion::Slide, *touched, 0.0, 0.012, 1);
  ASSERT_TRUE(hand);
  Grip grip;
  const Pose X_start = hand->at(0.0);
  grip.X_WD = X_start;
  ServoLoop loop(openSimulated(std::move(*hand), grip, ServoRate{}.period()), {});
  loop.scenes.offer(std::make_unique<Engagement>(touched, X_start));
  loop.recording.store(&(*recorder)->ring());
  constexpr std::int64_t kTicks = 12'000;
  for (int n = 0; n < kTicks; ++n) loop.step(1e-3 * n);
  // the writer sleeps: more than its capacity did not go in
  (*recorder)->hurry();
  while ((*recorder)->status().steps == 0) std::this_thread::yield();
  for (int n = 0; n < 500; ++n) loop.step(1e-3 * double(kTicks + n));
  loop.recording.store(nullptr);
  ASSERT_TRUE((*recorder)->finish());

  auto recording = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(recording) << sentence(recording.error());
  EXPECT_GT(recording->lostCount(), 0);
  EXPECT_EQ(recording->stepCount() + recording->lostCount(), kTicks + 500);
  double gap = 0.0;
  for (const RecordedEvent& event : recording->events())
    if (event.kind == "gap") gap += *event.value;
  EXPECT_EQ(gap, double(recording->lostCount()));
  const ReplayDifference difference = replayed(*recording, touched->volume);
  EXPECT_EQ(difference.steps, recording->stepCount());
  EXPECT_EQ(difference.differing, 0);
}

TEST(Recording, WhatAProcessLeftIsRecoveredOnce) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate";
  {
    Bench bench(path);
    bench.loop->recording.store(&bench.recorder->ring());
    bench.run(700);
    // in use: nobody else may touch it
    while (bench.recorder->status().steps == 0) bench.recorder->hurry();
    const auto taken = recover(partOf(path));
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().reason, "in-use");
  }  // not finished
  ASSERT_TRUE(fs::exists(partOf(path)));
  const auto opened = Recording::open(partOf(path));
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().reason, "unfinished");
  const auto over = Recorder::create(path, {"test", "", ""});
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().reason, "unfinished");
  std::ofstream(path) << "in the way";
  const auto recovered = recover(partOf(path));
  ASSERT_TRUE(recovered) << sentence(recovered.error());
  EXPECT_EQ(recovered->filename(), "r-2.palpate");
  auto recording = Recording::open(*recovered);
  ASSERT_TRUE(recording) << sentence(recording.error());
  EXPECT_EQ(recording->stepCount(), 700);
  EXPECT_FALSE(fs::exists(partOf(path)));
  EXPECT_FALSE(recover(partOf(path)));
}

TEST(Recording, HasItsTablesAndNothingElse) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate";
  const auto reasonAfter = [&](const char* change) {
    fs::remove(path);
    recorded(path, HandMotion::Tap, 50);
    {
      auto database = Database::open(path, Database::Mode::Recover);
      EXPECT_TRUE(database && database->run(change)) << change;
    }
    const auto recording = Recording::open(path);
    EXPECT_EQ(summaryOf(path).has_value(), recording.has_value()) << change;
    return recording ? "" : recording.error().reason;
  };
  EXPECT_EQ(reasonAfter("SELECT 1"), "");
  EXPECT_EQ(reasonAfter("CREATE TABLE more (id INTEGER)"), "damaged");
  EXPECT_EQ(reasonAfter("CREATE VIEW v AS SELECT first FROM step"), "damaged");
  EXPECT_EQ(reasonAfter("CREATE INDEX i ON event (kind)"), "damaged");
  EXPECT_EQ(reasonAfter("CREATE TRIGGER t AFTER INSERT ON meta BEGIN SELECT 1; END"), "damaged");
  EXPECT_EQ(reasonAfter("DROP INDEX step_times"), "damaged");
  EXPECT_EQ(reasonAfter("ALTER TABLE event ADD COLUMN more TEXT AS (hex(zeroblob(1000000)))"),
            "damaged");
  EXPECT_EQ(
      reasonAfter("DROP TABLE event; CREATE VIEW event AS SELECT 0 AS id, 0 AS sequence, 0 AS "
                  "time_ns, 'a' AS kind, 0.0 AS value, 'b' AS text"),
      "damaged");
  EXPECT_EQ(reasonAfter("PRAGMA user_version = 1"), "damaged");
  for (const char* name : {"deep_edits", "generated_texts"}) {
    const auto read =
        Recording::open(places::source(std::string("tests/cases/hostile/") + name + ".palpate"));
    ASSERT_FALSE(read) << name;
    EXPECT_EQ(read.error().reason, "damaged") << name;
  }
}

TEST(Recording, IsNotReadOnceItIsCancelled) {
  const ScratchFolder scratch;
  recorded(scratch / "r.palpate", HandMotion::Tap, 50);
  const std::atomic<bool> cancel = true;
  const auto read = Recording::open(scratch / "r.palpate", &cancel);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, Error::Kind::Cancelled);
}

TEST(Recording, WhatAnotherLaidBesideItIsLeftAlone) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate", part = partOf(path);
  const auto leave = [&] {
    for (const auto& entry : fs::directory_iterator(scratch.folder())) fs::remove(entry.path());
    Bench bench(path);
    bench.loop->recording.store(&bench.recorder->ring());
    bench.run(100);
    while (bench.recorder->status().steps == 0) bench.recorder->hurry();
  };
  const auto reason = [&] {
    EXPECT_FALSE(isInUse(part));
    const auto recovered = recover(part);
    return recovered ? "" : recovered.error().reason;
  };
  leave();
  EXPECT_EQ(reason(), "");
  // a log that names another file as the one above it, which SQLite would delete
  leave();
  const fs::path precious = scratch.write("precious", "mine");
  std::string journal("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
  journal.append(504, '\0');
  const std::string name = precious.string();
  std::uint32_t sum = 0;
  for (const char c : name) sum += static_cast<unsigned char>(c);
  const auto number = [](std::uint32_t n) {
    return std::string{char(n >> 24), char(n >> 16), char(n >> 8), char(n)};
  };
  // its end: a page number, the name, its length, its sum, and the mark again
  journal += number(0x10001) + name + number(std::uint32_t(name.size())) + number(sum) +
             journal.substr(0, 8);
  scratch.write("r.palpate.part-journal", journal);
  EXPECT_EQ(reason(), "beside");
  EXPECT_TRUE(fs::exists(precious));
  // a second name, of the recording and of its log
  leave();
  fs::create_hard_link(part, scratch / "second");
  EXPECT_EQ(reason(), "beside");
  leave();
  scratch.write("precious", "mine");
  fs::remove(part.string() + "-wal");
  fs::create_hard_link(scratch / "precious", part.string() + "-wal");
  EXPECT_EQ(reason(), "beside");
  fs::remove(part.string() + "-wal");
  fs::create_symlink(scratch / "precious", part.string() + "-wal");
  EXPECT_EQ(reason(), "beside");
  EXPECT_EQ(fs::file_size(scratch / "precious"), 4U);
  // another program's file of such a name, with its log
  leave();
  fs::remove(part);
  fs::remove(part.string() + "-wal");
  {
    auto database = Database::open(scratch / "other.part", Database::Mode::Create);
    ASSERT_TRUE(database && database->run("PRAGMA journal_mode = WAL; CREATE TABLE t (a); "
                                          "INSERT INTO t VALUES (1)"));
    database->keepLog();
  }
  ASSERT_TRUE(fs::exists(scratch / "other.part-wal"));
  const auto recovered = recover(scratch / "other.part");
  ASSERT_FALSE(recovered);
  EXPECT_EQ(recovered.error().reason, "no-recording");
  EXPECT_TRUE(fs::exists(scratch / "other.part-wal"));
  // a new recording does not begin over a log that is there
  for (const char* log : {"-journal", "-wal", "-shm"}) {
    const fs::path left = scratch.write(std::string("n.palpate.part") + log, "mine");
    const auto begun = Recorder::create(scratch / "n.palpate", {"test", "", ""});
    ASSERT_FALSE(begun);
    EXPECT_EQ(begun.error().reason, "unfinished");
    EXPECT_EQ(fs::file_size(left), 4U);
    fs::remove(left);
  }
}

TEST(Recording, IsListedWithoutBeingOpenedToWrite) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "r.palpate";
  {
    Bench bench(path);
    bench.loop->recording.store(&bench.recorder->ring());
    bench.run(100);
    while (bench.recorder->status().steps == 0) bench.recorder->hurry();
    EXPECT_TRUE(isInUse(partOf(path)));
    EXPECT_TRUE(isInUse(partOf(path))) << "asking has let go of the recorder's lock";
  }
  const auto files = [&] {
    std::map<std::string, std::pair<std::uintmax_t, fs::file_time_type>> all;
    for (const auto& entry : fs::directory_iterator(scratch.folder()))
      all[entry.path().filename()] = {entry.file_size(), entry.last_write_time()};
    return all;
  };
  const auto before = files();
  EXPECT_EQ(before.size(), 1U);
  EXPECT_FALSE(isInUse(partOf(path)));
  EXPECT_EQ(files(), before);
}

TEST(Recording, IsMadeAndReadWhereAFolderOnTheWayIsALink) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "real");
  fs::create_directory_symlink(scratch / "real", scratch / "link");
  recorded(scratch / "link" / "r.palpate", HandMotion::Tap, 100);
  EXPECT_TRUE(fs::exists(scratch / "real" / "r.palpate"));
  EXPECT_TRUE(Recording::open(scratch / "link" / "r.palpate"));
  // the file itself is not followed elsewhere
  fs::create_symlink(scratch / "real" / "r.palpate", scratch / "s.palpate");
  EXPECT_FALSE(Recording::open(scratch / "s.palpate"));
}

TEST(Recording, CountsWhatWasLostAtItsEnd) {
  const ScratchFolder scratch;
  Recorder::Options slow;
  slow.commit_every = std::chrono::hours(1);
  auto recorder = Recorder::create(scratch / "r.palpate", {"test", "", ""}, slow);
  ASSERT_TRUE(recorder);
  StepRing& ring = (*recorder)->ring();
  ring.start({});
  Step step;
  std::int64_t kept = 0;
  for (int n = 0; n < 10'000; ++n) kept += ring.push(step);
  ASSERT_TRUE((*recorder)->finish());
  EXPECT_EQ((*recorder)->status().lost, 10'000 - kept);
  auto recording = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->stepCount(), kept);
  EXPECT_EQ(recording->lostCount(), 10'000 - kept);
  EXPECT_GT(recording->lostCount(), 0);
}

TEST(Recording, OfNothingLeavesNothing) {
  const ScratchFolder scratch;
  {
    auto recorder = Recorder::create(scratch / "r.palpate", {"test", "", ""});
    ASSERT_TRUE(recorder);
    EXPECT_TRUE(isInUse(scratch / "r.palpate.part"));
    const auto finished = (*recorder)->finish();
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().reason, "empty");
  }
  { EXPECT_TRUE(Recorder::create(scratch / "s.palpate", {"test", "", ""})); }
  EXPECT_TRUE(fs::is_empty(scratch.folder()));
}

TEST(Recording, SaysNothingOfAVolumeThatAnotherInstallationHashed) {
  VolumeHash mine{}, same{}, another{}, foreign{};
  another.back() = 1;
  foreign.front() = 1;
  EXPECT_EQ(compared(mine, same), SameVolume::Same);
  EXPECT_EQ(compared(mine, another), SameVolume::Another);
  EXPECT_EQ(compared(mine, foreign), SameVolume::Unknown);
  EXPECT_EQ(compared({}, mine), SameVolume::Unknown);
}

TEST(Recording, KnowsHowManySlicesItsVolumeLacks) {
  const auto whole = scene();
  auto part = std::make_shared<Volume>(*whole->volume);
  part->slices_left_out = 7;
  const auto read = sceneFrom(wordsOf(**makeScene(part, whole->tool)));
  ASSERT_TRUE(read) << sentence(read.error());
  EXPECT_EQ(read->volume.slices_left_out, 7);
}

TEST(Recording, KnowsWhereTheToolsOriginWasInItsFile) {
  const auto whole = scene();
  Tool tool = whole->tool;
  tool.shell.origin = {0.1, -0.2, 0.3};
  const auto read = sceneFrom(wordsOf(**makeScene(whole->volume, tool)));
  ASSERT_TRUE(read) << sentence(read.error());
  EXPECT_EQ(read->tool.shell.origin, tool.shell.origin);
}

TEST(Recording, KnowsTheTipOfItsTool) {
  const auto whole = scene();
  ASSERT_GT(whole->tool.shell.tip.norm(), 0.001);
  const auto read = sceneFrom(wordsOf(*whole));
  ASSERT_TRUE(read) << sentence(read.error());
  EXPECT_EQ(read->tool.shell.tip, whole->tool.shell.tip);
}

TEST(Recording, MarksLieWhereTheyWereSet) {
  const ScratchFolder scratch;
  Bench bench(scratch / "r.palpate");
  bench.loop->recording.store(&bench.recorder->ring());
  bench.run(100);
  bench.recorder->note("mark", "here");
  bench.run(100);
  bench.recorder->note("mark", "there");
  ASSERT_TRUE(bench.recorder->finish());
  auto recording = Recording::open(bench.path);
  ASSERT_TRUE(recording);
  std::vector<const RecordedEvent*> marks;
  for (const RecordedEvent& event : recording->events())
    if (event.kind == "mark") marks.push_back(&event);
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0]->sequence, 99U);
  EXPECT_EQ(marks[0]->text, "here");
  EXPECT_EQ(marks[1]->sequence, 199U);
}

TEST(Recording, TakesAtMost300BytesAStepInContact) {
  const ScratchFolder scratch;
  const auto rows = recorded(scratch / "r.palpate", HandMotion::Slide, 10'000);
  std::size_t contacts = 0;
  for (const TraceRow& row : rows) contacts += row.bearing.size();
  const double bytes = double(fs::file_size(scratch / "r.palpate")) / 10'000.0;
  std::printf("%.1f bytes a step with %.2f contacts\n", bytes, double(contacts) / 10'000.0);
  EXPECT_GT(contacts, 10'000U);
  EXPECT_LT(bytes, 300.0);
}

TEST(Recording, WhatIsNoneIsRefusedWithAReason) {
  const ScratchFolder scratch;
  const auto reason = [](const fs::path& path) {
    const auto recording = Recording::open(path);
    return recording ? std::string{} : recording.error().reason;
  };
  EXPECT_EQ(reason(scratch / "none.palpate"), "not-found");
  EXPECT_EQ(reason(scratch.folder()), "not-found");
  std::ofstream(scratch / "text.palpate") << "this is text, and long enough to look at";
  EXPECT_EQ(reason(scratch / "text.palpate"), "no-recording");
  std::ofstream(scratch / "nothing.palpate");
  EXPECT_EQ(reason(scratch / "nothing.palpate"), "no-recording");
  const auto folder = Recorder::create("/proc/self/r.palpate", {"test", "", ""});
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().reason, "unwritable");
}

TEST(Recording, DamageIsRefusedAndNeverBelieved) {
  const ScratchFolder scratch;
  recorded(scratch / "r.palpate", HandMotion::Tap, 1500);
  std::ifstream file(scratch / "r.palpate", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  auto intact = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(intact);
  const auto truth = stepsIn(*intact);
  std::mt19937 random(7);
  int refused = 0;
  for (int n = 0; n < 400; ++n) {
    std::string bytes = whole;
    if (n % 4 == 0) bytes.resize(random() % bytes.size());
    for (int k = 0; k < 1 + n % 20 && !bytes.empty(); ++k)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    std::ofstream(scratch / "d.palpate", std::ios::binary | std::ios::trunc) << bytes;
    auto recording = Recording::open(scratch / "d.palpate");
    if (!recording) {
      EXPECT_FALSE(sentence(recording.error()).empty());
      ++refused;
      continue;
    }
    // zlib's sum stands over every block: what is read is what was written
    const auto read = recording->forEach(-kEver, kEver, [&](const RecordedStep& step) {
      const std::size_t i = step.step.sequence;
      EXPECT_TRUE(i < truth.size() && step.proxy == truth[i].proxy);
      return true;
    });
    if (!read) ++refused;
  }
  EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace recording_tests
