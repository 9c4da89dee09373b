// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "app/crash/raw_file.h"
#include "app/crash/report.h"
#include "app/log/log.h"
#include "haptics/servo/emergency.h"
#include "tests/support/scratch_folder.h"

namespace fs = std::filesystem;

/// Where the process ends; each has its name in the report.
namespace crash_places {

using Void = void (*)();
volatile Void nowhere = nullptr;
int* volatile no_number = nullptr;
volatile int after = 0;

[[gnu::noinline]] void touchNothing() {
  *no_number = 1;
  after = 1;
}
[[gnu::noinline]] void callTouchNothing() {
  touchNothing();
  after = 2;
}
[[gnu::noinline]] void callNowhere() {
  nowhere();
  after = 1;
}
[[gnu::noinline]] void giveUp() { std::abort(); }
[[gnu::noinline]] int fallFor(int depth) {
  volatile char kept[4096];
  kept[0] = static_cast<char>(depth);
  return depth == 0 ? 0 : fallFor(depth - 1) + kept[0];
}

}  // namespace crash_places

namespace {

using namespace app;

class Crash : public testing::Test {
 protected:
  const fs::path& folder() const { return scratch_.folder(); }

  /// The signal that ends a process which begins as main() does and then does this; 0: none.
  template <class End>
  int signalOf(End end) const {
    const pid_t process = fork();
    if (process == 0) {
      const rlimit none{};
      setrlimit(RLIMIT_CORE, &none);
      begin(end);
      _exit(0);
    }
    int status = 0;
    waitpid(process, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }
  template <class End>
  void begin(End end) const {
    haptics::installCrashStop();
    log::open(folder(), log::Level::Info);
    const crash::RawFile raw{folder()};
    for (int n = 0; n < 70; ++n) log::write(log::Level::Info, "step", {{"number", n}});
    end();
  }
  std::optional<std::string> takeReport() const { return crash::takeReport(folder(), cancel_); }
  std::optional<std::string> reportOf(const std::string& raw) const {
    return crash::reportOf(raw, folder(), crash::Names::Sought, cancel_);
  }
  std::vector<fs::path> rawFiles() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator{folder()})
      if (entry.path().extension() == ".raw") found.push_back(entry.path());
    return found;
  }

  support::ScratchFolder scratch_;
  std::atomic<bool> cancel_ = false;
};

TEST_F(Crash, TheNextStartNamesTheFunctionsAndNoPath) {
  EXPECT_EQ(signalOf(crash_places::callTouchNothing), SIGSEGV);
  ASSERT_EQ(rawFiles().size(), 1U);
  EXPECT_EQ(fs::status(rawFiles().front()).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  const auto report = takeReport();
  ASSERT_TRUE(report);
  const std::size_t here = report->find("#0 crash_test+0x"),
                    name = report->find("crash_places::touchNothing()"),
                    caller = report->find("crash_places::callTouchNothing()");
  EXPECT_LT(here, name);
  EXPECT_LT(name, caller);
  EXPECT_NE(caller, std::string::npos);
  EXPECT_NE(report->find("SIGSEGV"), std::string::npos);
  // the frame behind the first is its caller's, not one of the handler's
  const std::size_t second = report->find("#1 crash_test+0x");
  EXPECT_LT(second, caller);
  EXPECT_EQ(report->find('\n', second), report->find('\n', caller));
  EXPECT_EQ(report->find('/'), report->find("GNU/") + 3) << "a path";
  EXPECT_EQ(report->find('/', report->find("GNU/") + 4), std::string::npos) << "a path";
  // the last 50 lines of that process
  EXPECT_EQ(report->find("number=19"), std::string::npos);
  EXPECT_NE(report->find("number=20\n"), std::string::npos);
  EXPECT_NE(report->find("number=69\n"), std::string::npos);
  // kept for the user, and told once
  EXPECT_TRUE(rawFiles().empty());
  std::stringstream kept;
  kept << std::ifstream{crash::reportFile(folder())}.rdbuf();
  EXPECT_EQ(kept.str(), *report);
  EXPECT_EQ(fs::status(folder()).permissions(), fs::perms::owner_all);
  EXPECT_FALSE(takeReport());
}

TEST_F(Crash, EverySignalIsKeptAndReported) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    EXPECT_EQ(signalOf([signal] { raise(signal); }), signal);
    const auto report = takeReport();
    ASSERT_TRUE(report) << signal;
    EXPECT_NE(report->find(std::string{"SIG"} + sigabbrev_np(signal)), std::string::npos);
  }
}

TEST_F(Crash, AbortAndACallToNowhereNameTheCaller) {
  EXPECT_EQ(signalOf(crash_places::giveUp), SIGABRT);
  auto report = takeReport();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("crash_places::giveUp()"), std::string::npos) << *report;
  EXPECT_EQ(signalOf(crash_places::callNowhere), SIGSEGV);
  report = takeReport();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("#0 no module 0x0"), std::string::npos) << *report;
  EXPECT_NE(report->find("crash_places::callNowhere()"), std::string::npos) << *report;
}

TEST_F(Crash, AThreadAndTheEndOfTheStackAreReported) {
  EXPECT_EQ(signalOf([] { std::thread{crash_places::touchNothing}.join(); }), SIGSEGV);
  auto report = takeReport();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("crash_places::touchNothing()"), std::string::npos) << *report;
  EXPECT_EQ(signalOf([] { std::exit(crash_places::fallFor(100'000'000)); }), SIGSEGV);
  report = takeReport();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("crash_places::fallFor(int)"), std::string::npos) << *report;
  const auto numbered = [](int frame) { return "#" + std::to_string(frame) + " "; };
  EXPECT_NE(report->find(numbered(crash::raw::kMostFrames - 1)), std::string::npos) << *report;
  EXPECT_EQ(report->find(numbered(crash::raw::kMostFrames)), std::string::npos)
      << "more frames than are kept";
}

TEST_F(Crash, AnEndWithoutACrashLeavesNothing) {
  EXPECT_EQ(signalOf([] {}), 0);
  EXPECT_TRUE(rawFiles().empty());
  // killed: nothing was written, and nothing is told
  EXPECT_EQ(signalOf([] { raise(SIGKILL); }), SIGKILL);
  EXPECT_EQ(rawFiles().size(), 1U);
  EXPECT_FALSE(takeReport());
  EXPECT_TRUE(rawFiles().empty());
}

TEST_F(Crash, TheFileOfAProcessThatRunsIsLeftAlone) {
  const crash::RawFile raw{folder()};
  ASSERT_EQ(rawFiles().size(), 1U);
  EXPECT_FALSE(takeReport());
  EXPECT_EQ(rawFiles().size(), 1U);
  // a second one crashes
  EXPECT_EQ(signalOf(crash_places::touchNothing), SIGSEGV);
  EXPECT_TRUE(takeReport());
  EXPECT_EQ(rawFiles().size(), 1U);
}

TEST_F(Crash, TwoCrashesAreOneReport) {
  EXPECT_EQ(signalOf(crash_places::touchNothing), SIGSEGV);
  EXPECT_EQ(signalOf(crash_places::giveUp), SIGABRT);
  EXPECT_EQ(rawFiles().size(), 2U);
  const auto report = takeReport();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("crash_places::touchNothing()"), std::string::npos) << *report;
  EXPECT_NE(report->find("crash_places::giveUp()"), std::string::npos) << *report;
  EXPECT_TRUE(rawFiles().empty());
}

TEST_F(Crash, AReportThatIsCancelledIsMadeByTheNextStart) {
  EXPECT_EQ(signalOf(crash_places::touchNothing), SIGSEGV);
  cancel_ = true;
  EXPECT_FALSE(takeReport());
  EXPECT_EQ(rawFiles().size(), 1U);
  EXPECT_FALSE(fs::exists(crash::reportFile(folder())));
  cancel_ = false;
  const auto report = takeReport();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("crash_places::touchNothing()"), std::string::npos) << *report;
}

// or a module that libdw cannot bear would end every start
TEST_F(Crash, WhereLookingForNamesEndedTheProcessTheNextReportHasNone) {
  const fs::path mark = folder() / "crash-names";
  EXPECT_EQ(signalOf(crash_places::touchNothing), SIGSEGV);
  const int watch = inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
  ASSERT_GE(inotify_add_watch(watch, folder().c_str(), IN_CREATE), 0);
  auto report = takeReport();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("crash_places::touchNothing()"), std::string::npos) << *report;
  alignas(inotify_event) std::array<char, sizeof(inotify_event) + NAME_MAX + 1> event{};
  ASSERT_GT(read(watch, event.data(), event.size()), 0);
  close(watch);
  EXPECT_EQ(reinterpret_cast<const inotify_event*>(event.data())->name, mark.filename());
  EXPECT_FALSE(fs::exists(mark));

  EXPECT_EQ(signalOf(crash_places::touchNothing), SIGSEGV);
  std::ofstream{mark};
  report = takeReport();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("#0 crash_test+0x"), std::string::npos) << *report;
  EXPECT_EQ(report->find("touchNothing"), std::string::npos) << *report;
  EXPECT_NE(report->find("names were not sought"), std::string::npos) << *report;
  EXPECT_FALSE(fs::exists(mark));
}

TEST_F(Crash, AFullDiskCostsTheReportAlone) {
  EXPECT_EQ(signalOf([] {
              std::signal(SIGXFSZ, SIG_IGN);
              const rlimit none{};
              setrlimit(RLIMIT_FSIZE, &none);
              crash_places::touchNothing();
            }),
            SIGSEGV);
  EXPECT_EQ(rawFiles().size(), 1U);
  EXPECT_FALSE(takeReport());
  EXPECT_TRUE(rawFiles().empty());
}

TEST_F(Crash, WhereNothingCanBeWrittenTheSignalIsKept) {
  std::ofstream{folder() / "file"} << "in the way";
  EXPECT_EQ(signalOf([this] {
              const crash::RawFile raw{folder() / "file"};
              crash_places::touchNothing();
            }),
            SIGSEGV);
  fs::remove(rawFiles().front());
  EXPECT_FALSE(crash::takeReport(folder() / "file", cancel_));
  EXPECT_FALSE(crash::takeReport({}, cancel_));
}

TEST_F(Crash, ADamagedFileIsReadAsFarAsItGoes) {
  EXPECT_EQ(signalOf(crash_places::touchNothing), SIGSEGV);
  std::stringstream whole;
  whole << std::ifstream{rawFiles().front()}.rdbuf();
  const std::string text = whole.str();
  const std::size_t signal = text.find("\nsignal ") + 1;
  ASSERT_NE(signal, 0U) << text;
  const std::size_t told = text.find('\n', signal);
  for (std::size_t length = 0; length <= text.size(); ++length) {
    // symbols take a while: of the frames only a few ends
    if (length > told + 80 && length % 97 != 0) continue;
    EXPECT_EQ(reportOf(text.substr(0, length)).has_value(), length > told) << length;
  }
  std::mt19937 random{7};
  int told_of = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string damaged = text.substr(0, told + 200);
    for (int n = 0; n < 4; ++n) damaged[random() % damaged.size()] = static_cast<char>(random());
    const auto report = reportOf(damaged);
    if (!report) continue;
    ++told_of;
    EXPECT_LT(report->size(), 100'000U);
  }
  EXPECT_GT(told_of, 100);
  for (const char* line :
       {"at", "at ", "at - ", "at - 0", "at - 0 2", "at zz 0 1", "at - 10000000000000000 1",
        "at abcdef 0 1", "at a 0 1", "version /home/x", "session /home/x", "signal 999999999999"})
    EXPECT_TRUE(reportOf("palpate-crash 1\nsignal b\n" + std::string{line} + "\n")) << line;
  EXPECT_FALSE(reportOf("palpate-crash 2\nsignal b\n"));
  EXPECT_FALSE(reportOf("palpate-crash 1\nsignal -b\n"));
  const auto planted =
      reportOf("palpate-crash 1\nsignal b\nversion ../../home\nbuild /home\nat /home/x 1 1\n");
  ASSERT_TRUE(planted);
  EXPECT_EQ(planted->find("home"), std::string::npos);
  std::ofstream{folder() / "garbage.raw"} << std::string(200'000, '\xff');
  EXPECT_TRUE(takeReport());  // of the whole one
  EXPECT_TRUE(rawFiles().empty());
}

// whatever server the environment names
TEST_F(Crash, AsksNoServerForSymbols) {
  EXPECT_EQ(signalOf(crash_places::touchNothing), SIGSEGV);
  ASSERT_EQ(setenv("DEBUGINFOD_URLS", "http://127.0.0.1:1", 1), 0);
  ASSERT_EQ(setenv("DEBUGINFOD_CACHE_PATH", (folder() / "cache").c_str(), 1), 0);
  ASSERT_TRUE(takeReport());
  // its client makes its folder before it asks
  EXPECT_FALSE(fs::exists(folder() / "cache"));
}

}  // namespace
