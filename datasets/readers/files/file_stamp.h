// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace datasets {

/// Shows whether a file has changed since it was parsed. A file that was written to, or replaced by
/// another of the same name, has a different stamp.
struct FileStamp {
  std::filesystem::path path;
  std::uint64_t device = 0, number = 0;
  std::int64_t size = 0;                         ///< bytes
  std::int64_t modified_ns = 0, changed_ns = 0;  ///< ns since 1970: last change of content; last
                                                 ///< change of content or attributes

  bool operator==(const FileStamp&) const = default;
};

/// If the file does not exist, only the path is set.
FileStamp stampOf(const std::filesystem::path& path);

}  // namespace datasets
