// SPDX-License-Identifier: BSD-3-Clause
#include "app/background/task.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/sentence.h"

namespace {

using app::background::Task;
using app::background::Watch;
using haptics::Expected;

/// An event loop on the test's own thread.
class BackgroundTask : public testing::Test {
 protected:
  static bool waitFor(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{120};
    while (!done() && std::chrono::steady_clock::now() < end) {
      QCoreApplication::processEvents();
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return done();
  }

 private:
  std::string name_ = "background_test";
  int count_ = 1;
  char* names_ = name_.data();
  QCoreApplication application_{count_, &names_};
};

Expected<int> untilCancelled(const Watch& watch) {
  while (!watch.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds{1});
  return tl::unexpected(haptics::Error{haptics::Error::Kind::Cancelled, "Stopped.", "cancelled"});
}

TEST_F(BackgroundTask, WorksOnAnotherThreadAndAnswersOnThisOne) {
  const auto here = std::this_thread::get_id();
  std::thread::id worked, answered;
  std::optional<int> answer;
  Task<int> task;
  EXPECT_FALSE(task.isRunning());
  task.start(
      [&](const Watch&) -> Expected<int> {
        worked = std::this_thread::get_id();
        return 42;
      },
      [&](Expected<int> result) {
        answered = std::this_thread::get_id();
        answer = *result;
        EXPECT_FALSE(task.isRunning());
      });
  EXPECT_TRUE(task.isRunning());
  EXPECT_FALSE(answer);
  ASSERT_TRUE(waitFor([&] { return answer.has_value(); }));
  EXPECT_EQ(answer, 42);
  EXPECT_NE(worked, here);
  EXPECT_EQ(answered, here);
}

TEST_F(BackgroundTask, ReportsProgressAndWhatItIsToldInOrderBeforeTheResult) {
  std::vector<double> fractions;
  std::vector<std::string> told;
  std::atomic<int> reported = 0;
  double seconds = 0.0;
  Task<int> task([&](double fraction) {
    fractions.push_back(fraction);
    ++reported;
  });
  task.start(
      [&](const Watch& watch) -> Expected<int> {
        const auto begun = std::chrono::steady_clock::now();
        const auto elapsed = [&] {
          return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        };
        for (int i = 1; i <= 100'000; ++i) watch.advanced(i / 200'000.0);
        while (reported < 4 && elapsed() < 100.0) watch.advanced(0.5 + 1e-3 * elapsed());
        seconds = elapsed();
        watch.tell([&] { told.emplace_back("first"); });
        watch.tell([&] { told.emplace_back("second"); });
        return 0;
      },
      [&](const Expected<int>&) { told.emplace_back("result"); });
  ASSERT_TRUE(waitFor([&] { return told.size() == 3; }));
  EXPECT_EQ(told, (std::vector<std::string>{"first", "second", "result"}));
  // each has the window drawn anew, beside the work
  EXPECT_GE(fractions.size(), 4U);
  EXPECT_LE(double(fractions.size()), 10.0 * seconds + 2.0);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
}

TEST_F(BackgroundTask, CancelInMidWorkIsAnsweredByTheWork) {
  std::optional<Expected<int>> answer;
  Task<int> task;
  task.cancel();  // nothing to cancel
  task.start(untilCancelled, [&](Expected<int> result) { answer = std::move(result); });
  QCoreApplication::processEvents();
  EXPECT_TRUE(task.isRunning());
  task.cancel();
  ASSERT_TRUE(waitFor([&] { return answer.has_value(); }));
  ASSERT_FALSE(answer->has_value());
  EXPECT_EQ(answer->error().kind, haptics::Error::Kind::Cancelled);
}

// a file that is written after all must be told of, and not taken for one that is not there
TEST_F(BackgroundTask, WorkThatSucceedsThoughItWasCancelledHasSucceeded) {
  std::optional<Expected<int>> answer;
  Task<int> task;
  task.start(
      [](const Watch& watch) -> Expected<int> {
        (void)untilCancelled(watch);
        return 7;
      },
      [&](Expected<int> result) { answer = std::move(result); });
  task.cancel();
  ASSERT_TRUE(waitFor([&] { return answer.has_value(); }));
  EXPECT_EQ(*answer, 7);
}

TEST_F(BackgroundTask, TheTokenSaysWhatTheFlagSays) {
  bool asked = false;
  Task<int> task;
  task.start(
      [](const Watch& watch) -> Expected<int> {
        while (!watch.stop.stop_requested())
          std::this_thread::sleep_for(std::chrono::milliseconds{1});
        return watch.cancelled() ? 1 : 0;
      },
      [&](const Expected<int>& result) { asked = *result == 1; });
  task.cancel();
  EXPECT_TRUE(waitFor([&] { return asked; }));
}

TEST_F(BackgroundTask, AbandonedItIsHeardOfNoMore) {
  int heard = 0;
  Task<int> task([&](double) { ++heard; });
  task.start(
      [&](const Watch& watch) {
        watch.advanced(0.5);
        watch.tell([&] { ++heard; });
        return untilCancelled(watch);
      },
      [&](const Expected<int>&) { ++heard; });
  std::this_thread::sleep_for(std::chrono::milliseconds{20});
  task.abandon();
  EXPECT_FALSE(task.isRunning());
  task.wait();
  QCoreApplication::processEvents();
  EXPECT_EQ(heard, 0);
}

TEST_F(BackgroundTask, DestroyedInMidWorkItStopsJoinsAndIsHeardOfNoMore) {
  int heard = 0;
  bool ended = false;
  {
    Task<int> task;
    task.start(
        [&](const Watch& watch) {
          watch.tell([&] { ++heard; });
          auto result = untilCancelled(watch);
          std::this_thread::sleep_for(std::chrono::milliseconds{20});
          ended = true;
          return result;
        },
        [&](const Expected<int>&) { ++heard; });
  }
  EXPECT_TRUE(ended);
  QCoreApplication::processEvents();
  EXPECT_EQ(heard, 0);
}

TEST_F(BackgroundTask, WhatTheWorkThrowsArrivesAsAnError) {
  const auto errorOf = [](const std::function<Expected<int>(const Watch&)>& work) {
    std::optional<haptics::Error> error;
    Task<int> task;
    task.start(work, [&](const Expected<int>& result) { error = result.error(); });
    EXPECT_TRUE(waitFor([&] { return error.has_value(); }));
    return error.value_or(haptics::Error{});
  };
  const auto memory = errorOf([](const Watch&) -> Expected<int> { throw std::bad_alloc{}; });
  EXPECT_EQ(memory.reason, app::background::kNoMemory);
  EXPECT_NE(sentence(memory).find("memory"), std::string::npos);
  const auto other =
      errorOf([](const Watch&) -> Expected<int> { throw std::runtime_error{"the words"}; });
  EXPECT_EQ(other.reason, app::background::kThrew);
  EXPECT_EQ(sentence(other), "the words");
  const auto odd = errorOf([](const Watch&) -> Expected<int> { throw 7; });
  EXPECT_EQ(odd.reason, app::background::kThrew);
}

TEST_F(BackgroundTask, StartedAgainItDropsTheWorkBeforeWithoutWaitingForIt) {
  std::atomic<bool> release{false};
  std::vector<int> answers;
  Task<int> task;
  task.start(
      [&](const Watch& watch) -> Expected<int> {  // cannot stop at once
        while (!release) std::this_thread::sleep_for(std::chrono::milliseconds{1});
        EXPECT_TRUE(watch.cancelled());
        return 1;
      },
      [&](const Expected<int>& result) { answers.push_back(*result); });
  task.start([](const Watch&) -> Expected<int> { return 2; },
             [&](const Expected<int>& result) { answers.push_back(*result); });
  ASSERT_TRUE(waitFor([&] { return !answers.empty(); }));
  release = true;
  task.wait();
  QCoreApplication::processEvents();
  EXPECT_EQ(answers, std::vector<int>{2});
}

TEST_F(BackgroundTask, TheResultMayStartItAgain) {
  int last = 0;
  Task<int> task;
  std::function<void(const Expected<int>&)> next = [&](const Expected<int>& result) {
    last = *result;
    if (last < 3) task.start([last](const Watch&) -> Expected<int> { return last + 1; }, next);
  };
  task.start([](const Watch&) -> Expected<int> { return 1; }, next);
  EXPECT_TRUE(waitFor([&] { return last == 3; }));
}

TEST_F(BackgroundTask, WhatTheWorkHoldsIsGoneBeforeTheResultArrives) {
  std::atomic<bool> gone = false;
  // slow to go, as a file that is closed
  std::shared_ptr<int> held{new int{7}, [&](const int* number) {
                              std::this_thread::sleep_for(std::chrono::milliseconds{50});
                              delete number;
                              gone = true;
                            }};
  std::optional<bool> gone_by_then;
  Task<int> task;
  task.start([held = std::move(held)](const Watch&) -> Expected<int> { return *held; },
             [&](const Expected<int>&) { gone_by_then = gone.load(); });
  ASSERT_TRUE(waitFor([&] { return gone_by_then.has_value(); }));
  EXPECT_TRUE(*gone_by_then);
}

}  // namespace
