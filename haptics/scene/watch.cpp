// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/watch.h"

#include <algorithm>

namespace haptics {
namespace {

/// From the tool's frame to indices of the samples.
struct ToSamples {
  ToSamples(const DistanceMap& map, const Pose& X_WT) HAPTICS_RT
      : turn{map.grid.spacing.cwiseInverse().asDiagonal() * map.grid.direction.transpose() *
             X_WT.linear()},
        origin{map.grid.indexOf(X_WT.translation())} {}
  Vec3 operator()(const Vec3& p_T) const HAPTICS_RT { return origin + turn * p_T; }
  Mat3 turn;
  Vec3 origin;
};

NearestPoint nearestOf(const DistanceMap& map, const ShellTree& tree, const ToSamples& to,
                       double below) HAPTICS_RT {
  NearestPoint nearest{below};
  const int end = static_cast<int>(tree.nodes.size());
  for (int n = 0; n < end;) {
    const ShellTree::Node& node = tree.nodes[std::size_t(n)];
    if (map.atIndex(to(node.centre)) - map.steepest * node.radius >= nearest.distance) {
      n = node.next;
      continue;
    }
    if (node.leaf)
      for (std::size_t i = std::size_t(node.first); i < std::size_t(node.first + node.count); ++i) {
        const double distance = map.atIndex(to({tree.x[i], tree.y[i], tree.z[i]}));
        if (distance < nearest.distance) nearest = {distance, tree.index[i]};
      }
    ++n;
  }
  return nearest;
}

}  // namespace

NearestPoint nearestPoint(const DistanceMap& map, const Scene& scene, const Pose& X_WT,
                          double below) HAPTICS_RT {
  return nearestOf(map, scene.tree, {map, X_WT}, below);
}

void measure(const Watch& watch, const ShellTree& tree, const Vec3& tip, const Pose& X_WP,
             Nearnesses& measured) HAPTICS_RT {
  measured.clear();
  for (const Watch::Watched& watched : watch.structures) {
    const DistanceMap& map = watched.distances;
    const ToSamples to{map, X_WP};
    const double of_tip = std::min(map.atIndex(to(tip)), map.told());
    const double nearest = nearestOf(map, tree, to, map.told()).distance;
    if (!measured.push({watched.structure, float(of_tip), float(nearest)})) break;
  }
}

}  // namespace haptics
