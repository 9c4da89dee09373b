// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "haptics/core/error.h"

namespace datasets {

/// Result of a walk along a DICOM file's elements before vtk-dicom parses it. vtk-dicom trusts
/// every length; deep nesting overflows its stack and many elements take too long.
struct DicomStructure {
  std::string syntax;  ///< TransferSyntaxUID; empty if it is not stated
  /// Why the walk stopped: a value exceeds the file ("truncated"); an item has too many elements,
  /// sequences are nested too deep, or an element is there twice with two values, of which one
  /// might be taken for the other ("bad-header"); the pixels are floating-point numbers
  /// ("unsupported-type").
  std::optional<haptics::Error> fault;
  /// With a fault: position of the outermost element that contains it.
  std::int64_t sound_bytes = 0;
};

/// Walks from the first element to the last that can be found. In a deflated file it reads only the
/// group before the data set. Messages call the file `named`.
DicomStructure structureOf(const std::filesystem::path& path, const std::filesystem::path& named);

}  // namespace datasets
