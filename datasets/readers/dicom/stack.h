// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "datasets/readers/files/file_geometry.h"
#include "haptics/core/error.h"
#include "haptics/core/geometry.h"

namespace datasets {

/// Where one slice lies: ImagePositionPatient, ImageOrientationPatient and PixelSpacing.
struct SlicePlane {
  haptics::Vec3 position_mm = haptics::Vec3::Zero();    ///< centre of the first pixel, LPS
  haptics::Vec3 along_row = haptics::Vec3::UnitX();     ///< unit, towards growing columns
  haptics::Vec3 along_column = haptics::Vec3::UnitY();  ///< unit, towards growing rows
  double column_step_mm = 1.0;  ///< between pixels of one row: the second value of PixelSpacing
  double row_step_mm = 1.0;     ///< between rows: the first value of PixelSpacing
  std::int64_t columns = 0;
  std::int64_t rows = 0;
  double thickness_mm = 0.0;  ///< used as the step of a single slice only; 0: not stated
};

/// Parallel slices that do not fill an even box of right angles as they stand, and do once they are
/// resampled onto one.
struct Crooked {
  haptics::Error why;  ///< "gantry-tilt" or "uneven-spacing"; the sentence has angle or gaps
  /// Where in the box's index coordinates the first pixel of the slice at k lies.
  std::vector<haptics::Vec3> places;
  std::int64_t columns = 0, rows = 0;  ///< of a slice; the box may have more
};

/// Slices in the order of the stack, and the box that they fill.
struct Stack {
  std::vector<std::size_t> order;  ///< order[k] is the index of the slice at k
  FileGeometry geometry;           ///< of the box, once straightened
  std::optional<Crooked> crooked = {};
};

/// The stack that slices make, k along the normal (row x column), or why they make none:
///   "bad-header"         an orientation that is no pair of perpendicular unit vectors, or a
///                        spacing or position that is no number
///   "mixed-orientation"  planes more than 0.1 degrees apart
///   "mixed-size"         unequal rows, columns or pixel spacing
///   "duplicate"          two slices at one position
///   "sheared"            positions that do not advance along one line; a tilt beyond 45 degrees
///   "missing-slices"     every odd step is a multiple of the usual one, within 5 %
///   "uneven-spacing"     steps so uneven that resampling would make up most of the slices
/// A stack can be straightened, and is crooked as it stands, with
///   "gantry-tilt"        positions that advance more than 0.1 degrees off the normal
///   "uneven-spacing"     steps off the median by more than 1 % or 0.05 mm, whichever is greater
/// A single slice takes its thickness, or 1 mm, as its step.
haptics::Expected<Stack> stackOf(const std::vector<SlicePlane>& slices);

/// Of slices that stackOf() refuses with "missing-slices": the indices of the longest run between
/// two gaps, along the normal; of several as long the lowest.
std::vector<std::size_t> longestRun(const std::vector<SlicePlane>& slices);

}  // namespace datasets
