// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

#include "haptics/core/error.h"
#include "haptics/process/output_file.h"
#include "haptics/simulation/closed_loop.h"

namespace app::cli {

/// Writes a trace: one header line, then 22 columns per tick, and for each structure that is
/// watched two more, the distance of the tip and of the nearest point, called by its number from 1.
/// Numbers have the shortest digits that round-trip to the same double. The file is written
/// completely or not at all.
class TraceWriter {
 public:
  static haptics::Expected<TraceWriter> open(const std::string& path,
                                             const haptics::Watch* watch = nullptr);

  void write(const haptics::TraceRow& row);
  haptics::Expected<void> finish();

 private:
  explicit TraceWriter(haptics::OutputFile file) : file_{std::move(file)} {}
  haptics::OutputFile file_;
};

/// A hand from a file, which begins at time 0, and its last time [s].
struct RecordedHand {
  haptics::Hand hand;
  double seconds = 0.0;
};
/// Reads a hand from the first eight columns of a trace, whose names are checked.
haptics::Expected<RecordedHand> readHand(const std::string& path);

}  // namespace app::cli
