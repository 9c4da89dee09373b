// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// Penetration of the deepest shell point at a pose [m]: 0 if F < isovalue, otherwise (F -
/// isovalue) / |grad F| of its trilinear cell. If the gradient vanishes, the distance to the
/// nearest voxel below the isovalue. For reports, not for the tick.
double penetration(const Scene& scene, double isovalue, const Pose& X_WP);

}  // namespace haptics
