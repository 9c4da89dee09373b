// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/report/outcome.h"

namespace study {

/// A method with one setting: what it cost, and how wrong it was, measured together.
struct WorkPoint {
  std::string method, setting;
  std::vector<double> cost;   ///< one for each tick, call, …
  std::vector<double> error;  ///< one for each pose, place, …; may be of another number
  double samples = 0.0;       ///< look-ups of the field for each tick; of ours units of work
};

/// Error against run time.
struct WorkPrecision {
  std::string title, description;
  std::string cost_label, error_label;  ///< with units
  std::vector<WorkPoint> points = {};
};

/// A diagram of mean cost and median error, with a bar to the error's 99 %: one line for each
/// method along its Pareto front, the points that another of its own outdoes beside it. And a
/// table with the quantiles of both.
void addTo(Outcome& outcome, const WorkPrecision& work);

/// Which of some points no other is at least as good as in both, and better in one.
std::vector<bool> paretoFront(const std::vector<std::pair<double, double>>& points);

}  // namespace study
