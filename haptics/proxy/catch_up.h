// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/proxy/touch_constants.h"
#include "haptics/solver/mass_metric.h"

namespace haptics {

/// Largest speed [m/s] at which a released proxy approaches the device, for the coupling's
/// stiffness [N/m]. From 3000 N/m on, the force falls by 90 N per second (haptics/MEASURED.md,
/// "Release").
inline double releaseSpeed(double stiffness) HAPTICS_RT {
  const double softer = std::max(1.0, TouchConstants::kStiff / stiffness);
  return TouchConstants::kRelease / stiffness * softer * softer;
}

/// A part of the way since the last accepted pose. All of it is proven free.
struct Leg {
  Pose X = Pose::Identity();  ///< where it begins
  Twist motion;               ///< of which the tool went `advance`
  double advance = 0.0;
  Vec3 change = Vec3::Zero();  ///< m: by how much the centre's lag at X is less than behind_
  bool bears = false;          ///< contacts shaped the motion
};
/// Room for the 24 motions that a search tries at most, and for free stretches between them. With
/// more, the way is not known.
using Legs = FixedVector<Leg, 32>;

/// How a proxy that a surface held follows the device until it has caught up. Its *lag*, the motion
/// to the device, changes by what the hand's own motion makes of it, and by releaseSpeed() beside
/// that. Lengths are those of the metric, but for falls, which are of the centre alone: that is
/// what changes the force.
///
/// In contact a step may take the way of a whole millisecond at once, if the ticks before it did
/// not. A facet often meets the next one at a low ridge. The way of a shorter period may end on the
/// ridge, at a pose that the filter refuses, and the proxy would be held there.
class CatchUp {
 public:
  static constexpr std::size_t kRecent = 3;  ///< ticks before one within a millisecond, at most

  /// Begins a tick of a held proxy. `now`: its motion to the device, whose centre is at `p_WD`.
  /// `R`: its rotation.
  void begin(const Twist& now, const MassMetric& metric, const Mat3& R, const Vec3& p_WD,
             double stiffness, double period) HAPTICS_RT {
    const double time = period * (1 + ticks_behind_), speed = releaseSpeed(stiffness);
    const double rendered = TouchConstants::kMostReleased / stiffness;
    before_ = metric.whitened(behind_, R);
    const double distance = before_.norm();
    const double most = std::max(speed * time, distance - rendered);
    most_change_ = std::max(0.0, most + spare(speed, period));
    most_fall_ =
        std::max(TouchConstants::kMostFall / stiffness * time, behind_.linear.norm() - rendered);
    least_change_ = least_fall_ = std::numeric_limits<double>::infinity();
    // the hand may bring the two together faster by itself
    const double nearer = (before_ - metric.whitened(now, R)).dot(before_) / distance;
    left_ = std::max(0.0, 1.0 - std::max(most, nearer) / distance) * before_;
    released_ = 0.0;
    // a search that goes on has legs of earlier ticks
    for (Leg& leg : legs_) leg.change = behind_.linear - (p_WD - leg.X.translation());
  }
  /// Ends it. `lag`: the motion to the device now. `followed`: TickResult::followed.
  void end(const Twist& lag, bool followed) HAPTICS_RT {
    std::shift_right(recent_.begin(), recent_.end(), 1);
    // what a tick did not follow is counted by the one that does
    recent_.front() = followed ? released_ : 0.0;
    released_ = 0.0;
    if (followed) behind_ = lag;
    ticks_behind_ = followed ? 0 : ticks_behind_ + 1;
  }
  /// From contact on.
  void hold(const Twist& lag) HAPTICS_RT {
    forget();
    behind_ = lag;
  }
  /// The lag stays what it is; how fast it changed is forgotten.
  void forget() HAPTICS_RT {
    ticks_behind_ = 0;
    recent_ = {};
    released_ = 0.0;
    legs_known_ = false;
  }

  /// Looks at a pose with this lag, `whole` by the metric.
  void look(const Twist& lag, const Vector6& whole) HAPTICS_RT {
    change_ = before_ - whole;
    fall_ = behind_.linear - lag.linear;
  }
  /// The lag that is left in this tick even where nothing is in the way, by the metric.
  const Vector6& left() const HAPTICS_RT { return left_; }
  /// The share of a motion [by the metric] from the pose looked at that the lag allows.
  double shareOf(const Vector6& motion) const HAPTICS_RT {
    return shareWithin(most_change_, leastChange(motion), change_, motion);
  }
  /// Goes along a leg from the pose looked at, whose change it sets; `motion`: all of its way, by
  /// the metric. `first`: from the pose that was taken last.
  void go(Leg leg, const Vector6& motion, bool first) HAPTICS_RT {
    least_change_ = leastChange(motion);
    if (first) {
      legs_.clear();
      legs_known_ = true;
    }
    leg.change = fall_;
    legs_known_ = legs_known_ && legs_.push(leg);
  }
  /// The last leg went no further than this share of its motion.
  void shorten(double advance) HAPTICS_RT {
    if (legs_known_) legs_[legs_.size() - 1].advance = advance;
  }
  /// Takes the pose looked at.
  void take() HAPTICS_RT {
    released_ = std::sqrt(std::max(0.0, change_.squaredNorm() - leastChange(Vector6::Zero())));
  }

  /// The legs from the pose that was taken last to the one looked at.
  const Legs& legs() const HAPTICS_RT { return legs_; }
  struct Place {
    std::size_t leg = 0;
    double share = 0.0;  ///< of what the tool went along it
  };
  /// Where the force has changed by as much as it may on a leg that contacts shaped; none if it may
  /// change by what it does at the pose looked at.
  std::optional<Place> placeToWait() HAPTICS_RT {
    if (!legs_known_) return {};
    double least = least_fall_;
    for (const Leg& leg : legs_)
      least_fall_ = std::min(least_fall_, leastAlong(leg.change, wayOf(leg)));
    if (fall_.squaredNorm() <= least_fall_ + most_fall_ * most_fall_) return {};
    for (std::size_t n = 0; n < legs_.size(); ++n) {
      const Vec3 way = wayOf(legs_[n]);
      least = std::min(least, leastAlong(legs_[n].change, way));
      const double share = shareWithin(most_fall_, least, legs_[n].change, way);
      if (legs_[n].bears && share < 1.0) return Place{n, share};
    }
    return {};
  }

 private:
  static Vec3 wayOf(const Leg& leg) HAPTICS_RT { return leg.advance * leg.motion.linear; }
  /// How much more of the last millisecond's way the ticks before left to this one; less than
  /// nothing if they took more than theirs. What the ticks since behind_ may take is this one's.
  double spare(double speed, double period) const HAPTICS_RT {
    constexpr double kMillisecond = 1e-3;  // s
    double spare = 0.0, before = period;   // s: how long before the end of this tick
    for (std::size_t n = 0; n < kRecent && before < kMillisecond - 0.5 * period; ++n) {
      if (int(n) >= ticks_behind_) spare += speed * period - recent_[n];
      before += period;
    }
    return spare;
  }
  /// How little `change` comes to along a motion, squared.
  template <class V>
  static double leastAlong(const V& change, const V& motion) HAPTICS_RT {
    const double squares = motion.squaredNorm();
    const double nearest =
        squares > 0.0 ? std::clamp(-change.dot(motion) / squares, 0.0, 1.0) : 0.0;
    return (change + nearest * motion).squaredNorm();
  }
  /// The share of a motion after which `change` is more than it may be: `least` squared, as little
  /// as it was on the way, and `most` across that.
  template <class V>
  static double shareWithin(double most, double least, const V& change,
                            const V& motion) HAPTICS_RT {
    const double squares = motion.squaredNorm(), along = change.dot(motion);
    if (squares == 0.0) return 1.0;
    const double root = along * along - squares * (change.squaredNorm() - least - most * most);
    // a motion back to what was least is allowed, whatever the last bits of a root of 0 are
    if (root < -1e-9 * along * along) return 0.0;
    return std::clamp((std::sqrt(std::max(0.0, root)) - along) / squares, 0.0, 1.0);
  }
  /// The least of the change by the end of a motion from the pose looked at, squared.
  double leastChange(const Vector6& motion) const HAPTICS_RT {
    return std::min(least_change_, leastAlong(change_, motion));
  }

  Twist behind_;          ///< the lag after the last tick that followed
  int ticks_behind_ = 0;  ///< ticks since then
  /// By how much more than by the hand's motion the lag changed in the last ticks, the latest
  /// first.
  std::array<double, kRecent> recent_ = {};

  // of the tick under way
  Vector6 before_ = Vector6::Zero();           ///< behind_, by the metric
  Vector6 left_ = Vector6::Zero();             ///< left()
  double most_change_ = 0.0;                   ///< of its change, with the spare
  double least_change_ = 0.0;                  ///< squared
  Vector6 change_ = Vector6::Zero();           ///< at the pose looked at
  double released_ = 0.0;                      ///< by the pose taken
  double most_fall_ = 0.0, least_fall_ = 0.0;  ///< the second squared
  Vec3 fall_ = Vec3::Zero();                   ///< change of the centre's lag there
  Legs legs_;
  bool legs_known_ = false;  ///< all since the pose that was taken last
};

}  // namespace haptics
