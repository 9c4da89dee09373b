// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <optional>

#include "datasets/readers/volume_reader.h"
#include "haptics/core/volume.h"

namespace app {

/// Reads the volume file of the command line while Qt and the window begin, on a thread of its own.
/// It reads a file of one sound volume, as it is stored. Anything else is left to the loader, which
/// also says what is wrong.
class ReadAhead {
 public:
  explicit ReadAhead(std::filesystem::path file);
  /// Cancels and waits.
  ~ReadAhead();

  /// The volume, after waiting for it; only once. None if it was not read, or on Cancel. Any
  /// thread.
  std::optional<haptics::Volume> take(const datasets::ReadProgress& progress);

 private:
  std::atomic<bool> cancel_{false};
  std::atomic<double> fraction_{0.0};
  std::future<std::optional<haptics::Volume>> volume_;
};

}  // namespace app
