// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// The motion that leads from one pose to another: translation, and rotation vector in W.
Twist motionBetween(const Pose& X_from, const Pose& X_to) HAPTICS_RT;

/// Sums the energy that the program gives to the hand [Hannaford 2002]. A wrench is held between
/// two ticks. So the work of its force is exactly force · translation, and the work of its torque
/// is torque · turn if the axis of the turn is constant in the tick. No velocity is estimated.
///
/// A passive environment that begins at rest has `energy` <= 0. The potential energy of a pressed
/// spring counts as taken.
class PassivityObserver {
 public:
  /// `held`: the wrench on the hand since the last tick, `motion`: the device's since then. Numbers
  /// that are not finite are not counted.
  void add(const Wrench& held, const Twist& motion) HAPTICS_RT;
  double energy() const HAPTICS_RT { return energy_; }  ///< J, given less taken

 private:
  double energy_ = 0.0;  ///< J
};

/// Damps the hand while the program has given more energy than it took: the time-domain passivity
/// controller of [Hannaford 2002] in six degrees of freedom. The damping is b in translation and b
/// times the square of a gyration radius in rotation. Directions that the device cannot actuate
/// are neither damped nor counted.
class PassivityController {
 public:
  /// `most_damping` [N·s/m]: more would amplify the encoder's noise. `gyration` [m].
  PassivityController(double most_damping, double gyration, bool torque)
      : most_damping_{most_damping}, gyration_{gyration}, torque_{torque} {}

  /// What to send instead of `wanted`. `motion`: of the device since the last tick, while the
  /// wrench that this returned then (or `sent`) was held.
  Wrench pass(const Wrench& wanted, const Twist& motion, double period) HAPTICS_RT;
  /// The wrench that was sent, if limits changed it after `pass`.
  void sent(const Wrench& wrench) HAPTICS_RT { held_ = wrench; }

  const PassivityObserver& observer() const HAPTICS_RT { return observer_; }

 private:
  double most_damping_, gyration_;
  bool torque_;
  PassivityObserver observer_;
  Wrench held_;
};

/// Detects a loop that shakes the hand, and lowers the stiffness.
///
/// A sampled spring generates K |d|^2 / 2 in every tick in which the device moved by d. If the
/// hand's damping does not absorb this energy, the loop shakes at 20 Hz to a few hundred Hz. So the
/// guard sums the work of the held wrench above 20 Hz, over the last 0.1 s. Pressing, sliding and
/// releasing are slower, and an impact reverses only once or twice. If the work is more than
/// 0.6 mJ, the motion has reversed six times and does not decay by itself, the guard lowers the
/// stiffness by a fifth: at most once in 20 ms, and to no less than a fifth of the set value. The
/// stiffness returns when the user arms again or sets another stiffness.
///
/// On a wall the guard does not act below two thirds of the limit of a sampled spring. Near the
/// limit a spring rings for long, and the guard may act. Other shaking, such as a hard tap that
/// bounces, has the same effect.
class PassivityGuard {
 public:
  struct Memory {
    Pose X_WD = Pose::Identity();  ///< in the last tick
    bool begun = false;
    double waited = 0.0;        ///< s since the device last moved
    Twist slow_motion;          ///< motion of the hand in a tick, below 20 Hz
    Wrench slow_wrench;         ///< below 20 Hz
    double made = 0.0;          ///< J, of the last 0.1 s
    double turns = 0.0;         ///< reversals in the last 0.1 s
    double power = 0.0;         ///< J a tick of alternating work, over the last 0.05 s
    double power_before = 0.0;  ///< the same over the last 0.2 s
    double direction = 0.0;     ///< -1 or 1: against or with the wrench
    double since = 0.0;         ///< s since the stiffness was lowered
    double share = 1.0;         ///< share of the set stiffness that is used
  };

  explicit PassivityGuard(const Memory& memory) : at_{memory} {}
  /// `held`: the wrench on the hand since the last tick; X_WD: the device now; `scale`: m in W for
  /// each m of the hand. Numbers that are not finite are not counted.
  void add(const Wrench& held, const Pose& X_WD, double scale, double period) HAPTICS_RT;
  const Memory& memory() const HAPTICS_RT { return at_; }

 private:
  Memory at_;
};

/// The wrench plus a viscous one, unless the wrench is zero: `damping` [N·s/m], times the square
/// of `gyration` [m] in rotation. The velocity is the motion over the last period.
Wrench damped(const Wrench& wrench, const Twist& motion, double period, double damping,
              double gyration) HAPTICS_RT;

}  // namespace haptics
