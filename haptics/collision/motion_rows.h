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
  std::size_t near = 0;  ///< number of near points when the rows were made
};
/// Rows of step 3.
using MotionRows = FixedVector<MotionRow, kMostSurfaceRows + Contacts::capacity()>;

/// Makes the rows of the points nearest to the surface, with normals of kind `normal`: at most 48,
/// those with the least gaps and the outermost in 26 directions. The rows are kept while the tool
/// does not move.
void gatherRows(const NearTool& tool, const Tolerances& lengths, NormalKind normal,
                const Plan& plan, SurfaceRows& surface, Budget& budget) HAPTICS_RT;

/// Makes all rows of step 3: one for every contact that stands in the way (exact normal of its
/// cell), and the rows of `surface`.
void joinRows(const Contacts& contacts, const SurfaceRows& surface, const Tolerances& lengths,
              MotionRows& rows) HAPTICS_RT;

}  // namespace haptics
