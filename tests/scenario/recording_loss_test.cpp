// SPDX-License-Identifier: BSD-3-Clause
// What is left of a recording after the process is killed, the power cut or the disk filled.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>
#include <vector>

#include "app/recording/recorder.h"
#include "app/recording/recording.h"
#include "app/recording/unfinished.h"
#include "tests/support/failing_disk.h"
#include "tests/support/made.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"

extern char** environ;

namespace recording_loss {

using namespace app;
using namespace haptics;

namespace {

namespace fs = std::filesystem;
using support::ScratchFolder;

/// A step that only its number makes, with noise as of a hand.
Step stepNumbered(std::uint64_t n) {
  Step step;
  std::mt19937_64 random(n);
  const auto noise = [&] { return double(random() % 1000003) * 1e-9; };
  step.time_ns = static_cast<std::int64_t>(n) * 1'000'000;
  step.X_WD.translation() = Vec3(noise(), noise(), 0.1 * std::sin(0.001 * double(n)));
  step.X_WP.translation() = Vec3(noise(), noise(), noise());
  step.sent_W.force = {noise(), noise(), noise()};
  step.settings = {300.0, 1000.0, 0.0, 0.0};
  step.scene = 0;
  step.contacts.push({{noise(), noise(), noise()}, {0.0, 0.0, 1.0}, noise()});
  return step;
}

/// How many steps are in it; fails if one is not what it was, or there is a hole.
std::int64_t intactSteps(const fs::path& path) {
  auto recording = Recording::open(path);
  EXPECT_TRUE(recording) << sentence(recording.error());
  if (!recording) return -1;
  EXPECT_EQ(recording->lostCount(), 0);
  const auto read = recording->forEach(-1e9, 1e9, [](const RecordedStep& recorded) {
    const Step expected = stepNumbered(recorded.step.sequence);
    EXPECT_EQ(recorded.step.X_WD.translation(), expected.X_WD.translation());
    EXPECT_EQ(recorded.step.sent_W.force, expected.sent_W.force);
    return !::testing::Test::HasFailure();
  });
  EXPECT_TRUE(read);
  return recording->stepCount();
}

// ---- killed ----

/// What a recording process tells through shared memory, up to the moment it is killed.
struct Told {
  std::atomic<std::uint64_t> produced{0}, committed{0};
};

Told* toldIn(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0 || ftruncate(file, sizeof(Told)) != 0) return nullptr;
  void* memory = mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  return static_cast<Told*>(memory);
}

constexpr const char* kRecordIn = "PALPATE_RECORD_IN";

/// What the next test starts and kills: records in real time until then.
int recordIn(const fs::path& folder) {
  Told* told = toldIn(folder / "told");
  auto recorder = Recorder::create(folder / "r.palpate", {"test", "", ""});
  if (told == nullptr || !recorder) return 1;
  StepRing& ring = (*recorder)->ring();
  ring.start({});
  const auto begun = std::chrono::steady_clock::now();
  for (std::uint64_t n = 0; n < 60'000; ++n) {
    std::this_thread::sleep_until(begun + std::chrono::milliseconds(n));
    Step step = stepNumbered(n);
    ring.push(step);
    told->produced = n + 1;
    told->committed = static_cast<std::uint64_t>((*recorder)->status().steps);
  }
  return 0;
}

pid_t startChild(const fs::path& folder) {
  char self[] = "/proc/self/exe";
  char* arguments[] = {self, nullptr};
  setenv(kRecordIn, folder.c_str(), 1);
  pid_t child = -1;
  posix_spawn(&child, self, nullptr, nullptr, arguments, environ);
  unsetenv(kRecordIn);
  return child;
}

TEST(RecordingLoss, OfAHundredKilledProcessesIsAtMostWhatWasNotYetCommitted) {
  constexpr int kRounds = made::trials(20), kAtOnce = 5;
  std::mt19937 random(11);
  std::vector<std::uint64_t> losses;
  for (int round = 0; round < kRounds; ++round) {
    const ScratchFolder scratch;
    struct Child {
      fs::path folder;
      Told* told = nullptr;
      pid_t pid = -1;
      std::uint64_t until = 0;
    };
    std::vector<Child> children(kAtOnce);
    for (int c = 0; c < kAtOnce; ++c) {
      Child& child = children[static_cast<std::size_t>(c)];
      child.folder = scratch.folder() / std::to_string(c);
      fs::create_directory(child.folder);
      child.told = toldIn(child.folder / "told");
      ASSERT_NE(child.told, nullptr);
      child.until = 1 + random() % 1200;  // steps
      child.pid = startChild(child.folder);
      ASSERT_GT(child.pid, 0);
    }
    // each at its own moment
    for (std::size_t alive = children.size(); alive > 0;) {
      for (Child& child : children) {
        if (child.pid < 0 || child.told->produced < child.until) continue;
        kill(child.pid, SIGKILL);
        int status = 0;
        waitpid(child.pid, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status));
        child.pid = -1;
        --alive;
      }
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    for (const Child& child : children) {
      const auto recovered = recover(partOf(child.folder / "r.palpate"));
      std::int64_t steps = 0;
      if (recovered)
        steps = intactSteps(*recovered);
      else
        ASSERT_EQ(recovered.error().reason, "empty") << sentence(recovered.error());
      EXPECT_GE(static_cast<std::uint64_t>(steps), child.told->committed.load());
      losses.push_back(child.told->produced - static_cast<std::uint64_t>(steps));
      munmap(child.told, sizeof(Told));
    }
  }
  std::sort(losses.begin(), losses.end());
  std::printf("%zu kills: median loss %llu ms, worst %llu ms; %zu lost more than 300\n",
              losses.size(), static_cast<unsigned long long>(losses[losses.size() / 2]),
              static_cast<unsigned long long>(losses.back()),
              static_cast<std::size_t>(losses.end() -
                                       std::upper_bound(losses.begin(), losses.end(), 300U)));
  // the machine may hold the writer up; a writer that does not commit in time is another matter
  EXPECT_LE(losses[losses.size() / 2], 300U);
}

// ---- power and room ----

/// Fills a ring and has it written, `rounds` times, until the disk fails.
std::int64_t committedOn(const support::FailingDisk& disk, int rounds, std::string* failure) {
  Recorder::Options options;
  options.commit_every = std::chrono::hours(1);
  options.vfs = disk.name();
  auto recorder = Recorder::create("r.palpate", {"test", "", ""}, options);
  if (!recorder) {
    *failure = sentence(recorder.error());
    return 0;
  }
  StepRing& ring = (*recorder)->ring();
  ring.start({});
  std::int64_t committed = 0;
  std::uint64_t n = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::int64_t before = committed;
    for (int i = 0; i < 250; ++i) {
      Step step = stepNumbered(n++);
      ring.push(step);
    }
    while (committed < before + 250 && (*recorder)->status().failure.empty()) {
      (*recorder)->hurry();
      std::this_thread::yield();
      committed = (*recorder)->status().steps;
    }
    *failure = sentence((*recorder)->status().failure);
    if (!failure->empty()) break;
  }
  return committed;
}

TEST(RecordingLoss, OfPowerIsNothingThatWasCommitted) {
  std::mt19937 random(5);
  int with_steps = 0;
  const int trials = made::trials(150);
  for (int n = 0; n < trials; ++n) {
    const ScratchFolder scratch;
    support::FailingDisk disk;
    disk.cutAfter(static_cast<std::int64_t>(random() % 600));
    std::string failure;
    const std::int64_t committed = committedOn(disk, 20, &failure);
    ASSERT_TRUE(disk.isCut() || failure.empty());
    disk.saveAfterPowerCut(scratch.folder(), random());
    if (committed == 0) continue;
    ++with_steps;
    const auto recovered = recover(scratch.folder() / "r.palpate.part");
    ASSERT_TRUE(recovered) << sentence(recovered.error()) << " after " << n;
    ASSERT_GE(intactSteps(*recovered), committed);
    if (HasFailure()) return;
  }
  EXPECT_GT(5 * with_steps, 2 * trials);
}

TEST(RecordingLoss, OfAFullDiskIsToldAndWhatWasCommittedStays) {
  for (const std::int64_t room : {20'000, 100'000, 700'000, 1'500'000}) {
    const ScratchFolder scratch;
    support::FailingDisk disk;
    disk.setRoom(room);
    std::string failure;
    const std::int64_t committed = committedOn(disk, 100, &failure);
    EXPECT_NE(failure.find("the disk is full"), std::string::npos) << failure;
    if (room <= 100'000) continue;  // not even the tables, or the first block
    EXPECT_GT(committed, 0);
    disk.save(scratch.folder());
    const auto recovered = recover(scratch.folder() / "r.palpate.part");
    ASSERT_TRUE(recovered) << sentence(recovered.error());
    EXPECT_GE(intactSteps(*recovered), committed);
  }
}

TEST(RecordingLoss, OfAFileSystemThatCannotBeWrittenIsToldAtOnce) {
  const auto recorder = Recorder::create("/proc/r.palpate", {"test", "", ""});
  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.error().reason, "unwritable");
  EXPECT_NE(sentence(recorder.error()).find("choose a folder"), std::string::npos);
}

}  // namespace
}  // namespace recording_loss

int main(int argc, char** argv) {
  if (const char* folder = std::getenv(recording_loss::kRecordIn))
    return recording_loss::recordIn(folder);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
