// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/emergency.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string_view>
#include <thread>

#include "haptics/servo/servo_loop.h"
#include "tests/scenario/fake_device.h"
#include "tests/support/made.h"

// However the program ends, its motors are stopped first.

namespace {

using made::at;

/// What a program is, to be ended: watched motors under way, which say when they are stopped.
template <class End>
void endUnderWay(End end) {
  haptics::installCrashStop();
  std::atexit([] { std::fputs("the rest\n", stderr); });
  auto device = std::make_unique<FakeDevice>(at(0, 0, 0.03));
  device->says_stopped = true;
  haptics::ServoLoop loop{std::move(device), {}, at(0, 0, 0.03)};
  loop.start();
  while (loop.boundary.load() < 20) std::this_thread::sleep_for(std::chrono::milliseconds{1});
  end();
}

// each in a process of its own: motors first, then the end as it would have been
TEST(Emergency, ACrashStopsTheMotorsAndThenGoesItsWay) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    EXPECT_EXIT(endUnderWay([signal] { raise(signal); }), testing::KilledBySignal(signal),
                "motors stopped")
        << signal;
}

// what a crash leaves for its report comes after that
TEST(Emergency, TheMotorsAreStoppedBeforeACrashIsWrittenDown) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  haptics::setAfterCrashStop([](int signal, void* context) {
    if (signal != SIGSEGV || context == nullptr) _exit(1);
    constexpr std::string_view kWords = "written down\n";
    if (write(STDERR_FILENO, kWords.data(), kWords.size()) < 0) _exit(1);
  });
  EXPECT_EXIT(endUnderWay([] { raise(SIGSEGV); }), testing::KilledBySignal(SIGSEGV),
              "motors stopped\nwritten down");
  haptics::setAfterCrashStop(nullptr);
}

TEST(Emergency, AThreadThatCrashesMeanwhileDoesNotEndTheFirstsWords) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  static std::atomic<bool> under_way{false};
  haptics::setAfterCrashStop([](int, void*) {
    under_way = true;
    const timespec time{0, 300'000'000};
    nanosleep(&time, nullptr);
    constexpr std::string_view kWords = "written down\n";
    if (write(STDERR_FILENO, kWords.data(), kWords.size()) < 0) _exit(1);
  });
  EXPECT_EXIT(endUnderWay([] {
                std::thread{[] {
                  while (!under_way) std::this_thread::yield();
                  raise(SIGBUS);
                }}.detach();
                raise(SIGSEGV);
              }),
              testing::KilledBySignal(SIGSEGV), "written down");
  haptics::setAfterCrashStop(nullptr);
}

// as where a lock or a disk is waited for
TEST(Emergency, ACrashEndsTheProcessWhateverIsWaitedFor) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  haptics::setAfterCrashStop([](int, void*) {
    for (;;) pause();
  });
  EXPECT_EXIT(endUnderWay([] { raise(SIGSEGV); }), testing::KilledBySignal(SIGALRM),
              "motors stopped");
  haptics::setAfterCrashStop(nullptr);
}

// as Xlib does when the display is gone
TEST(Emergency, AProcessThatExitsByItselfStopsTheMotorsFirst) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(endUnderWay([] { std::exit(7); }), testing::ExitedWithCode(7),
              "motors stopped\nthe rest");
}

int fallFor(int depth) {
  volatile char kept[4096];
  kept[0] = static_cast<char>(depth);
  return depth == 0 ? 0 : fallFor(depth - 1) + kept[0];
}

TEST(Emergency, TheEndOfTheStackStopsThemToo) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(endUnderWay([] { std::exit(fallFor(100'000'000)); }),
              testing::KilledBySignal(SIGSEGV), "motors stopped");
}

TEST(Emergency, StoppedMotorsStayStopped) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto stop = [] {
    auto made = std::make_unique<FakeDevice>(at(0, 0, 0.03));
    FakeDevice* device = made.get();
    haptics::ServoLoop loop{std::move(made), {}, at(0, 0, 0.03)};
    loop.start();
    while (loop.boundary.load() < 20) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    haptics::stopAllMotors();
    while (!device->stopped) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    for (int n = 0; n < 100; ++n) {
      if (!device->stopped) std::_Exit(1);
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(stop(), testing::ExitedWithCode(0), "");
}

}  // namespace
