// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"

namespace datasets {

/// A slice to make a thumbnail of.
struct SlicePixels {
  haptics::ScalarType type = haptics::ScalarType::Int16;
  const void* pixels = nullptr;
  std::int64_t columns = 0, rows = 0;
  double column_step = 1.0, row_step = 1.0;  ///< in one unit, positive
  /// The unit directions in W in which columns, rows and slices grow; none: not stated.
  std::optional<haptics::Mat3> direction = {};
  std::optional<std::array<double, 2>> padding = {};  ///< range of values that are ignored
  bool inverted = false;                              ///< small values are bright
};

/// Square pixels, `longest` of them along the longer side. Grey spans the 2nd to the 98th
/// percentile of the slice. Refuses a slice without a size ("bad-header").
haptics::Expected<Thumbnail> thumbnailOf(const SlicePixels& slice, int longest);

/// The number, from 0, of the slice in the middle; of the two of an even count the one nearer to S,
/// P or L, whichever way the file counts. `direction` as in SlicePixels.
std::int64_t middleOf(std::int64_t count, const std::optional<haptics::Mat3>& direction);

}  // namespace datasets
