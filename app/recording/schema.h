// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace app {

inline constexpr int kApplicationId = 0x50414c50;  ///< "PALP"
// user_version. Each lets those read a recording who would read it rightly.
inline constexpr int kFormatOfScans = 2;
inline constexpr int kFormatOfEdits = 3;     ///< from the first scene with an edited volume on
inline constexpr int kFormatOfRounding = 4;  ///< Layout::Rounded; volumes edited or not
inline constexpr int kHighestFormat = kFormatOfRounding;

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

}  // namespace app
