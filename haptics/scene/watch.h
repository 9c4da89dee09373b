// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/scene/scene.h"
#include "haptics/structures/distance_map.h"
#include "haptics/structures/nearness.h"

namespace haptics {

/// Structures to which the tool's distance is known in every tick. Immutable; it has its own order
/// and belongs to no scene.
struct Watch {
  struct Watched {
    std::uint8_t structure = 0;  ///< its number in the label map
    DistanceMap distances;
  };
  std::vector<Watched> structures;  ///< at most kMostWatched
};

/// Measures the distances of the tool at X_WP to every structure of the watch. The same watch, tool
/// and pose give the same bits. Nearest is the least over all shell points; the tree leaves out
/// those that cannot be it.
void measure(const Watch& watch, const Scene& scene, const Pose& X_WP,
             Nearnesses& measured) HAPTICS_RT;

}  // namespace haptics
