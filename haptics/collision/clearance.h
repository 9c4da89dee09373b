// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/field/isosurface.h"
#include "haptics/tool/point_shell.h"

namespace haptics {

/// A shell point close enough to the surface to matter, as it was found.
struct NearPoint {
  int point = 0;
  Vec3 r_W;            ///< about the tool's origin [m]
  Vec3 u;              ///< index coordinates
  double value = 0.0;  ///< F there
  double free = 0.0;   ///< m it may move in any direction: proven
  Vec3 gradient_W;     ///< of its cell, per metre
};

/// How far each shell point can go before it could possibly meet the surface: proven by the
/// pyramid's bounds, and spent by motion. A point whose clearance is not used up is not looked at,
/// tick after tick.
class Clearance {
 public:
  explicit Clearance(std::size_t points) : until_(points, 0.0), near_(points) {}

  /// Nothing is known any more: the isovalue or the pose changed by other means than motion.
  void forget() HAPTICS_RT;
  /// The tool has moved by at most this along any path.
  void moved(double translation, double rotation) HAPTICS_RT {
    translated_ += translation;
    rotated_ += rotation;
  }

  enum class Verdict { Legal, Inside, Cut };
  /// Finds all points with less than `reach` [m] of clearance at this pose, into near(). Inside at
  /// the first one at or beyond the ceiling; Cut if the budget ran out: near() is then not
  /// complete.
  Verdict collect(const Isosurface& solid, const PointShell& shell, const Pose& X_WP, double reach,
                  Budget& budget) HAPTICS_RT;

  std::size_t size() const HAPTICS_RT { return found_; }
  const NearPoint& near(std::size_t i) const HAPTICS_RT { return near_[i]; }

 private:
  std::vector<double> until_;    ///< clearance plus what had been travelled when it was proven
  double translated_ = 0.0;      ///< m, since forget()
  double rotated_ = 0.0;         ///< rad
  std::vector<NearPoint> near_;  ///< the first found_ are valid; room for every point
  std::size_t found_ = 0;
};

}  // namespace haptics
