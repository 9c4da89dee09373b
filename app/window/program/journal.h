// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/view_file/view_file.h"
#include "haptics/core/error.h"

namespace app {

/// What the user did with scans, kept while the program runs and offered after it ended without a
/// question: for each scan a file of a view (view_file/), named by the keyed hash of the scan.
///
/// Each process has a folder of its own in the journal's, which it holds by a lock, so several
/// processes never write the same file, and a folder whose lock is free is of a process that has
/// ended. Folders and files are for the user's eyes alone. Any thread.
class Journal {
 public:
  static constexpr std::size_t kMostScans = 8;

  /// Nothing is made before the first write(). `folder` empty: nothing is kept.
  explicit Journal(std::filesystem::path folder);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool isOn() const { return !folder_.empty(); }
  /// Keeps the work on the scan of `view.hash`, which must be there, whole or not at all, in place
  /// of what this process kept of that scan.
  haptics::Expected<void> write(const ViewFile& view);
  /// Removes what this process keeps of a scan.
  void remove(const VolumeHash& hash);
  /// Removes all that this process keeps: its user saved it, or does not want it.
  void clear();
  /// Removes everything, of other processes too.
  void forget();

  /// Work that a process left which has ended.
  struct Left {
    VolumeHash hash{};
    std::filesystem::path path;
  };
  /// All of it, newest first. Of each scan only the newest.
  std::vector<Left> left() const;
  /// Removes what ended processes left that is no work, and all work but the newest kMostScans.
  void sweep();

 private:
  haptics::Expected<void> hold();

  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  std::filesystem::path own_;  ///< empty: none yet
  int lock_ = -1;
};

/// The journal beside the user's key, in the user's own folder.
std::filesystem::path ownJournal();

}  // namespace app
