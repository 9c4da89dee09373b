// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace app {

inline constexpr int kApplicationId = 0x50414c50;  ///< "PALP"
// user_version. Each lets those read a recording who would read it rightly.
inline constexpr int kFormatOfScans = 2;
inline constexpr int kFormatOfEdits = 3;     ///< from the first scene with an edited volume on
inline constexpr int kFormatOfRounding = 4;  ///< Layout::Rounded; volumes edited or not
// The same two layouts, from the first step on in which structures were watched.
inline constexpr int kFormatOfStructures = 5;
inline constexpr int kFormatOfRoundedStructures = 6;
// The same two, from the first step on in which a burr cuts.
inline constexpr int kFormatOfCuts = 7;
inline constexpr int kFormatOfRoundedCuts = 8;
inline constexpr int kHighestFormat = kFormatOfRoundedCuts;

/// Whether a recording of this format has kNearnessTable.
constexpr bool hasStructures(std::int64_t format) { return format >= kFormatOfStructures; }
/// Whether it has kCutTable, too.
constexpr bool hasCuts(std::int64_t format) { return format >= kFormatOfCuts; }
/// Whether its numbers are stored as Layout::Rounded.
constexpr bool isRounded(std::int64_t format) {
  return format == kFormatOfRounding || format == kFormatOfRoundedStructures ||
         format == kFormatOfRoundedCuts;
}

/// The tables of a recording; README.md of this folder documents them.
inline constexpr const char* kSchema = R"(
CREATE TABLE meta (key TEXT PRIMARY KEY, value ANY NOT NULL) STRICT, WITHOUT ROWID;
CREATE TABLE step (first INTEGER PRIMARY KEY, count INTEGER NOT NULL, from_ns INTEGER NOT NULL,
  to_ns INTEGER NOT NULL, data BLOB NOT NULL) STRICT;
CREATE INDEX step_times ON step (first, count, from_ns, to_ns);
CREATE TABLE contact (first INTEGER PRIMARY KEY, count INTEGER NOT NULL, data BLOB NOT NULL) STRICT;
CREATE TABLE event (id INTEGER PRIMARY KEY, sequence INTEGER NOT NULL, time_ns INTEGER NOT NULL,
  kind TEXT NOT NULL, value REAL, text TEXT) STRICT;
CREATE TABLE scene (id INTEGER PRIMARY KEY, tool TEXT NOT NULL, settings TEXT NOT NULL,
  volume TEXT NOT NULL, volume_hash BLOB, points BLOB NOT NULL, vertices BLOB NOT NULL,
  triangles BLOB NOT NULL) STRICT;
)";
/// Distances to structures, of the steps of a block. `structures`: their numbers, from 1, as JSON.
inline constexpr const char* kNearnessTable = R"(
CREATE TABLE nearness (first INTEGER PRIMARY KEY, structures TEXT NOT NULL, data BLOB NOT NULL)
  STRICT;
)";
/// The cuts that began in the steps of a block.
inline constexpr const char* kCutTable = R"(
CREATE TABLE cut (first INTEGER PRIMARY KEY, count INTEGER NOT NULL, data BLOB NOT NULL) STRICT;
)";
/// The tables of a recording of this format.
inline std::string tablesOf(std::int64_t format) {
  std::string tables = kSchema;
  if (hasStructures(format)) tables += kNearnessTable;
  if (hasCuts(format)) tables += kCutTable;
  return tables;
}

}  // namespace app
