// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

/// What the stub of OpenHaptics answers, and what it was told; reached through `stubHd`, as with
/// stub_dhd.h. It calls from a thread of its own, once a millisecond.
struct StubHd {
  // what it answers
  std::atomic<unsigned> unit{7};  ///< 0xFFFFFFFF: it has none
  std::atomic<unsigned> open_error{0}, enable_error{0}, schedule_error{0}, start_error{0};
  std::atomic<unsigned> frame_error{0};   ///< at the end of every frame
  std::atomic<unsigned> second_error{0};  ///< and on top of it
  std::atomic<int> errors_left{-1};       ///< in so many frames; -1: in all
  std::atomic<bool> endless_errors{false};
  std::atomic<bool> frozen{false};  ///< calls no more
  std::atomic<const char*> model{"Touch"};
  std::atomic<int> inputs{6}, outputs{3}, style{4};
  std::atomic<double> stiffness{0.5}, force{3.4}, continuous_force{0.9};  ///< N/mm, N, N
  std::atomic<double> torque{0.0};                                        ///< 0: asking is an error
  std::atomic<unsigned> calibration{0x5000};
  std::array<std::atomic<double>, 16> transform{};
  std::atomic<int> buttons{0};

  // what it was told
  std::atomic<long> calls{0}, frames{0}, unlike_zero{0};
  std::atomic<int> calibrations{0}, calibration_style{0};
  std::atomic<bool> not_finite{false}, set_outside_frame{false}, torque_to_unit_without{false};
  std::atomic<bool> force_on{false}, clamped{false}, called_on_own_thread{true};

  std::array<double, 6> wrench() {  ///< of the last frame that ended
    const std::lock_guard lock{mutex};
    return sent;
  }
  std::vector<std::string> story() {  ///< how it was started and ended
    const std::lock_guard lock{mutex};
    return words;
  }
  std::string nameOpened() {
    const std::lock_guard lock{mutex};
    return opened;
  }
  void tell(const char* word) {
    const std::lock_guard lock{mutex};
    words.emplace_back(word);
  }

  std::mutex mutex;
  std::array<double, 6> next{}, sent{};
  std::vector<std::string> words;
  std::string opened;
  std::vector<unsigned> errors;
  bool in_frame = false;

  // its scheduler
  unsigned (*call)(void*) = nullptr;
  void* given = nullptr;
  std::atomic<bool> running{false};
  std::thread thread;
};
