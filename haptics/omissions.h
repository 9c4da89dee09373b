// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "haptics/core/error.h"

namespace haptics {

/// The work that the ticks of a scene leave out. True: left out.
///
/// Studies and tests switch omissions off (SceneOptions::plan), and then the work is done. The tick
/// itself does the work of free_space, central_differences and still_rows. The SecondLook that the
/// study attaches to the proxy does the work of the other three. Its results are used: a point that
/// is inside stops the tool. So poses and forces are the same to the bit, unless a needed check was
/// left out. Compare them only where the budget does not cut.
struct Plan {
  /// Collision detection and rows, in a tick in which every point of the tool is proven to have
  /// more room than the hand moved. It needs the next two omissions, and is off if either is off.
  bool free_space = true;
  /// Sampling of points, branches of the shell and paths that bounds of the field prove free. Off:
  /// every point is sampled at every pose, and every cell of its path is examined.
  bool empty_space = true;
  /// New checks of points and branches whose room motion has not used up.
  bool unspent_room = true;
  /// Gradients of points that are proven to be farther from the surface than the band. Off: a point
  /// that meets the surface within the band, in the direction of its gradient, gets a row.
  bool far_gradients = true;
  /// Central differences, if the rows use another normal.
  bool central_differences = true;
  /// Making the rows again while the tool has not moved.
  bool still_rows = true;

  /// Whether every point is checked in every tick.
  bool looksAgain() const { return !(empty_space && unspent_room); }
};

/// One omission of the plan, in words.
struct PlanLine {
  bool Plan::*omission;
  Message what;  ///< the work that it leaves out: "central differences"
  bool left_out = true;
  Message why;  ///< a clause after "because": why the work is left out here, or why not
};

/// One line for each omission, in the order of Plan.
using PlanLines = std::array<PlanLine, 6>;

}  // namespace haptics
