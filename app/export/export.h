// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <span>
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

using Export = haptics::Expected<Exported>(haptics::Recording& recording,
                                           const std::filesystem::path& out,
                                           const ExportOptions& options);

/// Tab-separated values in the shape of Motion-BIDS. `out` begins the names of the files:
/// out_motion.tsv, out_channels.tsv and so on.
Export exportCsv;
/// One HDF5 file.
Export exportHdf5;
/// One MCAP file of JSON messages.
Export exportMcap;

/// How the names of what exportCsv writes end.
inline constexpr const char* kCsvEndings[] = {"_motion.tsv",   "_contacts.tsv",  "_events.tsv",
                                              "_channels.tsv", "_channels.json", "_motion.json",
                                              "_events.json"};

/// A format that a recording is exported to.
struct Format {
  const char* name;    ///< of `palpate-cli export --format`
  const char* ending;  ///< of the file; "": the files' names begin with what the user gives
  // In the window, translated in the context "app::exporting".
  const char* title;   ///< in the list of formats
  const char* about;   ///< a sentence about it
  const char* filter;  ///< what the file dialog says is chosen
  Export* write;
  /// Where `ending` is empty: how the files' names end, the largest file first.
  std::span<const char* const> files = {};
};

/// All of them. Command line and window read this table; to add a format, add its row.
inline constexpr Format kFormats[] = {
    {"csv", "", "CSV (Motion-BIDS)", "Tables as text, laid out as Motion-BIDS asks.",
     "Motion-BIDS: the beginning of the names", exportCsv, kCsvEndings},
    {"hdf5", ".h5", "HDF5", "One file of arrays, for programs that compute.", "HDF5 (*.h5)",
     exportHdf5},
    {"mcap", ".mcap", "MCAP", "One file of messages over time, for viewers of robots' logs.",
     "MCAP (*.mcap)", exportMcap},
};

}  // namespace app::exporting
