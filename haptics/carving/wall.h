// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "haptics/carving/lowering.h"

namespace haptics {

/// The greatest value of a voxel by its distance to a cut's wall. The distance is in voxels, that
/// is measured in index coordinates, positive on the side that stays.
///
/// It rises along a line through the isovalue at the wall, from the background on the side that
/// goes to kStraight voxels on the side that stays, and then steeply to the greatest value. What a
/// trilinear field and its central differences meet near the wall is that line alone, so they give
/// the plane itself (README.md, "The wall").
class WallProfile {
 public:
  static constexpr double kBack = 3.0;      ///< voxels: from the wall to the background, at least
  static constexpr double kSolid = 1.5;     ///< voxels: from the wall to the greatest, at least
  static constexpr double kStraight = 2.0;  ///< voxels behind the wall
  static constexpr double kReach = 2.75;    ///< voxels behind the wall: beyond, none is lowered

  WallProfile(double background, double greatest, double isovalue)
      : background_{background},
        greatest_{greatest},
        isovalue_{isovalue},
        slope_{std::max(std::min((isovalue - background) / kBack, (greatest - isovalue) / kSolid),
                        1e-9)},
        back_{std::max(0.0, isovalue - background) / slope_},
        rise_{std::max(0.0, greatest - isovalue - slope_ * kStraight) / (kReach - kStraight)} {
    back_ = std::min(back_, kMostBack);
  }

  double ceiling(double distance) const {
    if (distance < -back_) return background_;
    return std::max(background_,
                    isovalue_ + slope_ * distance + rise_ * std::max(0.0, distance - kStraight));
  }
  /// The least value of a voxel of a solid by its distance to the wall, which is negative within
  /// it: the same line, falling through the isovalue, level from kBack voxels within the solid on.
  double floor(double distance) const {
    if (distance >= kReach) return background_;
    const double line = isovalue_ - slope_ * std::max(distance, -kBack);
    const double steep = std::max(0.0, isovalue_ - slope_ * kStraight - background_) /
                         (kReach - kStraight) * std::max(0.0, distance - kStraight);
    return std::clamp(line - steep, background_, greatest_);
  }
  /// Voxels before the wall: beyond, all are background.
  double back() const { return back_; }
  /// Per voxel, at the wall.
  double slope() const { return slope_; }
  /// Per voxel, the most anywhere on the side that is cut away from.
  double steepest() const {
    // where the line ends before the background, beyond kMostBack voxels
    const double step = std::max(0.0, isovalue_ - background_ - slope_ * back_);
    return slope_ + std::max(rise_, step);
  }
  /// Per voxel, what is added beyond kStraight voxels behind the wall.
  double rise() const { return rise_; }

  /// A row along which the distance is at(i) = at_zero + i step, for first <= i < end.
  void cutLinear(std::int64_t first, std::int64_t end, double at_zero, double step,
                 RowCut& cut) const {
    // where the distance is below a limit, as a range of i: the row is on one side of each
    const auto below = [&](double limit, std::int64_t& from, std::int64_t& until) {
      from = first;
      until = end;
      if (std::abs(step) < 1e-12) {
        if (at_zero >= limit) until = from;
        return;
      }
      const double cross = std::clamp((limit - at_zero) / step, static_cast<double>(first) - 2.0,
                                      static_cast<double>(end) + 2.0);
      if (step > 0.0)
        until = std::clamp(static_cast<std::int64_t>(std::ceil(cross)), first, end);
      else
        from = std::clamp(static_cast<std::int64_t>(std::floor(cross)) + 1, first, end);
    };
    std::int64_t deep_from, deep_until, from, until;
    below(-back_, deep_from, deep_until);
    below(kReach, from, until);
    const auto ramp = [&](std::int64_t a, std::int64_t b) {
      if (a >= b) return;
      for (std::int64_t i = a; i < b; ++i)
        cut.ceiling[static_cast<std::size_t>(i)] = ceiling(at_zero + step * static_cast<double>(i));
      cut.spans.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), false});
    };
    if (deep_from >= deep_until) return ramp(from, until);
    ramp(from, deep_from);
    cut.spans.push_back(
        {static_cast<std::int32_t>(deep_from), static_cast<std::int32_t>(deep_until), true});
    ramp(deep_until, until);
  }

 private:
  static constexpr double kMostBack = 8.0;  // voxels: of an isovalue near the greatest value

  double background_, greatest_, isovalue_, slope_, back_;
  double rise_;  // of the steep part, beside the slope
};

}  // namespace haptics
