// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// Which of the poses that a tick visits the proxy may take: a filter over two measures of a pose,
/// its distance to the device (mass metric) and the length of the step that would still be made
/// from it. A pose is taken when no earlier one at this device position was as good in both. A
/// dozen poses may be taken that are not nearer the device; after that only nearer ones. The
/// memory clears when the device moves, however little, since what it holds are distances to it;
/// the dozen is given anew only when it has moved by more than it may tremble.
///
/// Taking only the nearest pose sticks and slips on real surfaces, since the direction of a step
/// (a smooth normal) and the distance (the facets of the field) disagree by microns; taking every
/// pose shakes at rest. The filter does neither.
class Acceptance {
 public:
  /// A tick begins. `still` [m]: what the device may tremble.
  void begin(const Pose& X_WD, double radius, double still) HAPTICS_RT {
    const Eigen::AngleAxisd turn{X_WD.linear() * X_WD_.linear().transpose()};
    const double motion =
        (X_WD.translation() - X_WD_.translation()).norm() + radius * std::abs(turn.angle());
    if (fresh_ || motion > still) {
      X_WD_ = X_WD;
      forget();
      fresh_ = false;
    } else if (X_WD.matrix() != X_WD_last_.matrix()) {
      visited_.clear();
      nearest_ = INFINITY;
    }
    X_WD_last_ = X_WD;
  }
  void forget() HAPTICS_RT {
    visited_.clear();
    detours_ = 0;
    nearest_ = INFINITY;
  }
  /// Whether a pose this far [m] from the device, with a step of this length [m] left to do, may
  /// be taken. What is told apart: `resolution` [m].
  bool take(double distance, double step, double resolution) HAPTICS_RT {
    // arrived: there is nothing better
    if (distance == 0.0) {
      nearest_ = 0.0;
      return true;
    }
    const bool nearer = distance < nearest_ - resolution;
    for (const Visit& earlier : visited_)
      if (distance > earlier.distance - resolution && step > earlier.step - resolution)
        return false;
    if (!nearer && (detours_ >= kDetours || visited_.full())) return false;
    if (!nearer) ++detours_;
    if (nearer) nearest_ = distance;
    visited_.push({distance, step});
    return true;
  }
  /// The pose that the tick starts from: taken already, by the last one.
  void start(double distance, double step) HAPTICS_RT {
    if (!visited_.empty()) return;
    visited_.push({distance, step});
    nearest_ = distance;
  }

 private:
  struct Visit {
    double distance = 0.0, step = 0.0;
  };
  static constexpr int kDetours = 12;
  FixedVector<Visit, 64> visited_;
  Pose X_WD_ = Pose::Identity();       ///< where the dozen was given
  Pose X_WD_last_ = Pose::Identity();  ///< in the last tick
  double nearest_ = INFINITY;
  int detours_ = 0;
  bool fresh_ = true;
};

}  // namespace haptics
