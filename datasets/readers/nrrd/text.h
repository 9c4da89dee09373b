// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/readers/files/header_words.h"
#include "haptics/core/error.h"

namespace datasets {

inline constexpr std::size_t kMostDataFiles = 100'000;  ///< that one header may name

/// The text before the voxels, taken apart and not yet understood.
struct NrrdText {
  std::map<std::string, std::string> fields;  ///< by lower-case name
  std::map<std::string, std::string> keys;    ///< "key:=value", as written; of two the first
  std::vector<std::string> listed_files;      ///< the names after "data file: LIST"
  std::string lines;       ///< all but those that name data files or say what to skip in them
  std::string skips;       ///< those that say what to skip
  std::int64_t bytes = 0;  ///< up to the voxels; 0 where the file ends with its header

  /// The value of a field under either of its names; null where it is not stated.
  const std::string* find(const char* name, const char* other = nullptr) const;
};

/// Whether data files are named one by one, in the lines after this value of "data file".
bool isList(std::string_view data_file);

/// Reads at most 1 MB of header. Refuses ("bad-header") another beginning than NRRD0001 to
/// NRRD0005 and a field stated twice.
haptics::Expected<NrrdText> readNrrdText(const std::filesystem::path& path);

}  // namespace datasets
