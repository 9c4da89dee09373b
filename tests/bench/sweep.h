// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/methods.h"

namespace bench {

/// Ours with a number of points and a budget: does it keep up?
struct SweepRow {
  std::string scene;  ///< "bunny": a cane slides on it; "flat": a plate, all points in contact
  int points = 0;
  int budget_us = 0;
  double build_ms = 0.0;                                           ///< of the Scene
  double mean_us = 0.0, p50_us = 0.0, p99_us = 0.0, max_us = 0.0;  ///< after the lead-in
  double coupling_mm = 0.0;  ///< mean distance to the device over contact ticks
  /// How much of it is the budget's fault: bunny, beyond that of a budget that never binds; flat,
  /// the mean distance along the plane, which nothing holds back.
  double lag_mm = 0.0;
  double penetration_mm = 0.0;  ///< deepest of some poses
  double cut = 0.0;             ///< share of ticks ended by the budget
};

/// All numbers of points with all budgets, in both scenes; `ticks` after the lead-in. The bunny is
/// built once and let go again.
std::vector<SweepRow> sweep(const std::vector<int>& points, const std::vector<int>& budgets_us,
                            int ticks);

}  // namespace bench
