// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// Removes what processes that died have left of their archives. Programs call it when they start.
void sweepTemporaryFolders();

/// A folder of this user alone among the temporary ones, which goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();  ///< throws std::filesystem::filesystem_error where there is no room
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return content_; }

 private:
  std::filesystem::path path_, content_;
  int lock_ = -1;  ///< tells others that it is in use
};

/// Whether a file begins as a ZIP, 7-Zip, tar (plain, or with gzip, bzip2, xz or zstd) or CD image.
bool looksLikeArchive(const std::filesystem::path& path);

/// The regular files of an archive, in their folders; links, devices and archives inside it stay
/// unopened. Refuses names that lead out of it ("outside-folder"), more than 200,000 files, folders
/// more than 32 deep, more than 32 GiB or than the disk has free, and more than a hundredfold of
/// the archive where that is over 1 GiB ("too-large"); what is cut off ("truncated"), and what is
/// locked by a password ("unreadable").
haptics::Expected<std::shared_ptr<const TemporaryFolder>> unpacked(
    const std::filesystem::path& archive, const ReadProgress& progress);

}  // namespace datasets
