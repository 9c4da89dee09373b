// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "haptics/core/realtime.h"
#include "haptics/devices/ratings.h"

namespace haptics {

/// How often in a second the servo loop reads the device, computes a whole tick and writes the
/// device, and what follows from it.
struct ServoRate {
  int hz = 1000;

  constexpr double period() const HAPTICS_RT { return 1.0 / hz; }  ///< s
  constexpr std::int64_t period_ns() const HAPTICS_RT { return 1'000'000'000 / hz; }
  /// ns of CPU time that the proxy may take in a tick: 200 us, and no more than half the period.
  constexpr std::int64_t budget_ns() const HAPTICS_RT {
    constexpr std::int64_t kMost = 200'000;
    return std::min(kMost, period_ns() / 2);
  }
  /// The same, counted: units of work of a Budget, 10 ns each.
  constexpr std::int64_t budget_work() const HAPTICS_RT { return budget_ns() / 10; }
  /// A tick that begins later than this after it was due is late [ns].
  constexpr std::int64_t late_ns() const HAPTICS_RT { return period_ns() / 10; }

  friend constexpr bool operator==(ServoRate, ServoRate) = default;
};

/// The rates that Palpate runs at and is tested at.
inline constexpr std::array kServoRates{ServoRate{1000}, ServoRate{2000}, ServoRate{4000}};

/// The highest of them that the device's link carries.
constexpr ServoRate rateOf(const DeviceRating& rating) {
  ServoRate highest = kServoRates.front();
  for (const ServoRate rate : kServoRates)
    if (rate.hz <= rating.rate) highest = rate;
  return highest;
}

/// Whether it is one of them.
constexpr bool isServoRate(int hz) {
  return std::any_of(kServoRates.begin(), kServoRates.end(),
                     [hz](ServoRate rate) { return rate.hz == hz; });
}

}  // namespace haptics
