// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/study/reference/tick.h"

namespace rivals {

using haptics::Mat3;
using haptics::Pose;
using haptics::Twist;
using haptics::Vec3;
using haptics::Wrench;

/// A point of the shell near the surface, by the field itself as distance.
struct NearPoint {
  Vec3 r_W = Vec3::Zero();  ///< m, from the tool's centre
  Vec3 n_W = Vec3::Zero();  ///< unit, out of the solid
  double gap = 0.0;         ///< m: (s - F) / |grad F|, negative inside
};

/// All points of the tool with a gap of at most `reach` [m]. Every point is looked up. One without
/// a gradient is left out, for it says neither how far nor where to.
void pointsWithin(const reference::Scene& scene, const Pose& X_WP, double reach,
                  std::vector<NearPoint>& found);

}  // namespace rivals
