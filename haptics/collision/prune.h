// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/collision/contact.h"
#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/isosurface.h"
#include "haptics/tool/point_shell.h"

namespace haptics {

/// Whether a shell point, moved a distance epsilon along the motion, enters the solid: the verdict
/// of step 2, [Chan 2011], 2.3. A point that the motion does not move is not in the way.
bool standsInTheWay(const Isosurface& solid, const Vec3& c_W, const Vec3& r_W, const Twist& motion,
                    double epsilon) HAPTICS_RT;

/// Step 2: verifies the contacts at the proxy's pose. Contacts that no longer stand in the way of
/// `free` are dropped, and so are contacts whose point is more than a rest gap from where it met
/// the surface. The others keep their normal (of the cell behind the surface, not of the cell that
/// contains the point) and get the remaining gap along it. The normal of one cell is valid no
/// farther than that: kept longer, the plane of one cell blocks the tool beyond the surface.
void prune(const Isosurface& solid, const PointShell& shell, const Pose& X_WP, const Twist& free,
           const Tolerances& lengths, Contacts& contacts, Budget& budget) HAPTICS_RT;

}  // namespace haptics
