// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/collision/contact.h"
#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/isosurface.h"
#include "haptics/tool/point_shell.h"

namespace haptics {

/// Whether a shell point, moved a distance epsilon along the motion, enters the solid: the
/// verdict of step 2, [Chan 2011], 2.3. A point that the motion does not move holds nothing.
bool standsInTheWay(const Isosurface& solid, const Vec3& c_W, const Vec3& r_W, const Twist& motion,
                    double epsilon) HAPTICS_RT;

/// Step 2: verifies the contacts at the proxy's pose. Those that no longer stand in the way of
/// `free`, or whose points are more than a rest gap from where they met the surface, are dropped;
/// the others keep their normal, which is that of the cell beyond, not of the one the point stands
/// in, and get the gap that is left along it. A plane with the normal of one cell is the surface's
/// no farther than that: kept longer, it holds the tool up in mid air, and lets it fall.
void prune(const Isosurface& solid, const PointShell& shell, const Pose& X_WP, const Twist& free,
           const Tolerances& lengths, Contacts& contacts, Budget& budget) HAPTICS_RT;

}  // namespace haptics
