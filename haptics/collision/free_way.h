// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/isosurface.h"
#include "haptics/tool/shell_tree.h"

namespace haptics {

/// The fraction of a motion, from its start, along which the pyramid proves every point of the tool
/// free, for any length and rotation of the motion. The method is conservative advancement [Mirtich
/// 1996] with the spheres of the tool's tree. If a sphere is proven to have room, the tool moves on
/// by that room at once. Otherwise the children of the sphere are checked, then its points.
///
/// It ends where the next stretch would be shorter than `least` [m] for the farthest point, since
/// Sweep, which reads the field, is cheaper from there on. If the budget runs out, it returns the
/// fraction proven so far.
double freeShareOf(const Isosurface& solid, const ShellTree& tree, const Pose& X_WP,
                   const Twist& motion, double least, Budget& budget) HAPTICS_RT;

}  // namespace haptics
