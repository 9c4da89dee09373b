// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace haptics {

/// How the voxels become a field.
enum class FieldKind {
  Trilinear,   ///< interpolates the voxels, as in [Chan 2011], 2.2
  CubicSpline  ///< the voxels are the coefficients of a cubic B-spline: smoother, and only
               ///< approximates them
};

}  // namespace haptics
