// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "haptics/core/geometry.h"

namespace datasets::shapes {

/// What lies within a radius of a line, with round ends: a ball about one point, a rod between two,
/// a tube along more, whose corners are arcs. The distance is exact everywhere if each bend is
/// wider than the tube and fits between its neighbours.
class Tube {
 public:
  /// In metres. `bends`: the radius of the line at each corner, so two fewer than points.
  Tube(const std::vector<haptics::Vec3>& points, double radius,
       const std::vector<double>& bends = {})
      : radius_{radius} {
    haptics::Vec3 from = points.front();
    for (std::size_t n = 1; n + 1 < points.size(); ++n) {
      const haptics::Vec3& corner = points[n];
      const haptics::Vec3 in = (corner - from).normalized(),
                          out = (points[n + 1] - corner).normalized();
      const double bend = bends[n - 1], angle = std::acos(in.dot(out)),
                   cut = bend * std::tan(0.5 * angle);
      const haptics::Vec3 inward = (out - in.dot(out) * in).normalized();
      straights_.emplace_back(from, corner - cut * in);
      arcs_.push_back({corner - cut * in + bend * inward, -inward, in, bend, angle});
      from = corner + cut * out;
    }
    straights_.emplace_back(from, points.back());
  }

  double distance(const haptics::Vec3& p) const {
    double least = HUGE_VAL;
    for (const auto& [from, to] : straights_) {
      const haptics::Vec3 along = to - from;
      const double length2 = along.squaredNorm();
      const double t = length2 > 0.0 ? std::clamp((p - from).dot(along) / length2, 0.0, 1.0) : 0.0;
      least = std::min(least, (p - from - t * along).norm());
    }
    // beyond its ends an arc is no nearer than the straight parts there
    for (const Arc& arc : arcs_) {
      const haptics::Vec3 q = p - arc.centre;
      const double x = q.dot(arc.to_start), y = q.dot(arc.along), turned = std::atan2(y, x);
      if (turned >= 0.0 && turned <= arc.angle)
        least = std::min(
            least, std::hypot(std::hypot(x, y) - arc.radius, q.dot(arc.to_start.cross(arc.along))));
    }
    return least - radius_;
  }

 private:
  struct Arc {
    haptics::Vec3 centre, to_start, along;  ///< unit vectors, at its start
    double radius, angle;
  };
  std::vector<std::pair<haptics::Vec3, haptics::Vec3>> straights_;
  std::vector<Arc> arcs_;
  double radius_;
};

}  // namespace datasets::shapes
