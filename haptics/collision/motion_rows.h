// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/collision/clearance.h"
#include "haptics/collision/contact.h"
#include "haptics/core/cursor.h"
#include "haptics/core/fixed_vector.h"
#include "haptics/omissions.h"
#include "haptics/solver/constrained_motion.h"

namespace haptics {

inline constexpr std::size_t kMostSurfaceRows = 48;

/// A near point within the band, which may become a row.
struct RowCandidate {
  Vec3 r_W;
  Vec3 u;      ///< index coordinates
  double gap;  ///< m, to first order
  double value;
  Vec3 exact_W, wide_W;  ///< gradients, per metre
};

/// Rows of points near the surface, and the search in which they were found. If the budget ends a
/// tick while they are made, the next tick continues.
struct SurfaceRows {
  FixedVector<MotionRow, kMostSurfaceRows> rows;
  std::uint32_t search = 0;
  std::size_t near = 0;  ///< number of near points when the rows were made

  enum class Stage : std::uint8_t {
    Done,
    Look,    ///< looks at the near points
    Choose,  ///< chooses among the candidates
    Write    ///< makes the rows of the chosen
  };
  Stage stage = Stage::Done;
  Cursor looked;  ///< through the near points
  FixedVector<RowCandidate, Clearance::kFew> candidates;
  Cursor directions;                          ///< in which the outermost are known
  std::array<int, 26> outermost{};            ///< candidates
  FixedVector<int, kMostSurfaceRows> chosen;  ///< candidates
  Cursor written;                             ///< through the chosen
};
/// Rows of step 3.
using MotionRows = FixedVector<MotionRow, kMostSurfaceRows + Contacts::capacity()>;

/// Makes the rows of the points nearest to the surface, with normals of kind `normal`: at most 48,
/// those with the least gaps and the outermost in 26 directions. The rows are kept while the tool
/// does not move. Returns false if the budget ran out; the next call continues.
bool gatherRows(const NearTool& tool, const Tolerances& lengths, NormalKind normal,
                const Plan& plan, SurfaceRows& surface, Budget& budget) HAPTICS_RT;

/// Makes all rows of step 3: one for every contact that stands in the way (exact normal of its
/// cell), and the rows of `surface`.
void joinRows(const Contacts& contacts, const SurfaceRows& surface, const Tolerances& lengths,
              MotionRows& rows) HAPTICS_RT;

}  // namespace haptics
