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
  QString conditions = {};  ///< volume, tool and settings of the measurement, in sentences

  TickTimes present = {};   ///< times of the present tool
  std::int64_t ticks = 0;   ///< measured ticks of the present tool
  std::int64_t cut = 0;     ///< ticks that the budget cut
  std::int64_t missed = 0;  ///< ticks longer than the period
  double lag = 0.0;         ///< mean extra distance to the hand, compared with no budget
  double budget = 0.0;

  /// The tool's shape with other numbers of points, fewest first.
  std::vector<TickTimes> tried = {};
  int most = 0;                      ///< most points carried; 0: none
  std::optional<int> too_many = {};  ///< fewest points not carried
  int dense = 0;  ///< number of points at which they are as near to each other as voxels
  int suggested = 0;
  double suggested_spacing = 0.0;
  double voxel = 0.0;

  /// Counts of the live loop during the measurement, in wall-clock time.
  std::uint64_t live_ticks = 0, live_late = 0, live_missed = 0;
};

/// The result in one sentence.
QString headlineOf(const Performance& performance);
/// The conditions of the measurement, and the live loop's counts meanwhile.
QString detailsOf(const Performance& performance);
/// The suggested number of points, and the reason; or empty.
QString suggestionOf(const Performance& performance);

/// 2,126
QString counted(std::int64_t number);
/// Two decimals, as 0.21, or more for small numbers, as 0.004.
QString milliseconds(double seconds);

}  // namespace ui
