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

/// A function that returns ns: monotonicNs, or the clock of a test.
using MonotonicClock = std::int64_t (*)() noexcept;

}  // namespace haptics
