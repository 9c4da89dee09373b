// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <set>
#include <unsupported/Eigen/MatrixFunctions>

#include "app/study/stability/failures.h"
#include "app/study/stability/loops.h"
#include "haptics/coupling/passivity.h"
#include "haptics/servo/pose_predictor.h"

namespace study::stability {
namespace {

using haptics::DeviceModel;

/// How long a press for a limit takes [s], how fast the hand arrives [m/s] and how hard it presses
/// [N].
constexpr double kPressTime = 2.0, kArrival = 0.05, kPressForce = 3.0;

/// N of dry friction: what a light device of tendons has. Each device is tried without it, its
/// model's own, and with it.
constexpr double kDryFriction = 0.2;

/// Tells whether a press shakes on. What decides is whether energy is kept up, not how much shakes
/// at the end, for a lightly damped device rings for long without being unstable: the mean kinetic
/// energy of the last half second is not a tenth below that of the half second a second earlier. (A
/// shaking that grows does so until the hand bounces off the wall, and stays.)
struct Shaking {
  bool lost = false;  ///< there is nothing to go on with
  double early = 0.0, late = 0.0, lowest = INFINITY, highest = -INFINITY;

  /// The handle's place [m] and speed [m/s] at a time [s] since the arrival, in every period. Not
  /// true where there is nothing to go on with: a metre or a kilometre a second away, or no number.
  bool add(double time, double place, double speed) {
    lost = lost || !(std::abs(place) < 1.0 && speed < 1e3);
    if (time >= 0.25 * kPressTime && time < 0.5 * kPressTime) early += speed * speed;
    if (time >= 0.75 * kPressTime) late += speed * speed;
    if (time >= kPressTime - 0.2) {
      lowest = std::min(lowest, place);
      highest = std::max(highest, place);
    }
    return !lost;
  }
  /// Up to two steps of the encoder [m] in amplitude are the encoder's own doing.
  Pressed result(double encoder, double energy) const {
    const double amplitude = lost ? INFINITY : 0.5 * (highest - lowest);
    return {lost || (late > 0.9 * early && amplitude > 2.0 * encoder), amplitude, energy};
  }
};

/// The greatest growth in a period of the loop as a linear sampled system.
double spectralRadius(const Wall& wall, double stiffness) {
  // position and speed of the free device after a period, and what a held force adds: the
  // exponential of its differential equation
  const double m = wall.device.mass + wall.hand.mass;
  const double b = wall.device.damping + wall.hand.damping;
  const Eigen::Matrix3d rate{{0, 1, 0}, {-wall.hand.stiffness / m, -b / m, 1.0 / m}, {0, 0, 0}};
  const Eigen::Matrix3d free = (rate * wall.period).exp();
  // state: position, speed, positions before (the last first), forces under way (the oldest acts
  // next)
  const double delay = wall.device.linkage.delay;
  const int window = wall.lead > 0.0 ? int(std::lround(1e-3 / wall.period)) : 0;
  const int under_way = int(std::ceil(delay)), first = 3 + window, n = first + under_way;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  // the place that the program takes it for, now and a period ago
  Eigen::RowVectorXd now = Eigen::RowVectorXd::Zero(n), before = now;
  const double share = wall.lead / 1e-3;
  now(0) = before(2) = 1.0 + share;
  now(window > 0 ? 1 + window : 0) -= share;
  before(2 + window) -= share;
  const Eigen::RowVectorXd force = -stiffness * now - wall.damping / wall.period * (now - before);
  A.topLeftCorner<2, 2>() = free.topLeftCorner<2, 2>();
  A(2, 0) = 1.0;
  for (int k = 3; k < first; ++k) A(k, k - 1) = 1.0;
  // what acts until the next period, of the forces of this one and of those before
  const int whole = int(delay);
  Eigen::RowVectorXd acts = Eigen::RowVectorXd::Zero(n);
  for (const auto& [ago, part] :
       {std::pair{whole, whole + 1.0 - delay}, std::pair{whole + 1, delay - whole}}) {
    if (ago == 0)
      acts += part * force;
    else if (ago <= under_way)
      acts(n - ago) += part;
  }
  A.topRows<2>() += free.topRightCorner<2, 1>() * acts;
  for (int k = first; k + 1 < n; ++k) A(k, k + 1) = 1.0;
  if (under_way > 0) A.row(n - 1) = force;
  return A.eigenvalues().cwiseAbs().maxCoeff();
}

/// The stiffness up to which all `holds`: from `least` to `most` [N/m] in steps of a ratio, since
/// beyond its limit a bouncing loop may be quiet again; then by bisection to `resolution`, a ratio
/// too.
Limit stiffestThatHolds(double least, double most, double step, double resolution,
                        const std::function<bool(double)>& holds) {
  if (!holds(least)) return {};
  double low = least, high = least;
  while (high == low) {
    if (low >= most) return {low, false};
    high = std::min(step * low, most);
    if (holds(high)) low = high;
  }
  while (high > resolution * low) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return {low, true};
}

/// Between a fifth and ten times of the theory, to 0.5 %.
Limit limitAbout(const Wall& wall, const std::function<bool(double)>& holds) {
  return stiffestThatHolds(0.2 * wall.theory(), 10.0 * wall.theory(), 1.05, 1.005, holds);
}

/// "1234", or "over 1234" where no limit was found.
std::string toWords(const Limit& limit) {
  return (limit.found ? "" : "over ") + shortly(limit.stiffness);
}

Outcome wallLimits(const DeviceModel& device, double period, const std::vector<int>& delays) {
  Findings found{"limit/" + device.name + "/" + rateOf(period)};
  double in_time = NAN;  // the limit of the plain loop
  const auto measure = [&](const Loop& loop, const std::string& name, const Wall& wall) {
    const Limit limit = measuredLimit(wall);
    const double measured = limit.stiffness, theory = wall.theory();
    const bool dry = wall.device.coulomb > 0.0;
    const double linear = loop.controller > 0.0 || dry ? NAN : linearLimit(wall).stiffness;
    if (name == "plain") in_time = measured;
    // what is not shipped is a row, no case
    if (dry) {
      found.atLeast(name, measured / in_time, 0.95, "",
                    "over the plain limit: what is dry only helps");
    } else if (loop.damping == 0.0 && loop.controller == 0.0) {
      const double ratio = measured / (name == "plain" ? theory : linear);
      found.atLeast(name, ratio, kLeastOfTheory, "",
                    name == "plain" ? "over 2 (b + b_hand) / T"
                                    : "over the limit of the linear sampled system");
      found.atMost(name + ", from above", ratio, 1.15, "",
                   "a press that does not see the shaking would find no limit");
    }
    found.row("Measured limits of stiffness",
              {{"device", device.name},
               {"rate", rateOf(period)},
               {"loop", name},
               {"b + b_hand [N s/m]", shortly(wall.totalDamping())},
               {"measured [N/m]", toWords(limit)},
               {"2b/(T + 2 lateness) [N/m]", shortly(theory)},
               {"linear [N/m]", std::isnan(linear) ? "" : shortly(linear)},
               {"measured / theory", shortly(measured / theory)},
               {"rated [N/m]", shortly(device.rating.stiffness)}});
  };
  const Wall plain{device, {}, period};
  Wall late = plain, loose = plain, dry = plain;
  for (const int delay : delays)
    for (const Loop& loop : kLoops) {
      late.device.linkage.delay = delay;
      const std::string periods = delay == 1 ? "a period" : std::to_string(delay) + " periods";
      measure(loop, loop.name + (delay > 0 ? ", " + periods + " late" : ""), withLoop(late, loop));
    }
  loose.hand.damping = 2.0;
  dry.device.coulomb = kDryFriction;
  measure(kLoops[0], "loose hand", loose);
  measure(kLoops[0], "dry friction", dry);
  if (period < 1e-3 || in_time == 0.0) return std::move(found.outcome);

  Plot& presses =
      found.plot("A press on a wall: " + device.name,
                 "Depth of the handle in the wall, at 0.8 of the measured limit, where what "
                 "the arrival set off dies, and at 1.2, where it is kept up",
                 {"time [s]"}, {"depth [mm]"});
  for (const double share : {0.8, 1.2}) {
    Series& series = presses.series.emplace_back(Series{shortly(share) + " of the limit", {}});
    int n = 0;
    pressOn(plain, share * in_time, [&](double time, double depth) {
      if (n++ % 3 == 0 && time < 0.5) series.points.push_back({time, 1e3 * depth});
    });
  }
  return std::move(found.outcome);
}

Outcome planeLimits(const DeviceModel& device, double period) {
  Findings found{"limit in 6-DOF/" + device.name + "/" + rateOf(period)};
  const auto measure = [&](const Loop& loop, const Wall& wall) {
    const double delay = wall.device.linkage.delay;
    const std::string name = loop.name +
                             (delay > 0.0 ? ", " + shortly(delay) + " late" : std::string{}) +
                             (wall.lead > 0.0 ? ", with a lead" : "");
    const Limit through_tick = planeLimit(wall), on_wall = measuredLimit(wall);
    const double limit = through_tick.stiffness, one = on_wall.stiffness, theory = wall.theory();
    // that of which 0.45 is allowed; what is not shipped is a row, no case
    if (&loop == &kLoops[0]) {
      found.atLeast(name, limit / theory, kLeastOfTheory, "",
                    wall.lead > 0.0 ? "over 2 (b + b_hand) / (T + 2 lateness), less the lead"
                                    : "over 2 (b + b_hand) / (T + 2 lateness); 0.45 of it is "
                                      "allowed");
      found.atLeast(name + ", over one degree of freedom", limit / one, kLeastOfTheory, "",
                    "over what the same loop carries on a wall without a proxy: the tick adds no "
                    "lag, so no more than the 15 % of the theory may be lost");
    }
    found.row("Measured limits of stiffness in six degrees of freedom",
              {{"device", device.name},
               {"rate", rateOf(period)},
               {"loop", name},
               {"b + b_hand [N s/m]", shortly(wall.totalDamping())},
               {"through the tick [N/m]", toWords(through_tick)},
               {"in one degree of freedom [N/m]", toWords(on_wall)},
               {"2b/(T + 2 lateness) [N/m]", shortly(theory)},
               {"over one degree", shortly(limit / one)},
               {"over theory", shortly(limit / theory)}});
  };
  for (const Loop& loop : kLoops) measure(loop, withLoop({device, {}, period}, loop));
  Wall late = drivenAt(device, Wall{device, {}, period}.rate());
  if (late.device.linkage.delay > 0) measure(kLoops[0], late);
  if (late.lead > 0.0) {
    late.lead = 0.0;
    measure(kLoops[0], late);
  }
  return std::move(found.outcome);
}

}  // namespace

Pressed pressOn(const Wall& wall, double stiffness,
                const std::function<void(double, double)>& each) {
  haptics::Linkage linkage = wall.device.linkage;
  haptics::Grip grip = wall.device.heldBy(wall.hand, 0.03);
  grip.velocity.linear.z() = -kArrival;
  const double depth = kPressForce * (1.0 / wall.hand.stiffness + 1.0 / stiffness);
  const Pose X_WH = at(0, 0, -depth);

  haptics::PassivityController controller{wall.controller, grip.gyration, linkage.torque};
  haptics::PassivityObserver observer;
  haptics::Wrench held;
  Shaking shaking;
  const std::int64_t period_ns = wall.rate().period_ns();
  haptics::PosePredictor ahead{wall.lead, linkage.encoder};
  Pose X_WD = ahead.ahead(linkage.read(grip.X_WD), 0);
  const int ticks = int(std::lround(kPressTime / wall.period));
  bool going_on = true;
  for (int n = 0; n < ticks && going_on; ++n) {
    const double time = n * wall.period;
    const Pose X_WH_before = grip.X_WD, X_WD_before = X_WD;
    if (n > 0) grip.advance(X_WH, held, wall.period);
    observer.add(held, haptics::motionBetween(X_WH_before, grip.X_WD));
    X_WD = ahead.ahead(linkage.read(grip.X_WD), n * period_ns);
    const haptics::Twist motion = haptics::motionBetween(X_WD_before, X_WD);

    haptics::Wrench wrench;
    const double z = X_WD.translation().z();
    if (z < 0.0) wrench.force.z() = -stiffness * z;
    wrench = haptics::damped(wrench, motion, wall.period, wall.damping, grip.gyration);
    if (wall.controller > 0.0) wrench = controller.pass(wrench, motion, wall.period);
    held = linkage.carry(wrench, grip.X_WD);

    const double place = grip.X_WD.translation().z();
    if (each) each(time, -place);
    going_on = shaking.add(time, place, grip.velocity.linear.norm());
  }
  return shaking.result(linkage.encoder, observer.energy());
}

Pressed pressOnPlane(const Wall& wall, double stiffness) {
  static const Stage plane = makeStage("plane", 0.0, 1);
  haptics::ClosedLoop loop = loopOf({wall, stiffness}, plane.scene, 0.0);
  loop.grip.velocity.linear.z() = -kArrival;

  // from where the points would rest
  const double rest = plane.scene->lengths.rest_gap;
  const double depth = std::min(kPressForce, 0.5 * wall.device.rating.force) *
                       (1.0 / wall.hand.stiffness + 1.0 / stiffness);
  const haptics::Hand hand =
      haptics::Hand::along({0.0, wall.period}, {at(0, 0, rest), at(0, 0, rest - depth)}).value();

  Shaking shaking;
  double energy = 0.0;
  Vec3 before{0, 0, rest};
  const auto done =
      loop.run(hand, std::lround(kPressTime / wall.period), [&](const haptics::TraceRow& row) {
        const Vec3 place = row.X_WH.translation();
        const double speed = (place - before).norm() / wall.period;
        before = place;
        energy = row.energy;
        return shaking.add(row.time, place.z(), speed);
      });
  if (!done) shaking.add(0.0, NAN, NAN);
  return shaking.result(wall.device.linkage.encoder, energy);
}

Limit measuredLimit(const Wall& wall) {
  return limitAbout(wall, [&](double stiffness) { return !pressOn(wall, stiffness).fed; });
}

Limit linearLimit(const Wall& wall) {
  return limitAbout(wall, [&](double stiffness) { return spectralRadius(wall, stiffness) < 1.0; });
}

Limit planeLimit(const Wall& wall) {
  const double guess = measuredLimit(wall).stiffness;
  if (guess == 0.0) return {};
  const auto shakesOn = [&](double stiffness) { return pressOnPlane(wall, stiffness).fed; };
  // one press may be kept up by the steps of a coarse encoder: most of three within 0.3 % decide
  const auto holds = [&](double stiffness) {
    const bool below = shakesOn(0.997 * stiffness), above = shakesOn(1.003 * stiffness);
    return below == above ? !below : !shakesOn(stiffness);
  };
  // small steps: near the limit a press now shakes on and now does not
  return stiffestThatHolds(0.7 * guess, 2.0 * guess, 1.03, 1.01, holds);
}

std::vector<Job> limitJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  const std::vector<int> delays = full ? std::vector<int>{0, 1, 2, 4} : std::vector<int>{0, 1};
  // a coarse encoder, torque motors, a light mass with little force
  const std::set<std::string> quick{"falcon", "sigma.7", "touch"};
  std::vector<Job> on_wall, through_tick;
  for (const DeviceModel& device : haptics::deviceModels()) {
    // the limits are of translation, in which an arm is nothing
    if (!device.linkage.arm.isZero(0.0)) continue;
    for (const double period : {1e-3, 0.5e-3, 0.25e-3}) {
      // the quick form has every device at 1 kHz, some at 4 kHz, and one between
      if (!full && (period == 0.5e-3 ? device.name != "sigma.7"
                                     : period == 0.25e-3 && !quick.contains(device.name)))
        continue;
      const std::string name = device.name + "/" + rateOf(period);
      on_wall.push_back({"limit/" + name, "The stiffest wall",
                         (period < 1e-3 ? 2.0 : 0.5) * (full ? 2.0 : 1.0),
                         [=](std::uint64_t) { return wallLimits(device, period, delays); }});
      if (full || (quick.contains(device.name) && period == 1e-3))
        through_tick.push_back({"limit in 6-DOF/" + name, "The stiffest plane, through the tick",
                                period < 1e-3 ? 8.0 : 2.0,
                                [=](std::uint64_t) { return planeLimits(device, period); }});
    }
  }
  on_wall.insert(on_wall.end(), through_tick.begin(), through_tick.end());
  return on_wall;
}

}  // namespace study::stability
