// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"

/// The meanings of the field and of penetration written out once more, in double and without any
/// code of haptics/field: what tests hold the product to. Slow, plain, and tested.
namespace evaluator {

using haptics::Pose;
using haptics::Vec3;

/// One voxel; outside the grid or its crop the background, which is the least voxel.
inline double voxelAt(const haptics::Volume& volume, const std::array<std::int64_t, 3>& at) {
  const auto& dims = volume.grid.dims;
  const haptics::VoxelBox box = volume.bounds();
  for (int axis = 0; axis < 3; ++axis)
    if (at[axis] < box.first[axis] || at[axis] >= box.end[axis]) return volume.least;
  return haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    return static_cast<double>(voxels[(at[2] * dims[1] + at[1]) * dims[0] + at[0]]);
  });
}

/// The cell a point lies in.
struct Cell {
  std::array<std::int64_t, 3> low;  ///< its corner with the least indices
  std::array<double, 3> part;       ///< where in it, 0 to 1 along i, j, k

  std::array<std::int64_t, 3> corner(int c) const {
    return {low[0] + (c & 1), low[1] + (c >> 1 & 1), low[2] + (c >> 2 & 1)};
  }
  double weight(int c, int axis) const { return c >> axis & 1 ? part[axis] : 1.0 - part[axis]; }
};

inline Cell cellOf(const haptics::Volume& volume, const Vec3& p_W) {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 along_W = volume.grid.direction.col(axis);
    double index = along_W.dot(p_W - volume.grid.origin) / volume.grid.spacing[axis];
    // two voxels beyond the grid all is background
    index = std::fmin(std::fmax(index, -3.0), static_cast<double>(volume.grid.dims[axis]) + 2.0);
    cell.low[axis] = static_cast<std::int64_t>(std::floor(index));
    cell.part[axis] = index - std::floor(index);
  }
  return cell;
}

/// F at p: along i, then j, then k, so that equal voxels give exactly their value.
inline double fieldAt(const haptics::Volume& volume, const Vec3& p_W) {
  const Cell cell = cellOf(volume, p_W);
  std::array<double, 8> F;
  for (int c = 0; c < 8; ++c) F[c] = voxelAt(volume, cell.corner(c));
  for (int axis = 0, pairs = 4; axis < 3; ++axis, pairs /= 2)
    for (int n = 0; n < pairs; ++n) F[n] = F[2 * n] + (F[2 * n + 1] - F[2 * n]) * cell.part[axis];
  return F[0];
}

/// grad F of the trilinear cell at p along the axes of the voxels, per metre.
inline Vec3 slopesAt(const haptics::Volume& volume, const Vec3& p_W) {
  const Cell cell = cellOf(volume, p_W);
  Vec3 slopes;
  for (int axis = 0; axis < 3; ++axis) {
    // the four edges along the axis, so that equal voxels give exactly zero
    double slope = 0.0;
    for (int c = 0; c < 8; ++c) {
      if (c >> axis & 1) continue;
      const double rise =
          voxelAt(volume, cell.corner(c | 1 << axis)) - voxelAt(volume, cell.corner(c));
      slope += cell.weight(c, (axis + 1) % 3) * cell.weight(c, (axis + 2) % 3) * rise;
    }
    slopes[axis] = slope / volume.grid.spacing[axis];
  }
  return slopes;
}

/// |grad F| of the trilinear cell at p, per metre.
inline double slopeAt(const haptics::Volume& volume, const Vec3& p_W) {
  return slopesAt(volume, p_W).norm();
}

/// Distance from p to the nearest voxel with F < isovalue, in m, voxels beyond the grid included:
/// for the rare point on a plateau.
inline double distanceToLegal(const haptics::Volume& volume, double isovalue, const Vec3& p_W) {
  const haptics::Grid& grid = volume.grid;
  const std::array<std::int64_t, 3> centre = cellOf(volume, p_W).low;
  const double side = grid.spacing.minCoeff();
  const std::int64_t widest = std::max({grid.dims[0], grid.dims[1], grid.dims[2]}) + 1;
  // growing cubes of voxels, until no voxel beyond the cube can be nearer
  double nearest = std::numeric_limits<double>::infinity();
  for (std::int64_t n = 0; n <= widest && double(n - 1) * side < nearest; ++n)
    for (std::int64_t k = -n; k <= n; ++k)
      for (std::int64_t j = -n; j <= n; ++j) {
        // the faces of the cube only: its inside has been looked at
        const bool face = std::abs(k) == n || std::abs(j) == n;
        for (std::int64_t i = -n; i <= n; i += face ? 1 : 2 * n) {
          const std::array<std::int64_t, 3> at{centre[0] + i, centre[1] + j, centre[2] + k};
          if (voxelAt(volume, at) >= isovalue) continue;
          Vec3 there_W = grid.origin;
          for (int axis = 0; axis < 3; ++axis)
            there_W += grid.direction.col(axis) * (grid.spacing[axis] * double(at[axis]));
          nearest = std::fmin(nearest, (there_W - p_W).norm());
        }
      }
  return nearest;
}

/// How far a point is inside, in mm: 0 where F < isovalue; else (F - isovalue) over the slope of
/// its cell, and where that vanishes the distance to the nearest voxel outside.
inline double penetrationAt_mm(const haptics::Volume& volume, double isovalue, const Vec3& p_W) {
  const double excess = fieldAt(volume, p_W) - isovalue;
  if (excess < 0.0) return 0.0;
  const double slope = slopeAt(volume, p_W);
  return 1e3 * (slope > 0.0 ? excess / slope : distanceToLegal(volume, isovalue, p_W));
}

/// The deepest of a shell's points at a pose, in mm; exactly 0 where the pose is legal but for
/// points with F = isovalue, which count as inside with depth 0: ask `isLegal` for those.
inline double penetration_mm(const haptics::Volume& volume, double isovalue,
                             std::span<const Vec3> shell_points, const Pose& X_WP) {
  double deepest = 0.0;
  for (const Vec3& r_P : shell_points)
    deepest = std::fmax(deepest, penetrationAt_mm(volume, isovalue, X_WP * r_P));
  return deepest;
}

/// True if every point of the shell has F < isovalue at this pose.
inline bool isLegal(const haptics::Volume& volume, double isovalue,
                    std::span<const Vec3> shell_points, const Pose& X_WP) {
  for (const Vec3& r_P : shell_points)
    if (!(fieldAt(volume, X_WP * r_P) < isovalue)) return false;
  return true;
}

}  // namespace evaluator
