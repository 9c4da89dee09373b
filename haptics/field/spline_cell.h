// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"

namespace haptics {

/// The part of the uniform cubic B-spline with the voxels as coefficients ([Unser 1999]; no
/// prefilter, so it approximates them) that lies in one cell: a tricubic polynomial.
///
/// Voxels are mirrored at the faces of the box that exists, the grid or its crop. Beyond a face the
/// value of the face falls to the background within one voxel, linearly, as the trilinear field
/// does. Every value is a mean of the 4^3 voxels and the background with non-negative weights. So
/// the greatest of them bounds the value, and their differences bound its slope.
struct SplineCell {
  /// A polynomial of degree 9 on [0, 1] by its Bernstein coefficients; their hull contains it.
  using Along = std::array<double, 10>;

  std::array<std::int64_t, 3> at{};  ///< index of its lowest corner; one below the box is the ring
                                     ///< outside the box, where F falls to the background
  /// [k][j][i], each from at - 1 to at + 2.
  std::array<std::array<std::array<double, 4>, 4>, 4> voxel;
  std::array<int, 3> face{};  ///< -1, 1: outside beyond the low, high face of the axis
  double background = 0.0;
  bool beyond = false;  ///< the whole cell is background

  double greatest() const HAPTICS_RT;            ///< no value of the cell is above this
  double value(const Vec3& u) const HAPTICS_RT;  ///< at index coordinates u within the cell
  /// Value, and gradient per index step.
  double sample(const Vec3& u, Vec3& gradient) const HAPTICS_RT;
  /// The same gradient, summed along i first: the order to which recordings of a trilinear field
  /// with normals of this kind are held.
  Vec3 normalSlope(const Vec3& u) const HAPTICS_RT;
  /// The field along the segment a→b of index coordinates.
  Along alongSegment(const Vec3& a, const Vec3& b) const HAPTICS_RT;
};

/// The cell of a volume with its lowest corner at this index. `bounds`: volume.bounds().
SplineCell splineCellAt(const Volume& volume, const VoxelBox& bounds,
                        const std::array<std::int64_t, 3>& at) HAPTICS_RT;

}  // namespace haptics
