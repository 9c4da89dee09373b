// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/core/error.h"

namespace haptics {

/// A file that appears whole or not at all. It is written at part(), a name beside its own, and
/// finish() renames it. Without finish() the destructor deletes it. Not for the servo thread: it
/// waits for the disk.
class Output {
 public:
  /// Makes an empty file. Refused with the reason "unwritable", also if `path` is not a regular
  /// file, for example a folder or a device, or leads to one that keepInput() was told of. Links
  /// are followed.
  static Expected<Output> at(const std::filesystem::path& path);
  Output(Output&& other) noexcept;
  Output& operator=(Output&&) = delete;
  ~Output();

  const std::filesystem::path& part() const { return part_; }
  /// Syncs the file to the disk and renames it; an older file of that name is replaced. Returns the
  /// size in bytes.
  Expected<std::int64_t> finish();
  /// The error for a file that cannot be written; `why` is an errno.
  Error unwritable(int why) const;

 private:
  Output(std::filesystem::path named, std::filesystem::path target);
  std::filesystem::path named_, target_, part_;
  bool pending_ = false;  ///< part_ exists and belongs to this object
};

/// The same, written from front to back. A pipe or a device such as /dev/stdout is written
/// directly; what was written to it stays.
class OutputFile {
 public:
  static Expected<OutputFile> open(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// False after a failed write; close() returns the reason.
  bool write(std::string_view bytes);
  std::uint64_t size() const { return size_; }
  Expected<void> close();
  /// Call after close(). Returns the size in bytes.
  Expected<std::int64_t> finish();

 private:
  OutputFile(std::filesystem::path named, std::optional<Output> output, std::FILE* file)
      : named_{std::move(named)}, output_{std::move(output)}, file_{file} {}
  std::filesystem::path named_;
  std::optional<Output> output_;  ///< empty: written directly
  std::FILE* file_;
  std::uint64_t size_ = 0;
  int failure_ = 0;
};

/// Writes a text as a file, whole or not at all.
Expected<void> writeFile(const std::filesystem::path& path, std::string_view text);

/// From now on no output of this process replaces the file, whatever name leads to it: what was
/// read may be all that the user has of it. Any thread.
void keepInput(const std::filesystem::path& path);

/// Deletes all unfinished files, for a program that is about to end. After this call, any thread
/// that begins, finishes or discards a file blocks. Any thread.
void discardOutputs();

}  // namespace haptics
