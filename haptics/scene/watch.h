// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/scene/scene.h"
#include "haptics/structures/distance_map.h"
#include "haptics/structures/nearness.h"

namespace haptics {

/// How a structure is felt, beside the isosurface.
struct Feel {
  enum class Kind : std::uint8_t {
    AsScan,   ///< as the scan has it: nothing changes
    Softer,   ///< where it is touched, what is felt gives way
    Guarded,  ///< a force keeps the tool away from it
    // in these two it is another volume that is touched (datasets/edits/walls.h)
    Solid,    ///< its own surface stops the tool, too
    NotThere  ///< it is cut away for the touch
  };
  Kind kind = Kind::AsScan;
  double stiffness = 300.0;  ///< Softer: N/m of the tissue, above 0, in series with the coupling's
  double margin = 0.002;     ///< Guarded: m, from where on it is felt; above 0, and below told()
  double most = 2.0;         ///< Guarded: N, at the structure and within

  /// Whether another volume is touched.
  bool isWall() const { return kind == Kind::Solid || kind == Kind::NotThere; }
};

/// Structures to which the tool's distance is known in every tick. Immutable; it has its own order
/// and belongs to no scene.
struct Watch {
  struct Watched {
    std::uint8_t structure = 0;  ///< its number in the label map
    DistanceMap distances;
    Feel feel = {};
  };
  std::vector<Watched> structures;  ///< at most kMostWatched

  /// Whether one of them is felt otherwise than the scan has it.
  bool isFelt() const HAPTICS_RT {
    return std::ranges::any_of(
        structures, [](const Watched& watched) { return watched.feel.kind != Feel::Kind::AsScan; });
  }
  /// The structure of this number; null: it is not watched.
  const Watched* find(std::uint8_t structure) const {
    const auto at = std::ranges::find(structures, structure, &Watched::structure);
    return at == structures.end() ? nullptr : &*at;
  }
  /// Whether one of them makes the volume that is touched another than the scan.
  bool hasWalls() const {
    return std::ranges::any_of(structures,
                               [](const Watched& watched) { return watched.feel.isWall(); });
  }
};

/// The shell point that is nearest to a structure, and its distance [m]. The index is in the
/// shell's points; -1: none is nearer than `below`, which is the distance then.
struct NearestPoint {
  double distance = 0.0;
  int index = -1;
};
/// Of the tool at X_WT.
NearestPoint nearestPoint(const DistanceMap& map, const Scene& scene, const Pose& X_WT,
                          double below) HAPTICS_RT;

/// A least distance over the shell points that has no edges: where another point becomes the
/// nearest, it is rounded, and lies below the least by `rounding` at most. So its slope turns from
/// one point's to the next along a way, and does not jump.
struct RoundedLeast {
  double distance = 0.0;  ///< m
  Wrench slope;           ///< its gradient: along motions of the tool's origin, and turns about it
};
/// Of the tool at X_WT, where the nearest point is this one. It takes the points in one order
/// always, so it is a function of the pose alone. Beyond kMostRounded points that are about as near
/// it is the nearest's own distance.
RoundedLeast roundedLeast(const DistanceMap& map, const Scene& scene, const Pose& X_WT,
                          const NearestPoint& nearest, double rounding) HAPTICS_RT;
inline constexpr int kMostRounded = 2000;  ///< some 0.1 ms

/// Measures the distances of the tool at X_WP to every structure of the watch: of its tip, in the
/// tool frame [m], and the least over all of its points, which are in the tree; it leaves out those
/// that cannot be it. The same watch, tool and pose give the same bits.
void measure(const Watch& watch, const ShellTree& tree, const Vec3& tip, const Pose& X_WP,
             Nearnesses& measured) HAPTICS_RT;
inline void measure(const Watch& watch, const Scene& scene, const Pose& X_WP,
                    Nearnesses& measured) HAPTICS_RT {
  measure(watch, scene.tree, scene.tool.shell.tip, X_WP, measured);
}

}  // namespace haptics
