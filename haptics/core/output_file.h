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

/// A file that appears whole or not at all: it is written under another name beside its own.
/// Whoever fills it does so at part(); unless finish() gives it its own name, it goes with the
/// object. Not for the servo thread: it waits for the disk.
class Output {
 public:
  /// Makes it, empty. Refused, reason "unwritable", also where something stands that is no regular
  /// file, such as a folder or a device. Links are followed.
  static Expected<Output> at(const std::filesystem::path& path);
  Output(Output&& other) noexcept;
  Output& operator=(Output&&) = delete;
  ~Output();

  const std::filesystem::path& part() const { return part_; }
  /// Sees that it is on the disk and gives it its name; what had that name is replaced. Returns its
  /// bytes.
  Expected<std::int64_t> finish();
  /// That it cannot be written, and why [an errno].
  Error unwritable(int why) const;

 private:
  Output(std::filesystem::path named, std::filesystem::path target);
  std::filesystem::path named_, target_, part_;
  bool pending_ = false;  ///< there is a part, and it is ours
};

/// The same, filled from front to back. What can only be written as it is, such as a pipe or
/// /dev/stdout, is: then what was written stays, whatever happens.
class OutputFile {
 public:
  static Expected<OutputFile> open(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// False once something could not be written; close() tells why.
  bool write(std::string_view bytes);
  std::uint64_t size() const { return size_; }
  Expected<void> close();
  /// After close(). Returns its bytes.
  Expected<std::int64_t> finish();

 private:
  OutputFile(std::filesystem::path named, std::optional<Output> output, std::FILE* file)
      : named_{std::move(named)}, output_{std::move(output)}, file_{file} {}
  std::filesystem::path named_;
  std::optional<Output> output_;  ///< none: written as it is
  std::FILE* file_;
  std::uint64_t size_ = 0;
  int failure_ = 0;
};

/// A text as a file, whole or not at all.
Expected<void> writeFile(const std::filesystem::path& path, std::string_view text);

/// Removes all that is not finished, for a program that ends here and now: whoever would begin,
/// finish or give up a file after this waits for the end. Any thread.
void discardOutputs();

}  // namespace haptics
