// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <optional>

#include "datasets/readers/scan.h"
#include "datasets/readers/volume_header.h"
#include "haptics/core/volume.h"

namespace app {

/// What a thread makes ahead, after waiting for it; only once. `fraction` is how far it is. None if
/// nothing came of it, or on Cancel.
template <class T>
std::optional<T> takeWhenMade(std::future<std::optional<T>>& made,
                              const std::atomic<double>& fraction,
                              const datasets::ReadProgress& progress) {
  constexpr std::chrono::milliseconds kLook{20};  // between looks at Cancel
  if (!made.valid()) return {};
  while (made.wait_for(kLook) != std::future_status::ready) {
    if (progress.isCancelled()) return {};
    progress.advanced(fraction);
  }
  return made.get();
}

/// Reads the volume file of the command line while the window is loaded and begins, on a thread of
/// its own. It reads a file of one volume whose voxels lie plain or deflated. Anything else is left
/// to the loader, which also says what is wrong.
class ReadAhead {
 public:
  /// The header is parsed here, since teem holds its state in one place, and the voxels are read on
  /// the thread. Returns when all threads of the reading have begun, after 0.1 s at most.
  explicit ReadAhead(std::filesystem::path file);
  /// Cancels and waits.
  ~ReadAhead();

  const std::filesystem::path& file() const { return file_; }

  /// The volume, after waiting for it; only once. None if it was not read, or on Cancel. Any
  /// thread.
  std::optional<haptics::Volume> take(const datasets::ReadProgress& progress);

 private:
  void advanced(double fraction);
  std::optional<haptics::Volume> read(const datasets::VolumeHeader& header);

  std::filesystem::path file_;
  std::atomic<bool> cancel_{false};
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> is_under_way_{false};
  std::promise<void> under_way_;
  std::future<std::optional<haptics::Volume>> volume_;
};

}  // namespace app
