// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/watch.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

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

/// The search for the nearest of a tool's points.
class Nearest {
 public:
  Nearest(const DistanceMap& map, const ShellTree& tree, const ToSamples& to,
          double below) HAPTICS_RT : map_{map},
                                     tree_{tree},
                                     to_{to},
                                     found_{below} {}

  /// Calls f(point) for those that are nearer than `below`, in one order, until it returns false.
  template <class F>
  void forNearer(F&& f) HAPTICS_RT {
    for (int n = 0; n < static_cast<int>(tree_.nodes.size());) {
      const ShellTree::Node& node = tree_.nodes[std::size_t(n)];
      if (!mayHaveNearer(partAt(n), node)) {
        n = node.next;
        continue;
      }
      ++n;
      if (!node.leaf) continue;
      for (auto i = std::size_t(node.first); i < std::size_t(node.first + node.count); ++i) {
        const double distance = map_.atIndex(to_({tree_.x[i], tree_.y[i], tree_.z[i]}));
        if (distance < found_.distance && !f(NearestPoint{distance, tree_.index[i]})) return;
      }
    }
  }

  NearestPoint find() HAPTICS_RT {
    // down to the nearer child first: then most of the others cannot be nearer
    std::array<Part, 64> parts;  // one a level of the tree, and one
    std::size_t count = 0;
    if (!tree_.nodes.empty()) parts[count++] = partAt(0);
    while (count > 0) {
      const Part part = parts[--count];
      const ShellTree::Node& node = tree_.nodes[std::size_t(part.node)];
      if (!mayHaveNearer(part, node)) continue;
      if (node.leaf) {
        look(part, node);
        continue;
      }
      const int first = part.node + 1;
      Part near = partAt(first), far = partAt(tree_.nodes[std::size_t(first)].next);
      if (far.distance < near.distance) std::swap(near, far);
      parts[count++] = far;
      parts[count++] = near;
    }
    return found_;
  }

 private:
  struct Part {
    int node = 0;
    double distance = 0.0;  ///< of its centre
  };
  Part partAt(int n) const HAPTICS_RT {
    return {n, map_.atIndex(to_(tree_.nodes[std::size_t(n)].centre))};
  }
  /// On the way to a nearer place the distance falls below the least so far, and from there on the
  /// slope does not count: if that is outside, none inside does.
  double slope() const HAPTICS_RT {
    return found_.distance >= 0.0 ? map_.steepest_outside : map_.steepest;
  }
  bool mayHaveNearer(const Part& part, const ShellTree::Node& node) const HAPTICS_RT {
    return part.distance - slope() * node.radius < found_.distance;
  }
  /// Square of how far from a part's centre every nearer place is at least.
  double squareOfWay(const Part& part) const HAPTICS_RT {
    const double way = std::max(part.distance - found_.distance, 0.0) / slope();
    return way * way;
  }
  void look(const Part& part, const ShellTree::Node& leaf) HAPTICS_RT {
    double least = squareOfWay(part);
    for (auto i = std::size_t(leaf.first); i < std::size_t(leaf.first + leaf.count); ++i) {
      const Vec3 point(tree_.x[i], tree_.y[i], tree_.z[i]);
      if ((point - leaf.centre).squaredNorm() < least) continue;
      const double distance = map_.atIndex(to_(point));
      if (distance < found_.distance) {
        found_ = {distance, tree_.index[i]};
        least = squareOfWay(part);
      }
    }
  }

  const DistanceMap& map_;
  const ShellTree& tree_;
  const ToSamples& to_;
  NearestPoint found_;
};

}  // namespace

NearestPoint nearestPoint(const DistanceMap& map, const Scene& scene, const Pose& X_WT,
                          double below) HAPTICS_RT {
  return Nearest{map, scene.tree, ToSamples{map, X_WT}, below}.find();
}

RoundedLeast roundedLeast(const DistanceMap& map, const Scene& scene, const Pose& X_WT,
                          const NearestPoint& nearest, double rounding) HAPTICS_RT {
  const auto slopeAt = [&](int point) {
    const Vec3 arm = X_WT.linear() * scene.tool.shell.points[std::size_t(point)];
    const Vec3 gradient = map.gradientAt(X_WT.translation() + arm);
    return Wrench{.force = gradient, .torque = arm.cross(gradient)};
  };
  RoundedLeast least{.distance = std::numeric_limits<double>::infinity(), .slope = {}};
  int count = 0;
  // one that is farther than twice the rounding has no part in it
  const ToSamples to{map, X_WT};
  Nearest{map, scene.tree, to, nearest.distance + 2.0 * rounding}.forNearer(
      [&](const NearestPoint& point) {
        // the polynomial between the least so far and this one; its gradient is the mean of theirs
        const double share =
            std::clamp(0.5 + 0.5 * (least.distance - point.distance) / rounding, 0.0, 1.0);
        if (share == 1.0) {
          least = {point.distance, slopeAt(point.index)};
        } else if (share > 0.0) {
          const Wrench slope = slopeAt(point.index);
          least.distance =
              (1.0 - share) * (least.distance - share * rounding) + share * point.distance;
          least.slope.force += share * (slope.force - least.slope.force);
          least.slope.torque += share * (slope.torque - least.slope.torque);
        }
        return ++count < kMostRounded;
      });
  if (count < kMostRounded) return least;
  return {nearest.distance, slopeAt(nearest.index)};
}

void measure(const Watch& watch, const ShellTree& tree, const Vec3& tip, const Pose& X_WP,
             Nearnesses& measured) HAPTICS_RT {
  measured.clear();
  for (const Watch::Watched& watched : watch.structures) {
    const DistanceMap& map = watched.distances;
    const ToSamples to{map, X_WP};
    const double of_tip = std::min(map.atIndex(to(tip)), map.told());
    const double nearest = Nearest{map, tree, to, map.told()}.find().distance;
    if (!measured.push({watched.structure, float(of_tip), float(nearest)})) break;
  }
}

}  // namespace haptics
