// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/solver/constrained_motion.h"
#include "haptics/solver/mass_metric.h"

namespace haptics {

/// Step 3 with Coulomb's dry friction: what `frictionless`, the answer of constrainedMotion to the
/// same `free` and `rows`, becomes when every row that bears holds its point back along the
/// surface with at most `mu` times the normal reaction.
///
///   M (V - V_free) = sum_i J_i^T (f_n n_i + f_t)     f_n >= 0 where n_i · v_i = -room_i
///   |f_t| <= mu f_n,  f_t against the point's motion along the surface, any f_t where it rests
///
/// The proxy has no inertia of its own: M is the coupling's metric, so with K = (k/m) M these
/// reactions times k/m are the forces on the hand, and slip begins where the hand's pull along the
/// surface is mu times its push.
///
/// Block Gauss-Seidel over the rows that bear, each with its circular cone solved exactly, from the
/// exact normal reactions; the normal problem is exact again afterwards, so no row is ever violated
/// (friction may tip the tool onto another: then once more with it). Friction never adds energy:
/// where the sweeps end before that is so, the points that it would drive rest; where that is not
/// allowed, the tool stays where it is.
ConstrainedMotion withFriction(const Twist& free, std::span<const MotionRow> rows,
                               const MassMetric& metric, const Mat3& R_WP, double mu,
                               const ConstrainedMotion& frictionless, Budget& budget) HAPTICS_RT;

}  // namespace haptics
