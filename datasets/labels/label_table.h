// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "haptics/core/error.h"

namespace datasets {

/// What a table says of one number of a label map.
struct NamedLabel {
  std::string name;  ///< as Structure::name
  std::array<double, 3> colour{};
};

/// Reads a table that names the numbers of a label map: 3D Slicer's .ctbl, the label descriptions
/// of ITK-SNAP, or FreeSurfer's look-up table. The lines tell which it is. Refuses by name a line
/// that is none, a number that stands there twice ("bad-header"), and more than 1 MiB
/// ("too-large").
haptics::Expected<std::map<std::int64_t, NamedLabel>> readLabelTable(
    const std::filesystem::path& path);

}  // namespace datasets
