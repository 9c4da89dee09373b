// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <ctime>

#include "haptics/core/realtime.h"

namespace haptics {

/// Nanoseconds of the monotonic clock. Any thread.
inline std::int64_t monotonicNs() HAPTICS_RT {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

/// A time of it, as the calls of the system take it.
inline timespec timeOf(std::int64_t ns) noexcept {
  return {static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
}

/// Waits until a time of it; no signal ends that early.
inline void sleepUntil(std::int64_t ns) noexcept {
  const timespec until = timeOf(ns);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
  }
}

/// A function that returns ns: monotonicNs, or the clock of a test.
using MonotonicClock = std::int64_t (*)() noexcept;

}  // namespace haptics
