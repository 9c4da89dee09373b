// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

#include "haptics/core/error.h"
#include "haptics/simulation/closed_loop.h"

namespace app::cli {

/// Writes a trace: one header line and 22 columns a tick, each number printed so that reading it
/// gives the same double. Written beside the target and renamed when whole.
class TraceWriter {
 public:
  static haptics::Expected<TraceWriter> open(const std::string& path);
  TraceWriter(TraceWriter&& other) noexcept;
  TraceWriter& operator=(TraceWriter&&) = delete;
  ~TraceWriter();  ///< removes what was not finished

  void write(const haptics::TraceRow& row);
  haptics::Expected<void> finish();

 private:
  TraceWriter(std::string path, std::FILE* file) : path_{std::move(path)}, file_{file} {}
  std::string path_;
  std::FILE* file_;
};

/// The first eight columns of a trace as a hand.
haptics::Expected<haptics::Hand> readHand(const std::string& path);

}  // namespace app::cli
