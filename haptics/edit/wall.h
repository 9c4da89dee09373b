// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "haptics/edit/operators.h"

namespace haptics {

/// The greatest value of a voxel by its distance to a cut's wall. The distance is in voxels, that
/// is measured in index coordinates, positive on the side that stays.
class WallProfile {
 public:
  static constexpr double kHalfWidth = 0.75;  ///< voxels: of the ramp

  /// At the wall it has the isovalue, and half a width before it the background.
  WallProfile(double background, double isovalue)
      : background_{background},
        isovalue_{isovalue},
        slope_{std::max(isovalue - background, 1e-6) / kHalfWidth} {}

  double ceiling(double distance) const {
    return std::max(background_, isovalue_ + slope_ * distance);
  }
  /// Beyond this distance no voxel is lowered.
  static constexpr double kReach = 3.0;

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
    below(-kHalfWidth, deep_from, deep_until);
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
  double background_, isovalue_, slope_;
};

}  // namespace haptics
