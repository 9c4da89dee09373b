// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// Which of the poses that a tick visits the proxy may take: a filter over two measures of a pose,
/// its distance to the device (mass metric) and the length of the step that would still be made
/// from it. A pose is taken when no earlier one at this device position was as good in both. A
/// dozen poses may be taken that are not nearer the device (detours); after that only nearer ones.
/// The memory clears when the device moves, however little, since what it holds are distances to
/// it.
///
/// A detour raises the energy of the coupling's spring, which the hand then gets. It is taken only
/// if the moves before it let go of as much, but for half a tolerance of way against the spring's
/// pull: a point that came to lie too close is lifted to the rest gap before it slides on. So what
/// the proxy gives in all has a bound. A detour also rises by no more than a tolerance of way.
///
/// The dozen is given anew for each half of a tolerance that the device travels. Travel is counted
/// behind a play: an anchor is dragged along once the device is kPlay away from it. So a slide has
/// as many detours as it needs, and a handle that wanders about one place has a dozen in all.
/// Otherwise detours would move the handle, and its motion would give the next detours.
///
/// Taking only the nearest pose sticks and slips on real surfaces, since the direction of a step
/// (a smooth normal) and the distance (the facets of the field) disagree by microns; taking every
/// pose shakes at rest. The filter does neither.
class Acceptance {
 public:
  /// A tick begins. `radius` [m]: what a turn of the device counts by. `tolerance` [m]: of contact.
  void begin(const Pose& X_WD, double radius, double tolerance) HAPTICS_RT {
    tolerance_ = tolerance;
    if (fresh_) {
      X_WA_ = X_WD;
      forget();
      fresh_ = false;
    } else if (X_WD.matrix() != X_WD_.matrix()) {
      drag(X_WD, radius);
      clear();
    }
    X_WD_ = X_WD;
  }
  void forget() HAPTICS_RT {
    clear();
    detours_ = 0;
    travel_ = 0.0;
  }
  /// Whether a pose this far [m] from the device, with a step of this length [m] left to do, may
  /// be taken.
  bool take(double distance, double step) HAPTICS_RT {
    // arrived: there is nothing better
    if (distance == 0.0) {
      nearest_ = last_ = saved_ = 0.0;
      return true;
    }
    const double resolution = kResolution * tolerance_;
    const bool nearer = distance < nearest_ - resolution;
    const double squared = distance * distance, rise = 0.5 * (squared - last_ * last_);
    const double farthest = nearest_ * (nearest_ + 2.0 * tolerance_);
    if (!nearer && (rise > saved_ + kLent * tolerance_ * last_ || squared > farthest)) return false;
    for (const Visit& earlier : visited_)
      if (distance > earlier.distance - resolution && step > earlier.step - resolution)
        return false;
    if (!nearer && (detours_ >= kDetours || visited_.full())) return false;
    if (!nearer) ++detours_;
    if (nearer) nearest_ = distance;
    saved_ = std::min(saved_ - rise, kMostSaved * tolerance_ * last_);
    last_ = distance;
    visited_.push({distance, step});
    return true;
  }
  /// The pose that the tick starts from: taken already, by the last one.
  void start(double distance, double step) HAPTICS_RT {
    if (!visited_.empty()) return;
    visited_.push({distance, step});
    nearest_ = last_ = distance;
  }

 private:
  struct Visit {
    double distance = 0.0, step = 0.0;
  };
  static constexpr int kDetours = 12;
  // in tolerances:
  static constexpr double kResolution = 0.002;  // what is nearer by less is not nearer
  static constexpr double kPlay = 4.0;          // with less than 3, handles wander on noise of 10 %
  static constexpr double kRenewal = 0.5;       // of travel
  // of way against the pull: work of long ago pays for nothing now
  static constexpr double kMostSaved = 4.0;
  static constexpr double kLent = 0.5;  // of way against the pull

  void clear() HAPTICS_RT {
    visited_.clear();
    nearest_ = INFINITY;
  }
  /// Keeps the anchor within the play of the device.
  void drag(const Pose& X_WD, double radius) HAPTICS_RT {
    const Vec3 way = X_WD.translation() - X_WA_.translation();
    const Eigen::AngleAxisd turn{X_WD.linear() * X_WA_.linear().transpose()};
    const double off = way.norm() + radius * std::abs(turn.angle());
    const double beyond = off - kPlay * tolerance_;
    if (beyond <= 0.0) return;
    const double share = beyond / off;
    X_WA_.translation() += share * way;
    X_WA_.linear() =
        Eigen::AngleAxisd{share * turn.angle(), turn.axis()}.toRotationMatrix() * X_WA_.linear();
    travel_ += beyond;
    if (travel_ > kRenewal * tolerance_) forget();
  }

  FixedVector<Visit, 64> visited_;
  Pose X_WA_ = Pose::Identity();  ///< the anchor
  Pose X_WD_ = Pose::Identity();  ///< in the last tick
  double tolerance_ = 0.0;        ///< m
  double travel_ = 0.0;           ///< m, of the anchor, since the dozen was given
  double nearest_ = INFINITY;     ///< m
  double last_ = 0.0;             ///< m: of the pose taken last
  double saved_ = 0.0;            ///< m^2: spring energy that moves let go of, over the stiffness
  int detours_ = 0;
  bool fresh_ = true;
};

}  // namespace haptics
