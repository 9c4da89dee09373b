// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/limits.h"

#include <cmath>
#include <set>

#include "app/study/stability/findings.h"
#include "app/study/stability/presses.h"
#include "app/study/stability/stability.h"

namespace study::stability {
namespace {

using haptics::DeviceModel;
using haptics::Pose;
using haptics::Vec3;

/// N of dry friction: what a light device of tendons has. Each device is tried without it, its
/// model's own, and with it.
constexpr double kDryFriction = 0.2;

/// A diagram of measured over theoretical limit: a mark for each device, by its number in the table
/// of devices.
Plot limitPlot(const std::string& title, const std::string& description) {
  return {title, description, {"device, by its number"}, {"measured / theory", Scale::Log},
          {},    0.85,        "not below 0.85"};
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
                              "One mark for each device, in the order of the table of devices, and "
                              "delay; b counts device, hand and virtual damper. What is plain lies "
                              "near 1; the passivity controller lies above"));
  // dry friction beside the plain loop in time; what is not shipped is a row, no case
  double in_time = NAN;
  for (const auto& [loop, name, wall] : variants({device, {}, period}, delays)) {
    const bool controlled = wall.controller > 0.0, dry = wall.device.coulomb > 0.0;
    const Limit limit = measuredLimit(wall);
    const double measured = limit.stiffness, theory = wall.theory();
    const double linear = controlled || dry ? NAN : linearLimit(wall);
    if (name == "plain") {
      found.atLeast(name, measured / theory, 0.85, "", overTheory(wall));
      found.atMost(name + ", from above", measured / theory, 1.15, "", overTheory(wall));
      in_time = measured;
    } else if (dry) {
      found.atLeast(
          name, measured / in_time, 0.95, "",
          "over the plain limit, with " + shortly(kDryFriction) + " N: what is dry only helps");
    } else if (!controlled && wall.damping == 0.0) {
      found.atLeast(
          name, measured / linear, 0.85, "",
          "over the limit of the linear sampled system; theory " + shortly(theory) + " N/m");
      found.atMost(name + ", from above", measured / linear, 1.15, "",
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

  // below the limit and above it
  Plot presses{"A press on a wall: " + device.name,
               "Depth of the handle in the wall, at 0.8 of the measured limit, where what the "
               "arrival set off dies, and at 1.2, where it is kept up",
               {"time [s]"},
               {"depth [mm]"}};
  for (const double share : {0.8, 1.2}) {
    Series series{shortly(share) + " of the limit", {}};
    int n = 0;
    pressOn({device, {}, period}, share * in_time, [&](double time, double depth) {
      if (n++ % 3 == 0 && time < 0.5) series.points.push_back({time, 1e3 * depth});
    });
    presses.series.push_back(std::move(series));
  }
  plots.push_back(std::move(presses));
  return std::move(found.outcome);
}

Outcome planeLimits(const DeviceModel& device, int number, double period) {
  Findings found{"limit in 6-DOF/" + device.name + "/" + rateOf(period)};
  Plot plot =
      limitPlot("Measured limit through the tick over 2b / T, " + rateOf(period),
                "One mark for each device, in the order of the table of devices, and way to run "
                "the loop; b counts device, hand and virtual damper. What is plain lies near 1");
  for (const Loop& loop : kLoops) {
    const Wall wall = withLoop({device, {}, period}, loop);
    const Limit through_tick = planeLimit(wall), on_wall = measuredLimit(wall);
    const double limit = through_tick.stiffness, one = on_wall.stiffness, theory = wall.theory();
    // that of which 0.45 is allowed; what is not shipped is a row, no case
    if (&loop == &kLoops[0]) {
      found.atLeast(loop.name, limit / theory, 0.85, "",
                    "over 2 (b + b_hand) / T = " + shortly(theory) + " N/m, with " +
                        shortly(wall.totalDamping()) + " N s/m in all; 0.45 of it is allowed");
      found.atLeast(
          loop.name + std::string{", over one degree of freedom"}, limit / one, 0.85, "",
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
  found.outcome.plots.push_back(std::move(plot));
  return std::move(found.outcome);
}

}  // namespace

std::string rateOf(double period) { return shortly(1e-3 / period) + " kHz"; }

Wall withLoop(Wall plain, const Loop& loop) {
  plain.damping = loop.damping * plain.device.rating.damping;
  plain.controller = loop.controller * plain.device.rating.damping;
  return plain;
}

Case limitCase(const DeviceModel& device, double period, int lag) {
  Wall wall{device, {}, period};
  const double theory = wall.theory();
  wall.device.linkage.delay += lag;
  return {"limit/" + device.name,
          measuredLimit(wall).stiffness / theory,
          0.85,
          "",
          Case::Sense::AtLeast,
          overTheory(wall)};
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
  Pressed pressed;
  Vec3 before = X_start.translation();
  const auto done =
      loop.run(hand, std::lround(kPressTime / wall.period), [&](const haptics::TraceRow& row) {
        const Vec3 place = row.X_WH.translation();
        shaking.add(row.time, place.z(), (place - before).norm() / wall.period);
        before = place;
        pressed.energy = row.energy;
        return !shaking.isLost();
      });
  pressed.amplitude = shaking.amplitude();
  pressed.fed = !done || shaking.isFed(wall.device.linkage.encoder);
  return pressed;
}

Limit planeLimit(const Wall& wall) {
  const double guess = measuredLimit(wall).stiffness;
  if (guess == 0.0) return {};
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
