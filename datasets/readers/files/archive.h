// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// Removes archive folders of processes that have ended. Programs call it when they start.
void sweepTemporaryFolders();

/// A temporary folder that only this user can read; removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();  ///< throws std::filesystem::filesystem_error if there is no room
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return content_; }

 private:
  std::filesystem::path path_, content_;
  int lock_ = -1;  ///< shows other processes that it is in use
};

/// Whether a file is a ZIP, 7-Zip, tar (plain, or with gzip, bzip2, xz or zstd) or CD image: by its
/// content, or, since a damaged one is refused as such, by its name.
bool looksLikeArchive(const std::filesystem::path& path);

/// Of a file that does not look like one: what else it is packed as, and what to try. Empty if it
/// is not packed in a way that is known here.
std::optional<haptics::Message> whyNoArchive(const std::filesystem::path& path);

/// The regular files of an archive, in their folders; links, devices and archives inside the
/// archive are not opened. Refuses names that lead outside the folder ("outside-folder"), more than
/// 200,000 files, folders more than 32 deep, more than 32 GiB, more than nine tenths of the free
/// disk, and more than a hundredfold of the archive's size where that is over 1 GiB ("too-large").
/// Refuses archives that are cut off ("truncated") or locked by a password ("unreadable").
haptics::Expected<std::shared_ptr<const TemporaryFolder>> unpacked(
    const std::filesystem::path& archive, const ReadProgress& progress);

}  // namespace datasets
