// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "haptics/core/error.h"

namespace app::fetch {

/// A folder of mode 0700 for the images of one transfer.
///
/// A temporary one lies in the folder for temporary files and is held by a lock; it goes with this
/// object, and the sweep of a later start takes it if this process was killed. One that the user
/// named stays, unless it is discarded.
class Folder {
 public:
  static haptics::Expected<Folder> temporary();
  /// Made new, or taken if it is there, empty and the user's own.
  static haptics::Expected<Folder> at(const std::filesystem::path& path);
  Folder(Folder&& other) noexcept;
  Folder& operator=(Folder&&) = delete;
  ~Folder();

  const std::filesystem::path& path() const { return path_; }
  bool isTemporary() const { return lock_ >= 0; }
  /// Removes what is in it, and the folder itself.
  void discard();

 private:
  Folder(std::filesystem::path path, int lock) : path_{std::move(path)}, lock_{lock} {}
  std::filesystem::path path_;
  int lock_ = -1;
};

/// Removes the temporary folders of processes that have ended without doing so.
void sweepFolders();

}  // namespace app::fetch
