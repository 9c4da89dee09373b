// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/comparison/scenes.h"
#include "app/study/report/outcome.h"
#include "haptics/simulation/closed_loop.h"

/// Devices in a hand, in closed loop: on a wall of one degree of freedom, or through the tick.
namespace study::stability {

/// A device in a hand, pressed along z on a virtual wall z < 0: one degree of freedom and no
/// proxy, to find what the sampled loop by itself can carry.
struct Wall {
  haptics::DeviceModel device;  ///< its linkage's delay counts
  haptics::HumanHand hand = {};
  double period = 1e-3;     ///< s
  double damping = 0.0;     ///< N·s/m, virtual
  double controller = 0.0;  ///< N·s/m that the passivity controller may use; 0: none
  double lead = 0.0;        ///< s (servo/pose_predictor.h)

  haptics::ServoRate rate() const { return {int(std::lround(1.0 / period))}; }
  /// N·s/m: of device, hand and virtual damper.
  double totalDamping() const { return device.damping + hand.damping + damping; }
  /// s by which a force is late, less the lead.
  double lateness() const { return device.linkage.delay * period - lead; }
  /// 2 b / (T + 2 lateness) [N/m]: the limit of a sampled spring, to first order in b T / m. What a
  /// force is late adds to the half of a period that holding it costs.
  double theory() const {
    return 2.0 * totalDamping() / (period + 2.0 * std::max(0.0, lateness()));
  }
};

/// A device driven at a rate, by whatever carries its force: late by its rating's delay, and with
/// its lead.
inline Wall drivenAt(haptics::DeviceModel device, haptics::ServoRate rate) {
  device.linkage.delay = device.rating.delay / rate.period();
  const double lead = device.rating.lead;
  return {.device = std::move(device), .period = rate.period(), .lead = lead};
}
/// As the program drives it unless the user chooses another rate: at the highest of its link.
inline Wall asShipped(haptics::DeviceModel device) {
  const haptics::ServoRate rate = haptics::rateOf(device.rating);
  return drivenAt(std::move(device), rate);
}

/// What is added to the spring, as shares of the rated damping.
struct Loop {
  const char* name;
  const char* unguarded;  ///< its name where the guard of passivity is off
  double damping, controller;
};
/// Those that every limit is found for.
inline constexpr Loop kLoops[] = {
    {"plain", "no guard", 0.0, 0.0},
    {"virtual damping", "no guard, virtual damping", 0.25, 0.0},
    {"passivity controller", "no guard, passivity controller", 0.0, 1.0}};
inline Wall withLoop(Wall plain, const Loop& loop) {
  plain.damping = loop.damping * plain.device.rating.damping;
  plain.controller = loop.controller * plain.device.rating.damping;
  return plain;
}

/// "1 kHz".
inline std::string rateOf(double period) { return shortly(1e-3 / period) + " kHz"; }

/// What two seconds on the wall came to.
struct Pressed {
  bool fed = false;        ///< the shaking is kept up by the wall, and is not the encoder's own
  double amplitude = 0.0;  ///< m, half of the way between the extremes of the last 0.2 s
  double energy = 0.0;     ///< J given to the hand
};
/// The hand arrives and presses. `each` is told time [s] and depth [m] of every period.
Pressed pressOn(const Wall& wall, double stiffness,
                const std::function<void(double, double)>& each = {});
/// The same with everything in the loop: the tick with a plate of points on a half-space, six
/// degrees of freedom, the limits of the device, no more than half of the rated force.
Pressed pressOnPlane(const Wall& wall, double stiffness);

/// What a measured limit must be of the theory's, at least.
inline constexpr double kLeastOfTheory = 0.85;

/// How stiff a wall a loop carries [N/m]; 0 where not even the softest that was tried held.
struct Limit {
  double stiffness = 0.0;
  bool found = true;  ///< not: the stiffest that was tried held as well, so the limit lies above
};
/// The stiffness up to which the shaking dies, to 0.5 %; between a fifth and ten times of the
/// theory.
Limit measuredLimit(const Wall& wall);
/// The same from the spectral radius of the loop as a linear sampled system, without encoder, dry
/// friction and controller, and with a wall that pulls as well. Another way to the same figure.
Limit linearLimit(const Wall& wall);
/// The same through the tick, to 1 %, by most of three presses at each stiffness; between 0.7 and
/// twice of what the wall carries.
Limit planeLimit(const Wall& wall);

/// A way to run a loop.
struct Way {
  Wall wall;
  double stiffness;  ///< N/m
  /// As the program does: within the device's rating, with its ramp and the guard of passivity.
  /// False: within the rating, nothing else.
  bool shipped = false;
  const char* name = "";
};
/// The loop of a wall, touching a scene instead. As shipped, its angular stiffness is no more than
/// rated, as in a session.
haptics::ClosedLoop loopOf(const Way& way, std::shared_ptr<const haptics::Scene> scene,
                           double isovalue);

/// N/m: what the program allows to the device of this wall with a tool.
double allowedFor(const Wall& wall, const haptics::Scene& scene);

/// What a loop gives to the hand, against what is unavoidable and what is taken away, tick by tick.
///
/// A sampled spring gives K/2 times the square of the change of its stretch in a tick. One that is
/// d ticks late also gives K times that change times the d changes before it. Device and
/// hand take b/T times the square of the motion along the force. Up to the limit of a sampled
/// spring, K = 2 b / T, more is taken than given; beyond it a loop that shakes gives ever more.
struct EnergyBalance {
  double stiffness;  ///< N/m
  haptics::Grip grip;
  double period;                       ///< s
  double delay = 0.0;                  ///< ticks
  double most_given = 0.0;             ///< J
  double most_own = 0.0;               ///< J, beyond what sampling gives: the method's own share
  double most_left = 0.0;              ///< J, beyond what damping takes: what makes a loop shake
  double sampled = 0.0, damped = 0.0;  ///< J
  std::deque<haptics::Vector6> stretches = {haptics::Vector6::Zero()};  ///< m, the latest last

  /// `given` [J]: to the hand since the start. `motion`: the handle's since the last tick, while
  /// `held` acted. `stretch` [m]: of the spring now, by the tool's metric.
  void add(double given, const haptics::Wrench& held, const haptics::Twist& motion,
           const haptics::Vector6& stretch) {
    const haptics::Vector6 change = stretch - stretches.back();
    const int whole = int(delay);
    const double share = delay - whole;
    const haptics::Vector6 lag =
        stretches.back() - (1.0 - share) * ago(whole) - share * ago(whole + 1);
    sampled += stiffness * (0.5 * change.squaredNorm() + change.dot(lag));
    stretches.push_back(stretch);
    if (int(stretches.size()) > whole + 2) stretches.pop_front();
    const double force = held.force.norm(), torque = held.torque.norm();
    const double along = force > 0.0 ? motion.linear.dot(held.force) / force : 0.0;
    const double about =
        torque > 0.0 ? grip.gyration * motion.angular.dot(held.torque) / torque : 0.0;
    damped += grip.damping / period * (along * along + about * about);
    most_given = worse(most_given, given);
    most_own = worse(most_own, given - sampled);
    most_left = worse(most_left, given - damped);
  }
  /// The stretch so many ticks before the latest, or the first.
  const haptics::Vector6& ago(int ticks) const {
    return stretches[std::size_t(std::max(int(stretches.size()) - 1 - ticks, 0))];
  }
};

/// What a closed loop came to, whoever moves the hand.
struct LoopResult {
  double energy = 0.0;      ///< J given to the hand in all: spring let go, what is left was made
  double program = 0.0;     ///< J given by the program, at the tool as it reads and commands it
  double lost = 0.0;        ///< J that the torque of a force that no motor makes would have given
  double share = 1.0;       ///< of the stiffness that the guard of passivity left
  int non_finite = 0;       ///< ticks; all of them where the loop was refused
  int inside = 0;           ///< looks that found a shell point inside: one in ten ticks
  int looks = 0;            ///< at the shell, for that
  int contact = 0;          ///< ticks
  int cut = 0;              ///< ticks that the budget ended
  double force = 0.0;       ///< N, the largest
  double risen = 0.0;       ///< J by which the proxy's moves raised the spring, drops not counted
  double rise = 0.0;        ///< m, the largest in a tick: its energy over the spring's pull
  double amplitude = 0.0;   ///< m, of the handle while it is watched, half its range
  double force_step = 0.0;  ///< N, the largest in a tick of that time
  EnergyBalance balance = {};
  std::vector<PlotPoint> given = {};  ///< s; mJ given to the hand until then
  std::optional<haptics::Error> refused = {};
};
/// The hand, at another place if there is one, once the force has ramped in: what rises while
/// something is pressed gives energy by itself. A pose for every period, for so many seconds after
/// the wait [s]. `turns`: the handle's turns are sensed; else the tool keeps its own.
haptics::Hand waiting(const haptics::Hand& hand, const std::optional<haptics::Pose>& place,
                      double wait, double seconds, double period, bool turns = true);
/// Where a scene has the hand of a seed begin.
inline std::optional<haptics::Pose> placeOf(const comparison::Touched& touched,
                                            std::uint64_t seed) {
  return touched.place ? std::optional{touched.place(seed)} : std::nullopt;
}
/// Milliseconds of contact up to which they are counted: more says nothing about a case.
inline constexpr double kContactEnough = 200.0;
/// A hand that waits [s] and goes from corner to corner of a way, gently at each, by at most 30
/// mm/s.
haptics::Hand along(const std::vector<haptics::Vec3>& corners, double wait);
/// s that this takes, and a little longer for the device to follow.
double timeAlong(const std::vector<haptics::Vec3>& corners, double wait);
/// Runs a loop and watches the handle between two times [s]. `each` is called after every tick and
/// may change the loop's settings for the next.
LoopResult runLoop(haptics::ClosedLoop& loop, const haptics::Hand& hand, std::int64_t ticks,
                   double from = 0.0, double until = INFINITY,
                   const std::function<void(const haptics::TraceRow&)>& each = {});

/// A scene to press on: straight down to the first touch at `X_touch`, and from there no deeper
/// than `deepest` [m], for a ball is not to be pressed through.
struct Stage {
  std::shared_ptr<const haptics::Scene> scene;
  haptics::Pose X_touch;
  double deepest;
};

/// "plane": a flat square of points on a half-space; "groove": a rod in a V-groove; "ball": a ball
/// on a ball. Voxels of 1 mm, whose values ramp over six of them to the isovalue 0 and on, under
/// noise: a share of the ramp.
Stage makeStage(const std::string& name, double noise, unsigned seed);

/// A press: down at 60 mm/s at most, gently at both ends, held with about 2 N, or as much as the
/// stage's depth allows, until what that set off has died, and up again. The handle is watched in
/// the last 0.2 s of the hold. As shipped, the press waits for the ramp.
LoopResult press(const Way& way, const Stage& stage);

}  // namespace study::stability
