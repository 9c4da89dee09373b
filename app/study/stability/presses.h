// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "app/study/stability/limits.h"
#include "haptics/simulation/closed_loop.h"
#include "haptics/solver/mass_metric.h"

namespace study::stability {

/// A way to run a loop, by name.
struct Way {
  const char* loop;
  Wall wall;
  double stiffness;  ///< N/m
  bool shipped = false;
};

/// The loop of a wall, touching a scene instead, as the program ships it: within the device's
/// rating, with its ramp and the guard of passivity. Not `shipped`: within the rating, nothing
/// else.
haptics::ClosedLoop loopOf(const Wall& wall, std::shared_ptr<const haptics::Scene> scene,
                           double isovalue, double stiffness, bool shipped = true);

/// What a closed loop came to, whoever moves the hand.
struct LoopResult {
  double energy = 0.0;  ///< J given to the hand in all: spring let go, what is left was made
  double share = 1.0;   ///< of the stiffness that the guard of passivity left
  int non_finite = 0;   ///< ticks; all of them where the loop was refused
  int inside = 0;       ///< looks that found a shell point inside
  int contact = 0;      ///< ticks
  std::optional<haptics::Error> refused = {};
};
/// Runs a loop, looks at the shell every `look` ticks, and tells `each` every row and the one
/// before, which is null for the first.
LoopResult runLoop(
    haptics::ClosedLoop& loop, const haptics::Hand& hand, std::int64_t ticks, int look,
    const std::function<void(const haptics::TraceRow&, const haptics::TraceRow*)>& each);

/// What a loop gives to the hand, against what is unavoidable and what is taken away, tick by tick.
///
/// A sampled spring gives K/2 times the square of the change of its stretch in a tick. Device and
/// hand take b/T times the square of the motion along the force. Up to the limit of a sampled
/// spring, K = 2 b / T, more is taken than given; beyond it a loop that shakes gives ever more.
struct EnergyBalance {
  double stiffness;  ///< N/m
  haptics::Grip grip;
  double period;                       ///< s
  double most_given = 0.0;             ///< J
  double most_own = 0.0;               ///< J, beyond what sampling gives: the method's own share
  double most_left = 0.0;              ///< J, beyond what damping takes: what makes a loop shake
  double sampled = 0.0, damped = 0.0;  ///< J
  haptics::Vector6 stretch_before = haptics::Vector6::Zero();

  /// `given` [J]: to the hand since the start. `motion`: the handle's since the last tick, while
  /// `held` acted. `stretch` [m]: of the spring now, by the tool's metric.
  void add(double given, const haptics::Wrench& held, const haptics::Twist& motion,
           const haptics::Vector6& stretch) {
    sampled += 0.5 * stiffness * (stretch - stretch_before).squaredNorm();
    stretch_before = stretch;
    const double force = held.force.norm(), torque = held.torque.norm();
    const double along = force > 0.0 ? motion.linear.dot(held.force) / force : 0.0;
    const double about =
        torque > 0.0 ? grip.gyration * motion.angular.dot(held.torque) / torque : 0.0;
    damped += grip.damping / period * (along * along + about * about);
    most_given = worse(most_given, given);
    most_own = worse(most_own, given - sampled);
    most_left = worse(most_left, given - damped);
  }
};

/// N/m: what the program allows to the device of this wall with a tool.
double allowedFor(const Wall& wall, const haptics::Scene& scene);

/// A scene to press on: straight down to the first touch at `X_touch`, and from there no deeper
/// than `deepest` [m], for a ball is not to be pressed through.
struct Stage {
  std::shared_ptr<const haptics::Scene> scene;
  haptics::Pose X_touch;
  double deepest = INFINITY;
};

/// "plane": a flat square of points on a half-space; "groove": a rod in a V-groove; "ball": a ball
/// on a ball. Voxels of 1 mm, whose values ramp over six of them to the isovalue 0 and on, under
/// noise: a share of the ramp.
Stage makeStage(const std::string& name, double noise, unsigned seed);

/// What a press came to: down at 60 mm/s at most, gently at both ends, held with about 2 N, or as
/// much as the stage's depth allows, until what that set off has died, and up again.
struct PressResult : LoopResult {
  double amplitude = 0.0;   ///< m, of the handle in the last 0.2 s of the hold, half its range
  double force_step = 0.0;  ///< N, the largest in a tick of that time
  double risen = 0.0;       ///< J by which the proxy's moves raised the spring, drops not counted
  double rise = 0.0;        ///< m, the largest in a tick: its energy over the spring's pull
};

/// `shipped`: as in loopOf; the press then waits for the ramp.
PressResult press(const Wall& wall, const Stage& stage, double stiffness, bool shipped = true);

}  // namespace study::stability
