// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// A slice to be shown small.
struct SlicePixels {
  haptics::ScalarType type = haptics::ScalarType::Int16;
  const void* pixels = nullptr;
  std::int64_t columns = 0, rows = 0;
  double column_step = 1.0, row_step = 1.0;           ///< in one unit, positive
  std::optional<std::array<double, 2>> padding = {};  ///< values that count for nothing
  bool inverted = false;                              ///< small values are bright
};

/// In square pixels, `longest` of them along the longer side. Values are grey between the second
/// and the last but second percent of those in the slice.
haptics::Expected<Thumbnail> thumbnailOf(const SlicePixels& slice, int longest);

}  // namespace datasets
