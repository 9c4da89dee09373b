// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/solver/constrained_motion.h"
#include "haptics/solver/mass_metric.h"

namespace haptics {

/// Step 3 with Coulomb's dry friction. `frictionless` is the result of constrainedMotion for the
/// same `free` and `rows`. Every active row resists the motion of its point along the surface by at
/// most `mu` times the normal reaction.
///
///   M (V - V_free) = sum_i J_i^T (f_n n_i + f_t)     f_n >= 0 where n_i · v_i = -room_i
///   |f_t| <= mu f_n,  f_t against the point's motion along the surface, any f_t where it rests
///
/// The proxy has no inertia of its own: M is the coupling's metric, so with K = (k/m) M these
/// reactions times k/m are the forces on the hand, and slip begins where the hand's pull along the
/// surface is mu times its push.
///
/// The method is block Gauss-Seidel over the active rows, each with its exact circular cone, from
/// the exact normal reactions. Then the normal problem is solved exactly, so no row is violated. If
/// friction tips the tool onto another row, both are repeated with that row. Friction adds no
/// energy. If the sweeps end before this holds, the points that friction would drive are held at
/// rest. If the rows do not allow that, the tool does not move.
ConstrainedMotion withFriction(const Twist& free, std::span<const MotionRow> rows,
                               const MassMetric& metric, const Mat3& R_WP, double mu,
                               const ConstrainedMotion& frictionless, Budget& budget) HAPTICS_RT;

}  // namespace haptics
