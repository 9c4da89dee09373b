// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/recording/recording.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace app::exporting {

/// The part of a recording that is exported.
struct ExportOptions {
  /// Time range in s since the recording began, both ends included.
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  /// Hz: only the last step at or before each multiple of 1/rate, without repetition; 0: all steps.
  /// All events in the time range are exported.
  double rate = 0.0;
  bool contacts = true;
  /// The volume of a scene before its first cut; null, and without the function: it is not at hand.
  /// HDF5 says which of its voxels cuts removed.
  std::function<std::shared_ptr<const haptics::Volume>(std::uint32_t scene)> volume = {};
  /// Called with the completed fraction, a few times a second. Returning false ends the export,
  /// reason "cancelled".
  std::function<bool(double)> goes_on = {};
};

/// Result of an export.
struct Exported {
  std::int64_t steps = 0, events = 0;
  std::int64_t bytes = 0;
  std::vector<std::string> files = {};  ///< their paths, as given by `out`
  /// Voxels that cuts removed, of HDF5; none: it says nothing of them.
  std::optional<std::int64_t> removed_voxels = {};
  /// Cuts whose voxels it does not say, since the volume was not at hand.
  std::int64_t cuts_without_voxels = 0;
};

// Each format reads the recording block by block and writes each block at once, so its memory does
// not grow with the number of steps. Files are written under a temporary name and replace an older
// file when they are complete. After a failure no file remains. The files name no person, path or
// date. README.md documents their content.
//
// Reasons of refusals, apart from those of reading the recording: "unwritable"; "empty" (no step
// between `from` and `to`); "cancelled".

using Export = haptics::Expected<Exported>(Recording& recording, const std::filesystem::path& out,
                                           const ExportOptions& options);

/// One table of comma-separated values with a line of names, and beside it a JSON file that
/// explains its columns, which is called as the table with kCsvDictionary as its ending.
Export exportCsv;
/// Tab-separated values in the shape of Motion-BIDS. `out` is the beginning of the files' names:
/// out_motion.tsv, out_channels.tsv and so on.
Export exportMotionBids;
/// One HDF5 file.
Export exportHdf5;
/// One MCAP file of JSON messages.
Export exportMcap;

inline constexpr const char* kCsvDictionary = ".columns.json";

/// The endings of the files that exportMotionBids writes.
inline constexpr const char* kBidsEndings[] = {"_motion.tsv",   "_contacts.tsv",  "_events.tsv",
                                               "_channels.tsv", "_channels.json", "_motion.json",
                                               "_events.json"};

/// A format that a recording is exported to.
struct Format {
  const char* name;    ///< value of `palpate-cli export --format`
  const char* ending;  ///< ending of the file; "": the user gives the beginning of the files' names
  // In the window, translated in the context "app::exporting".
  const char* title;   ///< in the list of formats
  const char* about;   ///< a sentence about it
  const char* filter;  ///< filter text in the file dialog
  Export* write;
  /// If `ending` is empty: the endings of the files' names, the largest file first.
  std::span<const char* const> files = {};
  const char* beside = nullptr;  ///< ending of a second file, in place of `ending`; null: none
};

/// All formats. Command line and window read this table. To add a format, add its row.
inline constexpr Format kFormats[] = {
    {"csv",
     ".csv",
     "CSV",
     "One table with a line of names, and a file that explains its columns.",
     "CSV (*.csv)",
     exportCsv,
     {},
     kCsvDictionary},
    {"motion-bids", "", "Motion-BIDS", "Tables as text, laid out as Motion-BIDS asks.",
     "Motion-BIDS: files that begin with this name (*)", exportMotionBids, kBidsEndings},
    {"hdf5", ".h5", "HDF5", "One file of arrays, for programs that compute.", "HDF5 (*.h5)",
     exportHdf5},
    {"mcap", ".mcap", "MCAP", "One file of messages over time, for viewers of robots' logs.",
     "MCAP (*.mcap)", exportMcap},
};

}  // namespace app::exporting
