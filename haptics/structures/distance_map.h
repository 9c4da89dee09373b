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
  /// Bounds of the slope between the samples: anywhere, and where the distance is not negative.
  /// Where two sides are as near it is steeper than 1.
  double steepest = 1.0, steepest_outside = 1.0;
  std::shared_ptr<const std::int16_t[]> samples;  ///< i fastest

  /// Bytes of the samples.
  std::size_t bytes() const { return std::size_t(grid.voxelCount()) * sizeof(std::int16_t); }

  /// m, the greatest distance that is told of a tool: at less than `most`, the place of a part of
  /// it that is at `most` says how far its other parts are at least.
  double told() const HAPTICS_RT { return 2.0 * most / 3.0; }

  /// The distance of a place in W [m], trilinear between the samples; `most` beyond them.
  double at(const Vec3& p_W) const HAPTICS_RT { return atIndex(grid.indexOf(p_W)); }

  /// The same, at an index of the samples.
  double atIndex(const Vec3& at) const HAPTICS_RT {
    const Cell cell = cellAt(at);
    if (cell.first == nullptr) return most;
    const double near = cell.across(cell.first), far = cell.across(cell.first + cell.slice);
    return step * (near + cell.part[2] * (far - near));
  }

  /// The gradient of what at() gives, in W; 0 beyond the samples.
  Vec3 gradientAt(const Vec3& p_W) const HAPTICS_RT {
    const Cell cell = cellAt(grid.indexOf(p_W));
    if (cell.first == nullptr) return Vec3::Zero();
    const auto& [x, y, z] = cell.part;
    const std::int16_t* const f = cell.first;
    const std::int64_t row = cell.row, slice = cell.slice;
    const auto between = [](double near, double far, double part) {
      return near + part * (far - near);
    };
    const auto stepAt = [&](std::int64_t at, std::int64_t by) {
      return double(f[at + by] - f[at]);
    };
    const Vec3 steps(between(between(stepAt(0, 1), stepAt(row, 1), y),
                             between(stepAt(slice, 1), stepAt(slice + row, 1), y), z),
                     between(between(stepAt(0, row), stepAt(1, row), x),
                             between(stepAt(slice, row), stepAt(slice + 1, row), x), z),
                     between(between(stepAt(0, slice), stepAt(1, slice), x),
                             between(stepAt(row, slice), stepAt(row + 1, slice), x), y));
    return grid.direction * (step * steps.cwiseQuotient(grid.spacing));
  }

 private:
  /// Eight samples, and where between them; `first` is null beyond the samples.
  struct Cell {
    const std::int16_t* first = nullptr;
    std::int64_t row = 0, slice = 0;
    std::array<double, 3> part{};

    double along(const std::int16_t* of) const HAPTICS_RT {
      return double(of[0]) + part[0] * double(of[1] - of[0]);
    }
    double across(const std::int16_t* of) const HAPTICS_RT {
      const double near = along(of), far = along(of + row);
      return near + part[1] * (far - near);
    }
  };
  Cell cellAt(const Vec3& at) const HAPTICS_RT {
    Cell cell{.row = grid.dims[0], .slice = grid.dims[0] * grid.dims[1]};
    std::array<std::int64_t, 3> low;
    for (int axis = 0; axis < 3; ++axis) {
      const auto of = std::size_t(axis);
      // not finite is beyond, too
      if (!(at[axis] >= 0.0 && at[axis] <= double(grid.dims[of] - 1))) return cell;
      low[of] = std::min(std::int64_t(at[axis]), grid.dims[of] - 2);
      cell.part[of] = at[axis] - double(low[of]);
    }
    cell.first = samples.get() + low[2] * cell.slice + low[1] * cell.row + low[0];
    return cell;
  }
};

/// Sets the bounds of the slope; on all cores, and not on the servo thread.
void boundSlopes(DistanceMap& map);

}  // namespace haptics
