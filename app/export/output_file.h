// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "haptics/core/error.h"

namespace app::exporting {

/// A file that is written under another name. Whoever fills it does so at part(); unless finish()
/// gives it its own name, it goes with the object.
class Output {
 public:
  /// Makes it, empty. Refused, reason "unwritable", also where something stands that is no regular
  /// file, such as a folder or a device. Links are followed.
  static haptics::Expected<Output> at(const std::filesystem::path& path);
  Output(Output&& other) noexcept;
  Output& operator=(Output&&) = delete;
  ~Output();

  const std::filesystem::path& part() const { return part_; }
  /// Gives it its name; what had that name is replaced. Returns its bytes.
  haptics::Expected<std::int64_t> finish();
  /// That it cannot be written, and why [an errno].
  haptics::Error unwritable(int why) const;

 private:
  Output(std::filesystem::path named, std::filesystem::path target);
  std::filesystem::path named_, target_, part_;
  bool pending_ = false;  ///< there is a part, and it is ours
};

/// The same, filled from front to back.
class OutputFile {
 public:
  static haptics::Expected<OutputFile> open(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// False once something could not be written; close() tells why.
  bool write(std::string_view bytes);
  std::uint64_t size() const { return size_; }
  haptics::Expected<void> close();
  /// After close().
  haptics::Expected<std::int64_t> finish() { return output_.finish(); }

 private:
  OutputFile(Output output, std::FILE* file) : output_{std::move(output)}, file_{file} {}
  Output output_;
  std::FILE* file_;
  std::uint64_t size_ = 0;
  int failure_ = 0;
};

}  // namespace app::exporting
