// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace datasets {

/// Tells whether a file is still the one that was parsed: a file that was written to, or replaced
/// by another of the same name, has another stamp.
struct FileStamp {
  std::filesystem::path path;
  std::uint64_t device = 0, number = 0;
  std::int64_t size = 0;                         ///< bytes
  std::int64_t modified_ns = 0, changed_ns = 0;  ///< since 1970: content, and content or owner

  bool operator==(const FileStamp&) const = default;
};

/// All zero but the path where there is no such file.
FileStamp stampOf(const std::filesystem::path& path);

}  // namespace datasets
