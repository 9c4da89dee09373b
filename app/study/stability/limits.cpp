// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/limits.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <set>
#include <unsupported/Eigen/MatrixFunctions>

#include "app/study/stability/presses.h"
#include "app/study/stability/stability.h"
#include "haptics/coupling/passivity.h"

namespace study::stability {
namespace {

using haptics::DeviceModel;
using haptics::Pose;
using haptics::Vec3;

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
class Shaking {
 public:
  /// The handle's place [m] and speed [m/s] at a time [s] since the arrival, in every period. Not
  /// true where there is nothing to go on with: a metre or a kilometre a second away, or no number.
  bool add(double time, double place, double speed) {
    lost_ = lost_ || !(std::abs(place) < 1.0 && speed < 1e3);
    if (time >= 0.25 * kPressTime && time < 0.5 * kPressTime) early_ += speed * speed;
    if (time >= 0.75 * kPressTime) late_ += speed * speed;
    if (time >= kPressTime - 0.2) {
      lowest_ = std::min(lowest_, place);
      highest_ = std::max(highest_, place);
    }
    return !lost_;
  }
  /// Up to two steps of the encoder [m] in amplitude are the encoder's own doing.
  Pressed result(double encoder, double energy) const {
    const double amplitude = lost_ ? INFINITY : 0.5 * (highest_ - lowest_);
    return {lost_ || (late_ > 0.9 * early_ && amplitude > 2.0 * encoder), amplitude, energy};
  }

 private:
  bool lost_ = false;
  double early_ = 0.0, late_ = 0.0, lowest_ = INFINITY, highest_ = -INFINITY;
};

/// The greatest growth in a period of the loop as a linear sampled system.
double spectralRadius(const Wall& wall, double stiffness) {
  // position and speed of the free device after a period, and what a held force adds: the
  // exponential of its differential equation
  const double m = wall.device.mass + wall.hand.mass;
  const double b = wall.device.damping + wall.hand.damping;
  const Eigen::Matrix3d rate{{0, 1, 0}, {-wall.hand.stiffness / m, -b / m, 1.0 / m}, {0, 0, 0}};
  const Eigen::Matrix3d free = (rate * wall.period).exp();
  // state: position, speed, position a period ago, forces under way (the oldest acts next)
  const int delay = wall.device.linkage.delay, n = 3 + delay;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::RowVectorXd force = Eigen::RowVectorXd::Zero(n);
  force(0) = -stiffness - wall.damping / wall.period;
  force(2) = wall.damping / wall.period;
  A.topLeftCorner<2, 2>() = free.topLeftCorner<2, 2>();
  A(2, 0) = 1.0;
  if (delay == 0) {
    A.topRows<2>() += free.topRightCorner<2, 1>() * force;
  } else {
    A.block<2, 1>(0, 3) = free.topRightCorner<2, 1>();
    for (int k = 3; k + 1 < n; ++k) A(k, k + 1) = 1.0;
    A.row(n - 1) = force;
  }
  return A.eigenvalues().cwiseAbs().maxCoeff();
}

/// The stiffness up to which all `holds`: from `least` to `most` [N/m] in steps of a ratio, since
/// beyond its limit a bouncing loop may be quiet again; then by bisection to `resolution`, a ratio
/// too.
template <class Holds>
Limit stiffestThatHolds(double least, double most, double step, double resolution, Holds&& holds) {
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
template <class Holds>
Limit limitAbout(const Wall& wall, Holds&& holds) {
  return stiffestThatHolds(0.2 * wall.theory(), 10.0 * wall.theory(), 1.05, 1.005, holds);
}

/// "1234", or "over 1234" where no limit was found.
std::string toWords(const Limit& limit) {
  return (limit.found ? "" : "over ") + shortly(limit.stiffness);
}

/// A diagram of measured over theoretical limit: a mark for each device, by its number in the table
/// of devices, and for each of `ways` too.
Plot limitPlot(const std::string& title, const std::string& ways, const std::string& more = "") {
  return {title,
          "One mark for each device, in the order of the table of devices, and " + ways +
              "; b counts device, hand and virtual damper. What is plain lies near 1" + more,
          {"device, by its number"},
          {"measured / theory", Scale::Log},
          {},
          kLeastOfTheory,
          "not below 0.85"};
}

std::string overTheory(const Wall& wall) {
  return "over 2 (b + b_hand) / T, with " + shortly(wall.totalDamping()) + " N s/m in all";
}

/// One way to run the loop on the wall.
struct Variant {
  std::size_t loop;  ///< its place in kLoops, apart from delay
  std::string name;
  Wall wall;
};
std::vector<Variant> variants(const Wall& plain, const std::vector<int>& delays) {
  std::vector<Variant> all;
  Wall late = plain, loose = plain, dry = plain;
  for (const int delay : delays)
    for (std::size_t loop = 0; loop < std::size(kLoops); ++loop) {
      const std::string periods = delay == 1 ? "a period" : std::to_string(delay) + " periods";
      late.device.linkage.delay = delay;
      all.push_back({loop, kLoops[loop].name + (delay > 0 ? ", " + periods + " late" : ""),
                     withLoop(late, kLoops[loop])});
    }
  loose.hand.damping = 2.0;
  dry.device.coulomb = kDryFriction;
  all.push_back({0, "loose hand", loose});
  all.push_back({0, "dry friction", dry});
  return all;
}

Outcome wallLimits(const DeviceModel& device, int number, double period,
                   const std::vector<int>& delays) {
  Findings found{"limit/" + device.name + "/" + rateOf(period)};
  std::vector<Plot>& plots = found.outcome.plots;
  for (const Loop& loop : kLoops)
    plots.push_back(limitPlot(std::string{"Measured limit over 2b / (T (1 + 2 delay)), "} +
                                  loop.name + ", " + rateOf(period),
                              "delay", "; the passivity controller lies above"));
  // dry friction beside the plain loop in time; what is not shipped is a row, no case
  double in_time = NAN;
  for (const auto& [loop, name, wall] : variants({device, {}, period}, delays)) {
    const bool controlled = wall.controller > 0.0, dry = wall.device.coulomb > 0.0;
    const Limit limit = measuredLimit(wall);
    const double measured = limit.stiffness, theory = wall.theory();
    const double linear = controlled || dry ? NAN : linearLimit(wall).stiffness;
    const auto isNear = [&, &name = name](double of, const std::string& why,
                                          const std::string& why_above) {
      found.atLeast(name, measured / of, kLeastOfTheory, "", why);
      found.atMost(name + ", from above", measured / of, 1.15, "", why_above);
    };
    if (name == "plain") {
      isNear(theory, overTheory(wall), overTheory(wall));
      in_time = measured;
    } else if (dry) {
      found.atLeast(
          name, measured / in_time, 0.95, "",
          "over the plain limit, with " + shortly(kDryFriction) + " N: what is dry only helps");
    } else if (!controlled && wall.damping == 0.0) {
      isNear(linear,
             "over the limit of the linear sampled system; theory " + shortly(theory) + " N/m",
             "a press that does not see the shaking would find no limit");
    }
    found.row("Measured limits of stiffness",
              {{"device", device.name},
               {"rate", rateOf(period)},
               {"loop", name},
               {"b + b_hand [N s/m]", shortly(wall.totalDamping())},
               {"measured [N/m]", toWords(limit)},
               {"2b/(T (1 + 2 delay)) [N/m]", shortly(theory)},
               {"linear [N/m]", std::isnan(linear) ? "" : shortly(linear)},
               {"measured / theory", shortly(measured / theory)},
               {"rated [N/m]", shortly(device.rating.stiffness)}});
    plots[loop].series.push_back({name, {{double(number), measured / theory}}, false});
  }
  if (period < 1e-3 || in_time == 0.0) return std::move(found.outcome);

  Plot& presses =
      found.plot("A press on a wall: " + device.name,
                 "Depth of the handle in the wall, at 0.8 of the measured limit, where what "
                 "the arrival set off dies, and at 1.2, where it is kept up",
                 {"time [s]"}, {"depth [mm]"});
  for (const double share : {0.8, 1.2}) {
    Series& series = presses.series.emplace_back(Series{shortly(share) + " of the limit", {}});
    int n = 0;
    pressOn({device, {}, period}, share * in_time, [&](double time, double depth) {
      if (n++ % 3 == 0 && time < 0.5) series.points.push_back({time, 1e3 * depth});
    });
  }
  return std::move(found.outcome);
}

Outcome planeLimits(const DeviceModel& device, int number, double period) {
  Findings found{"limit in 6-DOF/" + device.name + "/" + rateOf(period)};
  Plot& plot = found.outcome.plots.emplace_back(limitPlot(
      "Measured limit through the tick over 2b / T, " + rateOf(period), "way to run the loop"));
  for (const Loop& loop : kLoops) {
    const Wall wall = withLoop({device, {}, period}, loop);
    const Limit through_tick = planeLimit(wall), on_wall = measuredLimit(wall);
    const double limit = through_tick.stiffness, one = on_wall.stiffness, theory = wall.theory();
    // that of which 0.45 is allowed; what is not shipped is a row, no case
    if (&loop == &kLoops[0]) {
      found.atLeast(loop.name, limit / theory, kLeastOfTheory, "",
                    "over 2 (b + b_hand) / T = " + shortly(theory) + " N/m, with " +
                        shortly(wall.totalDamping()) + " N s/m in all; 0.45 of it is allowed");
      found.atLeast(
          loop.name + std::string{", over one degree of freedom"}, limit / one, kLeastOfTheory, "",
          "over what the same loop carries on a wall without a proxy, " + toWords(on_wall) +
              " N/m: the tick adds no lag, so no more than the 15 % of the theory may be lost");
    }
    found.row("Measured limits of stiffness in six degrees of freedom",
              {{"device", device.name},
               {"rate", rateOf(period)},
               {"loop", loop.name},
               {"b + b_hand [N s/m]", shortly(wall.totalDamping())},
               {"through the tick [N/m]", toWords(through_tick)},
               {"in one degree of freedom [N/m]", toWords(on_wall)},
               {"2b/T [N/m]", shortly(theory)},
               {"over one degree", shortly(limit / one)},
               {"over 2b/T", shortly(limit / theory)}});
    plot.series.push_back({loop.name, {{double(number), limit / theory}}, false});
  }
  return std::move(found.outcome);
}

}  // namespace

std::string rateOf(double period) { return shortly(1e-3 / period) + " kHz"; }

Wall withLoop(Wall plain, const Loop& loop) {
  plain.damping = loop.damping * plain.device.rating.damping;
  plain.controller = loop.controller * plain.device.rating.damping;
  return plain;
}

Pressed pressOn(const Wall& wall, double stiffness,
                const std::function<void(double, double)>& each) {
  haptics::Linkage linkage = wall.device.linkage;
  haptics::Grip grip = wall.device.heldBy(wall.hand, 0.03);
  grip.velocity.linear.z() = -kArrival;
  const double depth = kPressForce * (1.0 / wall.hand.stiffness + 1.0 / stiffness);
  const Pose X_WH = haptics::poseOf({0.0, 0.0, -depth}, haptics::Quat::Identity());

  haptics::PassivityController controller{wall.controller, grip.gyration, linkage.torque};
  haptics::PassivityObserver observer;
  haptics::Wrench held;
  Shaking shaking;
  Pose X_WD = linkage.read(grip.X_WD);
  const int ticks = int(std::lround(kPressTime / wall.period));
  bool going_on = true;
  for (int n = 0; n < ticks && going_on; ++n) {
    const double time = n * wall.period;
    const Pose X_WH_before = grip.X_WD, X_WD_before = X_WD;
    if (n > 0) grip.advance(X_WH, held, wall.period);
    observer.add(held, haptics::motionBetween(X_WH_before, grip.X_WD));
    X_WD = linkage.read(grip.X_WD);
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
  haptics::ClosedLoop loop = loopOf(wall, plane.scene, 0.0, stiffness, false);
  loop.grip.velocity.linear.z() = -kArrival;

  // from where the points would rest
  Pose X_start = plane.X_touch;
  X_start.translation().z() += plane.scene->lengths.rest_gap;
  Pose X_deep = X_start;
  X_deep.translation().z() -= std::min(kPressForce, 0.5 * wall.device.rating.force) *
                              (1.0 / wall.hand.stiffness + 1.0 / stiffness);
  const haptics::Hand hand = haptics::Hand::along({0.0, wall.period}, {X_start, X_deep}).value();

  Shaking shaking;
  double energy = 0.0;
  Vec3 before = X_start.translation();
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
  // small steps: near the limit a press now shakes on and now does not
  return stiffestThatHolds(0.7 * guess, 2.0 * guess, 1.03, 1.01,
                           [&](double stiffness) { return !pressOnPlane(wall, stiffness).fed; });
}

std::vector<Job> limitJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  const std::vector<int> delays = full ? std::vector<int>{0, 1, 2, 4} : std::vector<int>{0, 1};
  // a coarse encoder, torque motors, a light mass with little force
  const std::set<std::string> quick{"falcon", "sigma.7", "touch"};
  std::vector<Job> on_wall, through_tick;
  int number = 0;
  for (const DeviceModel& device : haptics::deviceModels()) {
    ++number;
    // the limits are of translation, in which an arm is nothing
    if (!device.linkage.arm.isZero(0.0)) continue;
    for (const double period : {1e-3, 0.25e-3}) {
      const std::string name = device.name + "/" + rateOf(period);
      on_wall.push_back(
          {"limit/" + name, "The stiffest wall", (period < 1e-3 ? 2.0 : 0.5) * (full ? 2.0 : 1.0),
           [=](std::uint64_t) { return wallLimits(device, number, period, delays); }});
      if (full || (quick.contains(device.name) && period == 1e-3))
        through_tick.push_back({"limit in 6-DOF/" + name, "The stiffest plane, through the tick",
                                period < 1e-3 ? 8.0 : 2.0, [=](std::uint64_t) {
                                  return planeLimits(device, number, period);
                                }});
    }
  }
  on_wall.insert(on_wall.end(), through_tick.begin(), through_tick.end());
  return on_wall;
}

}  // namespace study::stability
