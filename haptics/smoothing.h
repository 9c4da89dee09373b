// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/volume.h"

namespace haptics {

/// The change of the solid at an isovalue by the cubic spline field, as shares of the trilinear
/// solid's volume: it erases thin walls and closes narrow gaps.
struct SmoothingEffect {
  double erased = 0.0;
  double gained = 0.0;
};

/// Compares both fields at the voxels; in a large volume at some 200,000 evenly spread, fixed ones.
/// Takes some 20 ms. Any thread.
SmoothingEffect smoothingEffect(const Volume& volume, double isovalue);

}  // namespace haptics
