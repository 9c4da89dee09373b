// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "haptics/solver/constrained_motion.h"

namespace study::accuracy {

/// The nearest motion that a few contacts allow.
struct ProjectionProblem {
  haptics::MassMetric metric{haptics::Mat3::Identity()};
  haptics::Mat3 R_WP = haptics::Mat3::Identity();
  haptics::Twist free;
  std::vector<haptics::MotionRow> rows;
};

/// A way to solve it.
struct Solver {
  std::string name;
  /// Adds to the second how often a row entered or left the active set.
  std::function<haptics::Twist(const ProjectionProblem&, std::int64_t&)> solve;
};
/// Ours, and the non-negative least squares of the reference.
std::vector<Solver> solvers();

/// The answer in long double, by trying every set of at most six rows: shares no code with a
/// solver. Not for many rows: C(n, 6) sets.
haptics::Twist byEnumeration(const ProjectionProblem& problem);

/// Random problems of so many rows, general or nearly coplanar: how far each solver is from the
/// enumeration, in the mass metric, relative to the free motion, against its time. The first
/// solver is held to rounding.
Outcome projections(const std::vector<Solver>& all, int rows, bool coplanar, int count,
                    unsigned seed);

}  // namespace study::accuracy
