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

/// Parallel slices that fill an even, right-angled box only after resampling.
struct Crooked {
  haptics::Error why;  ///< "gantry-tilt" or "uneven-spacing"; the message has the angle or the gaps
  bool uneven = false;     ///< the steps differ, whether tilted or not
  bool two_steps = false;  ///< two regular ones, one behind the other
  /// places[k]: first pixel of the slice at k, in the box's index coordinates.
  std::vector<haptics::Vec3> places;
  std::int64_t columns = 0, rows = 0;  ///< of a slice; the box may have more
};

/// Slices in the order of the stack, and the box that they fill.
struct Stack {
  std::vector<std::size_t> order;  ///< order[k] is the index of the slice at k
  FileGeometry geometry;           ///< of the box, after resampling
  std::optional<Crooked> crooked = {};
};

/// Steps below this are none, mm: slices that lie so near to each other lie at one place.
double samePlaceWithin_mm(double largest_step_mm);

/// How far one plane is turned against another, rad: the larger of the angles of rows and columns.
double turnBetween(const SlicePlane& a, const SlicePlane& b);

/// Whether two planes can be of one stack: the same rows and columns, pixel spacings equal to 1e-4,
/// directions to 0.1 degrees.
bool isAlike(const SlicePlane& a, const SlicePlane& b);

/// The directions in which columns, rows and slices (along row x column) grow; none of a plane that
/// stackOf() refuses as "bad-header".
std::optional<haptics::Mat3> directionOf(const SlicePlane& slice);

/// Makes the stack of slices, k along the normal (row x column), or gives the reason why there is
/// none:
///   "bad-header"         an orientation that is not two perpendicular unit vectors, or a
///                        spacing or position that is not a number
///   "mixed-orientation"  planes more than 0.1 degrees apart
///   "mixed-size"         unequal rows, columns or pixel spacing
///   "duplicate"          two slices at one position
///   "sheared"            positions that do not advance along one line; a tilt beyond 45 degrees
///   "missing-slices"     every odd step is a multiple of the usual one, within 5 %
///   "uneven-spacing"     steps so uneven that resampling would make up most of the slices
/// A stack can be straightened, and has `crooked` set, with
///   "gantry-tilt"        positions that advance more than 0.1 degrees off the normal
///   "uneven-spacing"     steps off the median, or places off their even line, by more than is
///                        allowed; or two regular steps, one behind the other
/// A step may be off the median by 5 % up to 0.05 mm, and by 1 % above that; a place off the even
/// line by twice as much. Positions that are written with few decimals may be off by what that
/// rounds. A single slice takes its thickness, or 1 mm, as its step.
haptics::Expected<Stack> stackOf(const std::vector<SlicePlane>& slices);

/// For slices that stackOf() refuses with "missing-slices": indices of the longest run without a
/// gap, along the normal. The lowest run wins a tie.
std::vector<std::size_t> longestRun(const std::vector<SlicePlane>& slices);

}  // namespace datasets
