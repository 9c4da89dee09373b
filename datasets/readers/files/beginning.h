// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace datasets {

/// The first bytes of a file, read once. All formats are told apart by them and by the name.
struct Beginning {
  Beginning() = default;
  explicit Beginning(const std::filesystem::path& file);

  std::filesystem::path path;
  bool is_open = false;        ///< false: there is no such file, or it may not be read
  std::int64_t file_size = 0;  ///< bytes
  std::string bytes;           ///< the first 512, or all; none where the file cannot be read
};

}  // namespace datasets
