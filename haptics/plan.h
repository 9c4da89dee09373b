// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace haptics {

/// What the ticks of a scene leave out. True: left out.
///
/// Switched off (SceneOptions::plan; studies and tests do), the work is done after all: of
/// free_space, central_differences and still_rows by the tick itself, of the other three by the
/// SecondLook that the study attaches to the proxy. What it finds counts: a point that is inside
/// stops the tool. So poses and forces are the same to the bit, unless something was left out that
/// was needed. They are to be compared only where the budget does not cut.
struct Plan {
  /// Collision detection and rows, in a tick in which every point of the tool is proven to have
  /// more room than the hand moved. Rests on the next two: off with either.
  bool free_space = true;
  /// Sampling of what the pyramid's bounds prove free: points, branches of the shell, paths. Off:
  /// every point is sampled at every pose, and every cell of its path looked at.
  bool empty_space = true;
  /// Another look at points and branches whose room motion has not used up.
  bool unspent_room = true;
  /// Gradients of points that are proven to be further from the surface than the band. Off: one
  /// that does meet it within the band, in the direction of its gradient, has its row.
  bool far_gradients = true;
  /// Central differences where the rows have another normal.
  bool central_differences = true;
  /// Rows anew while the tool has not moved.
  bool still_rows = true;

  /// Whether every point is looked at in every tick all the same.
  bool looksAgain() const { return !(empty_space && unspent_room); }
};

/// One thing of the plan, in words.
struct PlanLine {
  bool Plan::*omission;
  std::string what;  ///< what it would leave out: "central differences"
  bool left_out = true;
  std::string why;  ///< a clause after "because": why it is left out here, or why not
};

/// One line for each omission, in the order of Plan.
using PlanLines = std::array<PlanLine, 6>;

}  // namespace haptics
