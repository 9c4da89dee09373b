// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/collision/motion.h"
#include "haptics/core/budget.h"

namespace haptics {

/// The first time in [from, to] at which a point on its path may reach `level`, never later than
/// it does and at most `root` [m] of path (plus the sagitta's effect) earlier; `to` if it stays
/// below. Exact: along a chord within a cell the trilinear field is a cubic, whose first root is
/// isolated in Bernstein form; what is skipped is proven free by the pyramid's bounds.
struct Crossing {
  double time = 1.0;
  bool met = false;
};
Crossing firstCrossing(const Isosurface& solid, const PointPath& path, double from, double to,
                       double start_value, const Tolerances& lengths, Budget& budget) HAPTICS_RT;

/// How far the tool gets.
struct Impact {
  double time = 1.0;  ///< fraction of the motion that is free for every shell point
  bool met = false;   ///< stopped by a point, not by the end of the motion or the budget
  Contact contact;    ///< that point, with the exact normal of the cell it met
};

/// Step 4: continuous collision detection of the whole shell along a motion. `near` must hold all
/// points with less clearance than the motion's length. When the budget runs out, points not
/// looked at yet count with what their clearance proves: a shorter motion, never a wrong one.
Impact sweep(const Isosurface& solid, const Clearance& near, const Pose& X_WP, const Twist& motion,
             const Tolerances& lengths, Budget& budget) HAPTICS_RT;

}  // namespace haptics
