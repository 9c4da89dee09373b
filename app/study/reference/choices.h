// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"

namespace reference {

using haptics::Mat3;
using haptics::Pose;
using haptics::Quat;
using haptics::Twist;
using haptics::Vec3;
using haptics::Wrench;

/// Which reading of [Chan 2011] runs. README.md says where each one fails, and why it is kept.
enum class Variant {
  Literal,       ///< word for word: stops at the outside end of the bisected interval
  Charitable,    ///< Literal, and a contact closer than epsilon / 2 is pushed back to it
  AcceptInside,  ///< stops at the inside end: it moves, and penetrates
};

/// Section 2.3 moves "all points in the contact set … a distance epsilon": the words allow two
/// readings.
enum class EpsilonMotion {
  EachPoint,  ///< every point travels epsilon along its own path
  WholeTool,  ///< the tool moves until its fastest possible point has travelled epsilon
};

/// Every place where the paper leaves a choice, as a switch.
struct Choices {
  Variant variant = Variant::Literal;
  /// Section 2.2 calls F > s inside and F < s outside; false takes exactly that, with F = s
  /// outside. True calls F = s inside, which keeps a plateau at the isovalue solid.
  bool inside_includes_equal = true;
  /// (1) leaves out the division by 2 delta; false does so too. On unequal voxel sides the
  /// undivided gradient points off the normal.
  bool divided_gradient = true;
  EpsilonMotion epsilon_motion = EpsilonMotion::EachPoint;
  /// The paper does not say what becomes of contacts when a tick meets nothing new. True keeps
  /// those that survived pruning, with positions and normals taken anew; false drops them.
  bool keep_survivors = true;
  double epsilon = 0.0;  ///< m, the paper's epsilon; it gives no value. Less than `feature`.
  double feature = 0.0;  ///< m, the paper's f: half the smallest voxel side
};

/// The choices of one variant for a grid: f as in section 2.3, epsilon a tenth of it.
inline Choices choicesFor(const haptics::Grid& grid, Variant variant) {
  Choices choices;
  choices.variant = variant;
  choices.feature = grid.spacing.minCoeff() / 2.0;
  choices.epsilon = choices.feature / 10.0;
  return choices;
}

}  // namespace reference
