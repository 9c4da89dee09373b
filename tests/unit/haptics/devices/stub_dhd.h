// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

/// What the stub of Force Dimension's library answers, and what it was told. The stub is a module
/// of its own, which exports the functions that the driver calls; a test reaches this through
/// `stubDhd`, which the module exports as well.
struct StubDhd {
  // what it answers
  std::atomic<int> major{3}, minor{17}, release{5};
  std::atomic<int> count{1}, model{104};
  std::atomic<int> open_result{0}, last_error{0}, expert_result{0}, watchdog_result{0},
      enable_result{0}, weight_result{0}, state_result{0}, pose_result{0}, wrench_result{0};
  std::atomic<bool> active_wrist{true}, initialised{true};
  std::atomic<int> connected{1}, reset{0}, force{0}, cause{0};
  std::array<std::atomic<double>, 3> p_F{};
  std::array<std::atomic<double>, 9> R_FD{};  ///< row by row
  std::atomic<unsigned> buttons{0};
  std::atomic<int> pose_ms{0};  ///< so long it takes to tell where it is

  // what it was told
  std::atomic<int> opened{-1}, opened_by_robotics{0}, closes{0}, brakes{0}, enables{0},
      watchdog{-1}, weight{-1};
  std::atomic<long> poses{0};                 ///< how often it was asked for one
  std::atomic<long> rounds{0};                ///< wrenches that were sent
  std::atomic<long> wrenches_unlike_zero{0};  ///< of them, in force or torque
  std::atomic<bool> not_finite{false};        ///< one of them
  std::atomic<bool> asked_after_close{false};

  std::array<double, 7> wrench() {
    const std::lock_guard lock{mutex};
    return last;
  }
  /// When it was asked for a pose, and the wrench that it had then.
  struct Asked {
    std::int64_t at_ns = 0;
    std::array<double, 7> wrench{};
  };
  /// For the n-th pose, from 1 on: one of the last that were asked for.
  Asked asked(long n) {
    const std::lock_guard lock{mutex};
    return asks[static_cast<std::size_t>(n) % asks.size()];
  }
  std::mutex mutex;  ///< of what follows
  std::array<double, 7> last{};
  std::array<Asked, 4096> asks{};
};
