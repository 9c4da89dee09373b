// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/comparison/methods.h"
#include "app/study/report/outcome.h"

namespace study::accuracy {

/// A method with one setting: what it cost, and how wrong it was, measured together.
struct WorkPoint {
  std::string method, setting;
  std::vector<double> cost;   ///< one for each tick, call, …, of all runs
  std::vector<double> error;  ///< one for each pose, place, …; may be of another number
  /// What was done for that cost, on the mean; none where nothing is counted.
  std::optional<comparison::MeanCounts> counts = {};
  std::vector<double> runs = {};  ///< mean cost of each run, where the same was done several times
  /// Mean error of each hand, of all its motions; none where there are no hands, or one.
  std::vector<double> hands = {};
};

/// Error against run time.
struct WorkPrecision {
  std::string title, description;
  std::string cost_label, error_label;  ///< with units
  std::vector<WorkPoint> points = {};
};

/// A diagram of mean cost (of the median run) and median error, with a bar to the error's 99 %; of
/// hands the median of their mean errors, with a bar from the least to the greatest. One
/// line for each method along its Pareto front, the points that another of its own outdoes beside
/// it. And a table with the quantiles of both, the spread between runs, and what was counted.
void addTo(Outcome& outcome, const WorkPrecision& work);

/// Root mean square; not a number for none.
double rms(const std::vector<double>& values);

/// Which of some points no other is at least as good as in both, and better in one.
std::vector<bool> paretoFront(const std::vector<std::pair<double, double>>& points);

}  // namespace study::accuracy
