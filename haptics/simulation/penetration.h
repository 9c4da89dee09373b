// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// How deep the deepest shell point is at a pose [m]: 0 where F < isovalue, else
/// (F - isovalue) / |grad F| of its trilinear cell; where that vanishes, the distance to the
/// nearest voxel below the isovalue. For reports; not for the tick.
double penetration(const Scene& scene, double isovalue, const Pose& X_WP);

}  // namespace haptics
