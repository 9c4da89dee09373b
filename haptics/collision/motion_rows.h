// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/core/fixed_vector.h"
#include "haptics/plan.h"
#include "haptics/solver/constrained_motion.h"

namespace haptics {

inline constexpr std::size_t kMostSurfaceRows = 48;

/// Rows of points near the surface, and the search in which they were found.
struct SurfaceRows {
  FixedVector<MotionRow, kMostSurfaceRows> rows;
  std::uint32_t search = 0;
  std::size_t near = 0;  ///< points that it had found near by then
};
/// Rows of step 3.
using MotionRows = FixedVector<MotionRow, kMostSurfaceRows + Contacts::capacity()>;

/// The rows of the points nearest to the surface (their normal of this kind), at most 48 of them:
/// those with the least gaps, and the outermost in 26 directions. Kept while the tool has not
/// moved.
void gatherRows(const NearTool& tool, const Tolerances& lengths, NormalKind normal,
                const Plan& plan, SurfaceRows& surface, Budget& budget) HAPTICS_RT;

/// All rows of step 3: one for every contact that stands in the way (exact normal of its cell),
/// and those of the surface.
void joinRows(const Contacts& contacts, const SurfaceRows& surface, const Tolerances& lengths,
              MotionRows& rows) HAPTICS_RT;

}  // namespace haptics
