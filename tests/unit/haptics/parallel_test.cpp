// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using haptics::inParallel;

TEST(InParallel, DoesEachPieceOnceOnAnyNumberOfThreads) {
  for (const std::int64_t count : {0, 1, 2, 5, 1000})
    for (const int threads : {1, 2, 3, 7}) {
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
      inParallel(
          count, [&](std::int64_t n) { ++done[static_cast<std::size_t>(n)]; }, threads);
      for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
    }
}

TEST(InParallel, OneThreadIsTheCallersAndSeveralAreNoMoreThanWanted) {
  for (const int threads : {1, 3}) {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    inParallel(
        500,
        [&](std::int64_t) {
          std::this_thread::yield();
          const std::scoped_lock lock(mutex);
          seen.insert(std::this_thread::get_id());
        },
        threads);
    EXPECT_LE(seen.size(), static_cast<std::size_t>(threads));
    if (threads == 1) {
      EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
    }
  }
}

TEST(InParallel, ThrowsOnWhatAPieceThrowsAndLeavesTheRestOut) {
  std::atomic<int> done{0};
  EXPECT_THROW(inParallel(
                   10'000,
                   [&](std::int64_t n) {
                     if (n == 10) throw std::runtime_error("a piece");
                     // seconds for all of them, however late the one that throws gets a core
                     if (n > 10) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                     ++done;
                   },
                   3),
               std::runtime_error);
  EXPECT_LT(done, 9'999);
}

}  // namespace
