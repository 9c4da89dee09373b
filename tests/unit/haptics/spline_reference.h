// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "haptics/core/volume.h"

/// The cubic B-spline field written down once more, from its definition and sharing no code.
namespace spline_reference {

/// The centred cardinal cubic B-spline.
inline double kernel(double x) {
  x = std::abs(x);
  if (x >= 2.0) return 0.0;
  if (x >= 1.0) return (2.0 - x) * (2.0 - x) * (2.0 - x) / 6.0;
  return 2.0 / 3.0 - x * x + 0.5 * x * x * x;
}

inline double voxelAt(const haptics::Volume& volume, std::int64_t i, std::int64_t j,
                      std::int64_t k) {
  const auto& dims = volume.grid.dims;
  return haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* v) {
    return double(v[(k * dims[1] + j) * dims[0] + i]);
  });
}

/// At index coordinates u: the spline over mirrored voxels at the nearest place of the grid, and
/// from there the fall to the background.
inline double fieldAtIndex(const haptics::Volume& volume, const haptics::Vec3& u) {
  const auto& dims = volume.grid.dims;
  double left = 1.0;
  haptics::Vec3 q;
  for (int axis = 0; axis < 3; ++axis) {
    q[axis] = std::clamp(u[axis], 0.0, double(dims[static_cast<std::size_t>(axis)] - 1));
    left *= std::max(0.0, 1.0 - std::abs(u[axis] - q[axis]));
  }
  if (left == 0.0) return volume.least;
  const auto mirrored = [](std::int64_t i, std::int64_t n) {
    if (n == 1) return std::int64_t{0};
    const std::int64_t period = 2 * (n - 1), r = ((i % period) + period) % period;
    return r < n ? r : period - r;
  };
  double sum = 0.0;
  const auto i0 = static_cast<std::int64_t>(std::floor(q.x()));
  const auto j0 = static_cast<std::int64_t>(std::floor(q.y()));
  const auto k0 = static_cast<std::int64_t>(std::floor(q.z()));
  for (std::int64_t k = k0 - 2; k <= k0 + 3; ++k)
    for (std::int64_t j = j0 - 2; j <= j0 + 3; ++j)
      for (std::int64_t i = i0 - 2; i <= i0 + 3; ++i)
        sum += kernel(q.x() - double(i)) * kernel(q.y() - double(j)) * kernel(q.z() - double(k)) *
               voxelAt(volume, mirrored(i, dims[0]), mirrored(j, dims[1]), mirrored(k, dims[2]));
  return left == 1.0 ? sum : left * sum + (1.0 - left) * volume.least;
}

inline double fieldAt(const haptics::Volume& volume, const haptics::Vec3& p_W) {
  return fieldAtIndex(volume, volume.grid.indexOf(p_W));
}

}  // namespace spline_reference
