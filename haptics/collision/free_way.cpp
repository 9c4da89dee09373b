// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/collision/free_way.h"

#include <algorithm>

#include "haptics/collision/motion.h"

namespace haptics {
namespace {

constexpr std::int64_t kBoundWork = 2;    // of a look at the pyramid
constexpr double kRounding = 1.0 - 1e-9;  // of a stretch: what sums of stretches may lose

/// m around a place that are proven free of the solid; 0 where they are not.
double roomAt(const Isosurface& solid, const Vec3& p_W) HAPTICS_RT {
  const MaxPyramid::Bound bound =
      solid.field.pyramid().bound(solid.field.indexOf(p_W), solid.ceiling());
  return bound.lipschitz == 0.0 ? bound.radius : 0.0;
}

}  // namespace

double freeShareOf(const Isosurface& solid, const ShellTree& tree, const Pose& X_WP,
                   const Twist& motion, double least, Budget& budget) HAPTICS_RT {
  const double speed = motion.linear.norm(), turn = motion.angular.norm();
  const auto speedOf = [&](double arm) HAPTICS_RT { return speed + turn * arm; };
  const double farthest = speedOf(tree.nodes.front().arm);
  const int end = static_cast<int>(tree.nodes.size());
  double share = 0.0;
  while (share < 1.0) {
    const Pose X = moved(X_WP, motion, share);
    double stretch = 1.0 - share;
    // a node that allows the stretch does not shorten it, nor does anything below it
    const auto allows = [&](double room, double arm)
                            HAPTICS_RT { return room >= stretch * speedOf(arm); };
    int n = 0;
    while (n < end) {
      const ShellTree::Node& node = tree.nodes[static_cast<std::size_t>(n)];
      if (!budget.left()) return share;
      budget.spend(kBoundWork);
      if (allows(roomAt(solid, X * node.centre) - node.radius, node.arm)) {
        n = node.next;
        continue;
      }
      ++n;
      if (!node.leaf) continue;
      budget.spend(kBoundWork * node.count);
      for (int i = node.first; i < node.first + node.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double room = roomAt(solid, X * Vec3{tree.x[at], tree.y[at], tree.z[at]});
        if (!allows(room, tree.arm[at])) stretch = room / speedOf(tree.arm[at]);
        if (stretch * farthest < least) return share;
      }
    }
    share = stretch == 1.0 - share ? 1.0 : share + kRounding * stretch;
  }
  return share;
}

}  // namespace haptics
