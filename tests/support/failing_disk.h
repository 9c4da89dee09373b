// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace support {

/// A disk in memory, as a file system of SQLite's, that fails as disks do. One at a time.
class FailingDisk {
 public:
  FailingDisk();
  ~FailingDisk();
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;

  const char* name() const { return "failing-disk"; }

  /// Writes and syncs that are let through from now on; then the power goes: all that follows
  /// fails, and the moment is what save() gives.
  void cutAfter(std::int64_t operations);
  bool isCut() const;
  /// Bytes that all files together may have; beyond that the disk is full.
  void setRoom(std::int64_t bytes);

  /// What is found in a folder after the power is back: what was synced, and of what was written
  /// since then some pages, torn in the middle, by chance of this seed.
  void saveAfterPowerCut(const std::filesystem::path& folder, std::uint32_t seed) const;
  /// What is found where only the process went: all that was written.
  void save(const std::filesystem::path& folder) const;
};

}  // namespace support
