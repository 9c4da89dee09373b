// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/study/comparison/methods.h"

namespace comparison {

/// Ours with a number of points and a budget: does it keep up?
struct SweepRow {
  std::string scene;  ///< "bunny": a cane slides on it; "flat": a plate, all points in contact
  int points = 0;
  int budget_us = 0;      ///< 0: as much work as a tick has, counted
  double build_ms = 0.0;  ///< of the Scene; the field is shared after the first
  double mean_us = 0.0, p50_us = 0.0, p99_us = 0.0, max_us = 0.0;  ///< after the lead-in
  double coupling_mm = 0.0;  ///< mean distance to the device over contact ticks
  /// How much of it is the budget's fault: bunny, beyond that of a budget that never binds; flat,
  /// the mean distance along the plane, which nothing holds back.
  double lag_mm = 0.0;
  double penetration_mm = 0.0;  ///< deepest of some poses
  double cut = 0.0;             ///< share of ticks ended by the budget
};

struct SweepPlan {
  std::vector<int> points{1'000, 10'000, 100'000, 1'000'000};
  std::vector<int> budgets_us{100, 200, 500};  ///< of CPU time; 0: haptics::kTickWork, counted
  int ticks = 1000;                            ///< after the lead-in
};

/// All numbers of points with all budgets: with the plate on `plane()`, else with the case's own
/// tool, which slides.
std::vector<SweepRow> sweep(const Touched& scene, const SweepPlan& plan);
/// The half-space of the phantoms.
Touched plane();

}  // namespace comparison
