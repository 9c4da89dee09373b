// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

#include "haptics/collision/clearance.h"
#include "haptics/collision/motion.h"
#include "haptics/collision/sweep.h"

/// The collision detection of a whole tool, for a tool of one point.
namespace study::arcs {

/// The path of one point, and the motion that it comes from.
struct Arc : haptics::PointPath {
  Arc(const haptics::Vec3& c_W, const haptics::Vec3& r_W, const haptics::Twist& V)
      : PointPath{c_W, r_W, V}, r{r_W}, motion{V} {
    X.translation() = c_W;
  }
  haptics::Vec3 r;
  haptics::Twist motion;
  haptics::Pose X = haptics::Pose::Identity();
};

struct Crossing {
  double time = 1.0;
  bool met = false;
  int cuts = 0;                 ///< by the allowance
  haptics::Counts counts = {};  ///< of what was done since the last of them
};

/// Where a point that starts outside stops, as a tick finds it: Clearance, then Sweep, each with
/// this much work at a time.
inline Crossing crossed(const haptics::Isosurface& solid, const Arc& arc,
                        const haptics::Tolerances& lengths,
                        std::int64_t allowance = std::numeric_limits<std::int64_t>::max()) {
  using haptics::Budget;
  Crossing crossing;
  const haptics::ShellTree tree{{arc.r}};
  haptics::Clearance clearance{tree};
  Budget budget = Budget::counted(allowance);
  while (clearance.collect(solid, tree, arc.X, arc.speed(), budget) ==
         haptics::Clearance::Verdict::Cut) {
    budget = Budget::counted(allowance);
    ++crossing.cuts;
  }
  haptics::Sweep sweep{1};
  sweep.begin(solid.field, clearance, arc.X, arc.motion, lengths);
  while (!sweep.advance(solid, tree, clearance, lengths, budget)) {
    budget = Budget::counted(allowance);
    ++crossing.cuts;
  }
  const haptics::Impact impact = sweep.impact(solid, tree, lengths, budget);
  crossing.time = impact.time;
  crossing.met = impact.met;
  crossing.counts = budget.counts;
  return crossing;
}

}  // namespace study::arcs
