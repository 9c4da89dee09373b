// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/core/fixed_vector.h"
#include "haptics/solver/constrained_motion.h"

namespace haptics {

inline constexpr std::size_t kMostMotionRows = 72;
using MotionRows = FixedVector<MotionRow, kMostMotionRows>;

/// The rows of step 3: one for every contact that stands in the way (exact normal of its cell) and
/// one for each of the points nearest to the surface (normal as `normal` says), at most 48 of them:
/// those with the least gaps, and the outermost in 26 directions.
void gatherRows(const Isosurface& solid, const ShellTree& tree, const Pose& X_WP,
                const Clearance& near, const Contacts& contacts, const Tolerances& lengths,
                NormalKind normal, MotionRows& rows, Budget& budget) HAPTICS_RT;

}  // namespace haptics
