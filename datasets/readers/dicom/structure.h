// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "haptics/core/error.h"

namespace datasets {

/// What a walk along the elements of a DICOM file finds before vtk-dicom may parse it, which takes
/// a length at its word, and whose stack and time bear neither sequences in sequences nor items
/// without end.
struct DicomStructure {
  std::string syntax;  ///< TransferSyntaxUID; empty where it is not stated
  /// A value that is longer than the file ("truncated"), or more sequences in each other or
  /// elements in an item than any scan has ("bad-header").
  std::optional<haptics::Error> fault;
  std::int64_t sound_bytes = 0;  ///< with a fault: where the outermost element that has it begins
};

/// Reads from the first element to the last, as far as they can be told apart. Of a deflated file
/// it reads the file's own group only. Sentences call the file `named`.
DicomStructure structureOf(const std::filesystem::path& path, const std::filesystem::path& named);

}  // namespace datasets
