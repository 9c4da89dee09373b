// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/solver/mass_metric.h"

namespace haptics {

/// One contact's constraint on the motion: n·(v + w x r) >= -room.
struct MotionRow {
  Vec3 n_W;     ///< unit normal, out of the solid
  Vec3 r_W;     ///< vector from the tool's origin to the point [m]
  double room;  ///< m that it may still approach; negative: it must move away by that much
};

struct ConstrainedMotion {
  enum class Status {
    Exact,      ///< the nearest allowed motion
    Relaxed,    ///< the rows contradict each other; with negative rooms set to zero
    Infeasible  ///< no motion was found; the twist is zero
  };
  Twist twist;
  Vector6 whitened = Vector6::Zero();  ///< the twist in the metric's coordinates [m]
  Status status = Status::Exact;
  int active = 0;                ///< active rows: at most six
  std::array<int, 6> bearing{};  ///< indices of the active rows; the first `active` are valid
  int pivots = 0;                ///< rows that entered or left the active set
  std::int64_t work = 0;         ///< units of a Budget that the caller has to spend on it
  /// Reaction of each active row: M (V - V_free) = sum of reaction · (n, r x n) [m, metric of mass
  /// 1].
  std::array<double, 6> reaction{};
};

/// Step 3: the motion nearest to `free` that leaves every contact its room. Gauss' principle of
/// least constraint, as used for the god-object by [Ortega 2007], with signed gaps.
///
///   minimise  1/2 (V - V_free)^T M (V - V_free)      over V = (v, w)
///   such that n_i · (v + w x r_i) >= -room_i         for every row i
///
/// With zero rooms this is the projection onto the paper's cone, [Chan 2011], (3) and (4), which
/// freezes on noisy scans (haptics/README.md, "How it differs from the paper"). Dual active set
/// after [Goldfarb 1983], whitened by M: exact, at most six active rows.
ConstrainedMotion constrainedMotion(const Twist& free, std::span<const MotionRow> rows,
                                    const MassMetric& metric, const Mat3& R_WP) HAPTICS_RT;

}  // namespace haptics
