// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"

namespace haptics {

/// Signed distances to the surface of a structure, sampled in a box around it: positive outside,
/// negative inside, and never above `most` or below -most. The surface lies halfway between a voxel
/// that belongs to the structure and its neighbour that does not. Immutable once made.
struct DistanceMap {
  Grid grid;          ///< of the samples; it goes `most` beyond the structure on all sides
  double step = 0.0;  ///< m of one unit of a sample
  double most = 0.0;  ///< m, what a sample says at most
  /// m, by which a distance outside the structure is wrong at most, because voxels do not say where
  /// between them its surface lies. In its middle, where two sides are as near, it is twice that.
  double error = 0.0;
  double steepest = 1.0;                          ///< bound of the slope between samples
  std::shared_ptr<const std::int16_t[]> samples;  ///< i fastest

  /// Bytes of the samples.
  std::size_t bytes() const { return std::size_t(grid.voxelCount()) * sizeof(std::int16_t); }

  /// m, the greatest distance that is told of a tool: at less than `most`, the place of a part of
  /// it that is at `most` says how far its other parts are at least.
  double told() const HAPTICS_RT { return most * (2.0 / 3.0); }

  /// The distance of a place in W [m], trilinear between the samples; `most` beyond them.
  double at(const Vec3& p_W) const HAPTICS_RT { return atIndex(grid.indexOf(p_W)); }

  /// The same, at an index of the samples.
  double atIndex(const Vec3& at) const HAPTICS_RT {
    std::array<std::int64_t, 3> low;
    std::array<double, 3> part;
    for (int axis = 0; axis < 3; ++axis) {
      const auto of = std::size_t(axis);
      // not finite is beyond, too
      if (!(at[axis] >= 0.0 && at[axis] <= double(grid.dims[of] - 1))) return most;
      low[of] = std::min(std::int64_t(at[axis]), grid.dims[of] - 2);
      part[of] = at[axis] - double(low[of]);
    }
    const std::int64_t row = grid.dims[0], slice = grid.dims[0] * grid.dims[1];
    const std::int16_t* first = samples.get() + low[2] * slice + low[1] * row + low[0];
    const auto along = [&](const std::int16_t* of) {
      return double(of[0]) + part[0] * double(of[1] - of[0]);
    };
    const auto across = [&](const std::int16_t* of) {
      const double near = along(of), far = along(of + row);
      return near + part[1] * (far - near);
    };
    const double near = across(first), far = across(first + slice);
    return step * (near + part[2] * (far - near));
  }
};

}  // namespace haptics
