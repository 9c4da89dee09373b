// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/watch.h"

#include <algorithm>

namespace haptics {
namespace {

/// The least distance of the tree's points, of those that are nearer than `least`. `X_MP`: from the
/// tool to the map's axes and samples.
double nearestOf(const DistanceMap& map, const ShellTree& tree, const Mat3& to_index,
                 const Vec3& origin, double least) HAPTICS_RT {
  const int end = static_cast<int>(tree.nodes.size());
  for (int n = 0; n < end;) {
    const ShellTree::Node& node = tree.nodes[std::size_t(n)];
    if (map.atIndex(origin + to_index * node.centre) - map.steepest * node.radius >= least) {
      n = node.next;
      continue;
    }
    if (node.leaf)
      for (std::size_t i = std::size_t(node.first); i < std::size_t(node.first + node.count); ++i)
        least =
            std::min(least, map.atIndex(origin + to_index * Vec3{tree.x[i], tree.y[i], tree.z[i]}));
    ++n;
  }
  return least;
}

}  // namespace

void measure(const Watch& watch, const Scene& scene, const Pose& X_WP,
             Nearnesses& measured) HAPTICS_RT {
  measured.clear();
  for (const Watch::Watched& watched : watch.structures) {
    const DistanceMap& map = watched.distances;
    const Mat3 to_index = map.grid.spacing.cwiseInverse().asDiagonal() *
                          map.grid.direction.transpose() * X_WP.linear();
    const Vec3 origin = map.grid.indexOf(X_WP.translation());
    const double tip = std::min(map.atIndex(origin + to_index * scene.tool.shell.tip), map.told());
    const double nearest = nearestOf(map, scene.tree, to_index, origin, map.told());
    if (!measured.push({watched.structure, float(tip), float(nearest)})) break;
  }
}

}  // namespace haptics
