// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "app/study/cohort/manifest.h"
#include "app/study/cohort/slice_picture.h"
#include "app/study/report/outcome.h"

namespace cohort {

/// A column of a table, as its dictionary describes it.
struct Column {
  std::string name;
  std::string description;
  std::string unit = {};
};

// The tables of an outcome, by caption. A scan that cannot be read is a row, too.
inline constexpr const char* kTouches = "touches";  ///< what the touch was like; repeats exactly
inline constexpr const char* kCosts = "costs";      ///< time and memory, of the machine
inline constexpr const char* kReplays = "replays";  ///< recordings, with today's algorithm
const std::vector<Column>& touchColumns();
const std::vector<Column>& costColumns();
const std::vector<Column>& replayColumns();

/// What is done with a line of a manifest.
struct Touched {
  study::Outcome outcome;
  std::vector<SlicePicture> pictures;  ///< of the scan, where it was touched; empty: it was not
};

/// Reads the scan of a line and touches it with each tool and hand, or replays its recording. The
/// tables hold no path and no word of the file. A case for each row that was touched: the proxy
/// stays out of the solid, judged by the evaluator at every tick. Ends early where `cancel` is set.
Touched touch(const Line& line, const std::atomic<bool>& cancel);

}  // namespace cohort
