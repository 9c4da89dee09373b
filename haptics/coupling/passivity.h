// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// The motion that leads from one pose to another: translation, and rotation vector in W.
Twist motionBetween(const Pose& X_from, const Pose& X_to) HAPTICS_RT;

/// Adds up the energy that the program gives to the hand. A wrench is held between two ticks, so
/// the work of its force is exactly force · translation, whatever happens in between, and that of
/// its torque is torque · turn as far as the turn of a tick keeps its axis; no velocity has to be
/// guessed [Hannaford 2002].
///
/// A passive environment, at rest at first, has never given more than it took: `energy` <= 0. The
/// potential that a pressed spring holds is energy taken.
class PassivityObserver {
 public:
  /// `held`: the wrench on the hand since the last tick, `motion`: the device's since then. What is
  /// not finite is not counted.
  void add(const Wrench& held, const Twist& motion) HAPTICS_RT;
  double energy() const HAPTICS_RT { return energy_; }  ///< J, given less taken

 private:
  double energy_ = 0.0;  ///< J
};

/// Takes back what the program gave too much, by damping the hand as hard as it needs and no
/// longer: the time-domain passivity controller of [Hannaford 2002] in six degrees of freedom. The
/// damping is b in translation and b times the square of a gyration radius in rotation; along
/// what the device cannot actuate it does not act, and nothing is counted.
class PassivityController {
 public:
  /// `most_damping` [N·s/m]: more would rattle on the encoder's noise. `gyration` [m].
  PassivityController(double most_damping, double gyration, bool torque)
      : most_damping_{most_damping}, gyration_{gyration}, torque_{torque} {}

  /// What to send in place of `wanted`. `motion` of the device since the last tick, through which
  /// the wrench that this returned then (or what the limits left of it, see `sent`) was held.
  Wrench pass(const Wrench& wanted, const Twist& motion, double period) HAPTICS_RT;
  /// What was really sent, if limits came after `pass`.
  void sent(const Wrench& wrench) HAPTICS_RT { held_ = wrench; }

  const PassivityObserver& observer() const HAPTICS_RT { return observer_; }

 private:
  double most_damping_, gyration_;
  bool torque_;
  PassivityObserver observer_;
  Wrench held_;
};

/// Finds a loop that gives the hand energy by shaking it, and lowers the stiffness before the
/// hand takes it for the surface.
///
/// A sampled spring gives K |d|^2 / 2 for every tick in which the device moved by d, more than it
/// took; a hand's own damping takes that away, or the loop builds up a shaking between 20 Hz and a
/// few hundred. So what is counted is the work of the held wrench above 20 Hz only, over the last
/// 0.1 s: pressing, sliding and letting go are slower, and an impact turns round but once or
/// twice. Where it is more than 0.6 mJ, the motion has turned six times and is not dying
/// away by itself, a fifth of the stiffness is taken away, at most once in 20 ms and down to a
/// fifth of what was set, and is not given back until the user arms again or sets another
/// stiffness. Up to two thirds of the limit of a sampled spring nothing is taken away on a wall;
/// near it a spring rings for long, and may be lowered. What shakes for another reason, a hard tap
/// that bounces, say, is taken for it too.
class PassivityGuard {
 public:
  struct Memory {
    Pose X_WD = Pose::Identity();  ///< at the last tick
    bool begun = false;
    double waited = 0.0;        ///< s since it last moved
    Twist slow_motion;          ///< of the hand in a tick, below 20 Hz
    Wrench slow_wrench;         ///< below 20 Hz
    double made = 0.0;          ///< J, of the last 0.1 s
    double turns = 0.0;         ///< likewise
    double power = 0.0;         ///< J in a tick that goes to and fro, of the last 0.05 s
    double power_before = 0.0;  ///< and of the last 0.2 s
    double direction = 0.0;     ///< -1 or 1: against or with the wrench
    double since = 0.0;         ///< s since the stiffness was lowered
    double share = 1.0;         ///< of the stiffness that is left
  };

  explicit PassivityGuard(const Memory& memory) : at_{memory} {}
  /// `held`: the wrench on the hand since the last tick; X_WD: the device now; `scale`: m in W for
  /// each m of the hand. What is not finite is not counted.
  void add(const Wrench& held, const Pose& X_WD, double scale, double period) HAPTICS_RT;
  const Memory& memory() const HAPTICS_RT { return at_; }

 private:
  Memory at_;
};

/// The wrench with a viscous one added while it is felt at all: `damping` [N·s/m], times the
/// square of `gyration` [m] in rotation. A velocity is the motion over the last period.
Wrench damped(const Wrench& wrench, const Twist& motion, double period, double damping,
              double gyration) HAPTICS_RT;

}  // namespace haptics
