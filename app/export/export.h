// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/recording/recording.h"

namespace app::exporting {

/// What of a recording is exported.
struct ExportOptions {
  /// s since the recording began; what happened before or after is left out.
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  /// Hz: of the steps only the last at or before each multiple of 1/rate, and none twice; 0: all.
  /// Events are never thinned out.
  double rate = 0.0;
  bool contacts = true;
  /// Told the fraction that is done, a few times a second; false ends it, reason "cancelled".
  std::function<bool(double)> goes_on = {};
};

/// What an export came to.
struct Exported {
  std::int64_t steps = 0, events = 0;
  std::int64_t bytes = 0;
  std::vector<std::string> files = {};  ///< as `out` names them
};

// Each reads the recording block by block and writes as it reads: what it takes in memory does not
// grow with the steps. Files are written under another name, replace what was there once they are
// whole, and are gone if they cannot become so. Nothing in them names a person, a path or a date.
// README.md tells what is in each.
//
// Refusals beside those of the recording: "unwritable"; "empty", no step between from and to;
// "cancelled".

/// How the names of what exportCsv writes end, after the prefix.
inline constexpr const char* kCsvEndings[] = {"_motion.tsv",   "_contacts.tsv",  "_events.tsv",
                                              "_channels.tsv", "_channels.json", "_motion.json",
                                              "_events.json"};

/// Tab-separated values in the shape of Motion-BIDS. `prefix` begins the names of the files:
/// prefix_motion.tsv, prefix_channels.tsv and so on.
haptics::Expected<Exported> exportCsv(haptics::Recording& recording,
                                      const std::filesystem::path& prefix,
                                      const ExportOptions& options);
/// One HDF5 file.
haptics::Expected<Exported> exportHdf5(haptics::Recording& recording,
                                       const std::filesystem::path& out,
                                       const ExportOptions& options);
/// One MCAP file of JSON messages.
haptics::Expected<Exported> exportMcap(haptics::Recording& recording,
                                       const std::filesystem::path& out,
                                       const ExportOptions& options);

}  // namespace app::exporting
