// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/proxy/touch_constants.h"
#include "haptics/solver/mass_metric.h"
#include "haptics/solver/unconstrained_motion.h"

namespace haptics {

/// A filter that decides which of the poses that a tick visits the proxy takes. It has two measures
/// of a pose: the distance to the device (mass metric), and the length of the remaining step. A
/// pose is taken unless an earlier one at this device position was at least as good in both. Twelve
/// of the poses taken may be no nearer to the device than the nearest before (detours); after that
/// only nearer ones are taken. The memory holds distances to the device, so it clears whenever the
/// device moves.
///
/// A detour raises the energy of the coupling's spring, and the hand receives this energy. A detour
/// is taken only if earlier moves released as much, except for pull x tolerance / 2: a point that
/// lies too close is lifted to the rest gap before it slides on. A place to wait on the way to a
/// better pose may cost twice as much. So the total energy that the proxy gives to a hand that
/// stays is bounded. A single detour raises the energy by no more than pull x tolerance.
///
/// What a slide seems to release is not counted. In a tick the device moves first, against a force
/// that is held, and then the proxy follows. When the device moves by d across the pull, the spring
/// rises by |d|^2 / 2, and the proxy releases as much. But the held force does no work on that way,
/// so the hand has not paid for it. If the proxy follows in a later tick, the same holds for the
/// way of each tick by itself.
///
/// The proxy gets twelve new detours for each half of a tolerance that the device travels. Travel
/// is measured with play: the device drags an anchor once it is kPlay away from it. So a slide has
/// as many detours as it needs, and a handle that wanders about one place has twelve in all.
/// Without the play, detours would move the handle, and this motion would give new detours.
///
/// Travel across the pull also forgives 0.03 of the pull over its length of what detours raised
/// beyond what moves released. Otherwise a slow slide would stick and slip: normals and facets
/// disagree for a voxel at a time, and such a slide releases next to nothing. The hand receives
/// what is forgiven, as if the surface pushed it on with 0.03 of the pull at most. A press goes
/// along the pull, so nothing is forgiven in it.
///
/// Taking only the nearest pose sticks and slips on real surfaces, since the direction of a step
/// (a smooth normal) and the distance (the facets of the field) disagree by microns; taking every
/// pose shakes at rest. The filter does neither.
class PoseFilter {
 public:
  /// Begins a tick in which the proxy is at X_WP. `metric` is that of the distances. `radius` [m]
  /// converts a turn of the device [rad] to a length. `tolerance` [m] is that of contact, epsilon.
  void begin(const Pose& X_WD, const Pose& X_WP, const MassMetric& metric, double radius,
             double tolerance) HAPTICS_RT {
    tolerance_ = tolerance;
    if (fresh_) {
      X_WA_ = X_WD;
      forget();
      fresh_ = false;
    } else if (X_WD.matrix() != X_WD_.matrix()) {
      seem(X_WD, X_WP, metric);
      drag(X_WD, X_WP.translation() - X_WD.translation(), radius);
      clear();
    }
    X_WD_ = X_WD;
  }
  void forget() HAPTICS_RT {
    clear();
    detours_ = 0;
    travel_ = 0.0;
  }
  /// Whether to take a pose at `distance` [m] from the device (mass metric) with a remaining step
  /// of length `step` [m].
  bool take(double distance, double step) HAPTICS_RT {
    // the proxy has arrived
    if (distance == 0.0) {
      nearest_ = last_ = saved_ = 0.0;
      followed_ = true;
      return true;
    }
    if (!wouldTake(distance, step)) return false;
    keep(distance, step);
    return true;
  }
  /// Whether take() would take it.
  bool wouldTake(double distance, double step) const HAPTICS_RT {
    if (distance == 0.0) return true;
    if (!affords(distance, C::kLent)) return false;
    const double resolution = C::kResolution * tolerance_;
    for (const Visit& earlier : visited_)
      if (distance > earlier.distance - resolution && step > earlier.step - resolution)
        return false;
    return true;
  }
  /// Takes a pose on a proven way to one that take() would take, if it may wait there. Poses
  /// visited earlier do not count.
  bool takeOnTheWay(double distance, double step) HAPTICS_RT {
    if (!mayWait(distance)) return false;
    keep(distance, step);
    return true;
  }
  /// Whether the energy and the detours allow to wait at this distance, on such a way.
  bool mayWait(double distance) const HAPTICS_RT { return affords(distance, C::kLentToWait); }
  /// Records the pose at which the tick starts. The tick before has taken it.
  void start(double distance, double step) HAPTICS_RT {
    if (!visited_.empty()) return;
    visited_.push({distance, step});
    nearest_ = last_ = distance;
  }

 private:
  struct Visit {
    double distance = 0.0, step = 0.0;
  };
  using C = TouchConstants;

  bool nearer(double distance) const HAPTICS_RT {
    return distance < nearest_ - C::kResolution * tolerance_;
  }
  bool affords(double distance, double lent) const HAPTICS_RT {
    if (nearer(distance)) return true;
    const double farthest = nearest_ * (nearest_ + 2.0 * tolerance_);
    return riseTo(distance) <= saved_ + lent * tolerance_ * last_ &&
           distance * distance <= farthest && detours_ < C::kDetours && !visited_.full();
  }
  double riseTo(double distance) const HAPTICS_RT {
    return 0.5 * (distance * distance - last_ * last_);
  }
  void keep(double distance, double step) HAPTICS_RT {
    if (nearer(distance))
      nearest_ = distance;
    else
      ++detours_;
    followed_ = true;
    double released = -riseTo(distance);
    if (released > 0.0) {
      const double seeming = std::min(released, seeming_);
      seeming_ -= seeming;
      released -= seeming;
    }
    saved_ = std::min(saved_ + released, C::kMostSaved * tolerance_ * last_);
    last_ = distance;
    visited_.push({distance, step});
  }
  void clear() HAPTICS_RT {
    visited_.clear();
    nearest_ = INFINITY;
  }
  /// Finds how much the proxy seems to release as it follows the device across the pull.
  void seem(const Pose& X_WD, const Pose& X_WP, const MassMetric& metric) HAPTICS_RT {
    if (followed_) seeming_ = 0.0;
    followed_ = false;
    if (last_ == 0.0) return;
    const Mat3 R_WP = X_WP.linear();
    Vec3 turn = Vec3::Zero(), turned = Vec3::Zero();  // half a circle at most: a direction is asked
    const Vector6 pull = metric.whitened(unconstrainedMotion(X_WP, X_WD_, turn), R_WP);
    const Vector6 way = metric.whitened(unconstrainedMotion(X_WD_, X_WD, turned), R_WP);
    const double squared = pull.squaredNorm();
    if (squared == 0.0) return;
    const double along = way.dot(pull);
    seeming_ += 0.5 * std::max(0.0, way.squaredNorm() - along * along / squared);
  }
  /// Keeps the anchor within the play of the device.
  void drag(const Pose& X_WD, const Vec3& pull_W, double radius) HAPTICS_RT {
    const Vec3 way = X_WD.translation() - X_WA_.translation();
    const Eigen::AngleAxisd turn{X_WD.linear() * X_WA_.linear().transpose()};
    const double off = way.norm() + radius * std::abs(turn.angle());
    const double beyond = off - C::kPlay * tolerance_;
    if (beyond <= 0.0) return;
    const double share = beyond / off;
    X_WA_.translation() += share * way;
    X_WA_.linear() =
        Eigen::AngleAxisd{share * turn.angle(), turn.axis()}.toRotationMatrix() * X_WA_.linear();
    travel_ += beyond;
    const double squared = pull_W.squaredNorm();
    if (saved_ < 0.0 && squared > 0.0) {
      const Vec3 across = share * (way - way.dot(pull_W) / squared * pull_W);
      saved_ = std::min(0.0, saved_ + C::kForgiven * last_ * across.norm());
    }
    if (travel_ > C::kRenewal * tolerance_) forget();
  }

  FixedVector<Visit, 64> visited_;
  Pose X_WA_ = Pose::Identity();  ///< the anchor
  Pose X_WD_ = Pose::Identity();  ///< in the last tick
  double tolerance_ = 0.0;        ///< m
  double travel_ = 0.0;           ///< m, travel of the anchor since the last new detours
  double nearest_ = INFINITY;     ///< m
  double last_ = 0.0;             ///< m: distance of the pose taken last
  double saved_ = 0.0;            ///< m^2: spring energy that moves released, over the stiffness
  double seeming_ = 0.0;          ///< m^2: of what is released next, the part that is not counted
  bool followed_ = false;         ///< a pose was taken since the device moved
  int detours_ = 0;
  bool fresh_ = true;
};

}  // namespace haptics
