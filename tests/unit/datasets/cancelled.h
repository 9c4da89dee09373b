// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stop_token>
#include <string>
#include <thread>

#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/scans.h"

namespace datasets::testing {

/// A packed NRRD of which every second voxel is read: the read ends soon after it is cancelled.
inline void expectCancelEnds(const std::filesystem::path& path) {
  std::atomic<bool> cancel = false;
  double last = 0.0;
  // all of it would be inflated at once; a part is not
  const auto v = readVolume(path, {.part = {.step = 2}},
                            {[&](double f) {
                               last = f;
                               cancel = f > 0.3;
                             },
                             &cancel});
  ASSERT_FALSE(v);
  EXPECT_EQ(v.error().kind, haptics::Error::Kind::Cancelled);
  EXPECT_GT(last, 0.3);
  EXPECT_LT(last, 0.4);
}

/// A packed NRRD that is inflated at once: the read ends when it is cancelled, and what goes on
/// inflating disturbs no later read.
inline void expectCancelLeavesInflating(const std::filesystem::path& path) {
  // the call cannot be stopped, and has a thread of its own
  const auto inflates = [] {
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
      std::string name;
      if (std::ifstream(task.path() / "comm") >> name && name == "palpate-inflate") return true;
    }
    return false;
  };
  std::atomic<bool> cancel = false;
  {
    std::jthread canceller([&](const std::stop_token& stop) {
      while (!stop.stop_requested() && !inflates())
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
      cancel = true;
    });
    const auto v = readVolume(path, {}, {[](double) {}, &cancel});
    ASSERT_FALSE(v);
    EXPECT_EQ(v.error().kind, haptics::Error::Kind::Cancelled);
  }
  // what was left behind, and may still be at work, is nobody else's
  const auto whole = readVolume(path);
  ASSERT_TRUE(whole) << sentence(whole.error());
  const auto half = readVolume(path, {.part = {.step = 2}});  // not inflated at once
  ASSERT_TRUE(half);
  for (std::int64_t k = 0; k < half->grid.dims[2]; k += 20)
    for (std::int64_t j = 0; j < half->grid.dims[1]; j += 20)
      for (std::int64_t i = 0; i < half->grid.dims[0]; i += 20)
        ASSERT_EQ(voxelAt(*half, i, j, k), voxelAt(*whole, 2 * i, 2 * j, 2 * k));
}

}  // namespace datasets::testing
