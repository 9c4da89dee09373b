// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "ui/panels/load_plot.h"

namespace ui {

/// The result of a measurement of this machine. Lengths in m, times in s.
struct Performance {
  QString conditions = {};  ///< what was touched, with what and how, in sentences

  TickTimes present = {};   ///< of the tool as it is
  std::int64_t ticks = 0;   ///< that were measured of it
  std::int64_t cut = 0;     ///< of those, ended by the budget
  std::int64_t missed = 0;  ///< longer than the period
  double lag = 0.0;         ///< farther from the hand than without the budget, mean
  double budget = 0.0;

  std::vector<TickTimes> tried = {};  ///< its shape with other numbers of points, fewest first
  int most = 0;                       ///< carried; 0 if none was
  std::optional<int> too_many = {};   ///< the fewest not carried
  int dense = 0;                      ///< points as near to each other as voxels
  int suggested = 0;
  double suggested_spacing = 0.0;
  double voxel = 0.0;

  /// The live loop meanwhile, by the clock on the wall.
  std::uint64_t live_ticks = 0, live_late = 0, live_missed = 0;
};

/// The answer in one sentence.
QString headlineOf(const Performance& performance);
/// How it was measured, and what the live loop did meanwhile.
QString detailsOf(const Performance& performance);
/// How many points to give the tool, and why; or empty.
QString suggestionOf(const Performance& performance);

/// 2,126
QString counted(std::int64_t number);
/// Two decimals, as 0.21, or more for small numbers, as 0.004.
QString milliseconds(double seconds);

}  // namespace ui
