// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/isosurface.h"
#include "haptics/tool/shell_tree.h"

namespace haptics {

/// The share of a motion, from its start, along which the pyramid proves every point of the tool
/// free, however long the motion is and however far it turns: conservative advancement [Mirtich
/// 1996] with the spheres of the tool's tree. Where a sphere is proven to have room, the tool moves
/// on by that much at once; where it is not, its children are asked, then its points.
///
/// Ends where the next stretch would be shorter than `least` [m] for the farthest point: from there
/// on Sweep is cheaper, which reads the field. Ends at what is proven so far where the budget does.
double freeShareOf(const Isosurface& solid, const ShellTree& tree, const Pose& X_WP,
                   const Twist& motion, double least, Budget& budget) HAPTICS_RT;

}  // namespace haptics
