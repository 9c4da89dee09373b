// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// A slice to make a thumbnail of.
struct SlicePixels {
  haptics::ScalarType type = haptics::ScalarType::Int16;
  const void* pixels = nullptr;
  std::int64_t columns = 0, rows = 0;
  double column_step = 1.0, row_step = 1.0;           ///< in one unit, positive
  std::optional<std::array<double, 2>> padding = {};  ///< range of values that are ignored
  bool inverted = false;                              ///< small values are bright
};

/// Square pixels, `longest` of them along the longer side. Grey spans the 2nd to the 98th
/// percentile of the slice.
haptics::Expected<Thumbnail> thumbnailOf(const SlicePixels& slice, int longest);

}  // namespace datasets
