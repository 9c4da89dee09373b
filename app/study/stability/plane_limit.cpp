// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/plane_limit.h"

#include <cmath>
#include <set>

#include "app/study/stability/limits.h"
#include "app/study/stability/presses.h"

namespace study::stability {
namespace {

using haptics::DeviceModel;
using haptics::Pose;
using haptics::Vec3;

const char* const kPlaneSection = "The stiffest plane, through the tick";

Outcome planeLimitsOf(const DeviceModel& device, int number, double period) {
  Outcome outcome;
  Table table{"Measured limits of stiffness in six degrees of freedom",
              {"device", "rate", "loop", "b + b_hand [N s/m]", "through the tick [N/m]",
               "in one degree of freedom [N/m]", "2b/T [N/m]", "over one degree", "over 2b/T"},
              {}};
  Plot plot =
      limitPlot("Measured limit through the tick over 2b / T, " + rateOf(period),
                "One mark for each device, in the order of the table of devices, and way to run "
                "the loop; b counts device, hand and virtual damper. What is plain lies near 1");
  for (const Loop& loop : kLoops) {
    const Wall wall = withLoop({device, {}, period}, loop);
    const Limit through_tick = planeLimit(wall), on_wall = measuredLimit(wall);
    const double limit = through_tick.stiffness, one = on_wall.stiffness, theory = wall.theory();
    const std::string name =
        "limit in 6-DOF/" + device.name + "/" + rateOf(period) + "/" + loop.name;
    // that of which 0.45 is allowed; what is not shipped is a row, no case
    if (&loop == &kLoops[0]) {
      outcome.cases.push_back({name, limit / theory, 0.85, "", Case::Sense::AtLeast,
                               "over 2 (b + b_hand) / T = " + shortly(theory) + " N/m, with " +
                                   shortly(wall.totalDamping()) +
                                   " N s/m in all; 0.45 of it is allowed"});
      outcome.cases.push_back(
          {name + ", over one degree of freedom", limit / one, 0.85, "", Case::Sense::AtLeast,
           "over what the same loop carries on a wall without a proxy, " + toWords(on_wall) +
               " N/m: the tick adds no lag, so no more than the 15 % of the theory may be lost"});
    }
    table.rows.push_back({device.name, rateOf(period), loop.name, shortly(wall.totalDamping()),
                          toWords(through_tick), toWords(on_wall), shortly(theory),
                          shortly(limit / one), shortly(limit / theory)});
    plot.series.push_back({loop.name, {{double(number), limit / theory}}, false});
  }
  outcome.tables.push_back(std::move(table));
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

}  // namespace

Pressed pressOnPlane(const Wall& wall, double stiffness) {
  static const Stage plane = makeStage("plane", 0.0, 1);
  haptics::ClosedLoop loop = loopOf(wall, plane.scene, plane.isovalue, stiffness, false);
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

std::vector<Job> planeLimitJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  // a coarse encoder, torque motors, a light mass with little force
  const std::set<std::string> quick{"falcon", "sigma.7", "touch"};
  std::vector<Job> jobs;
  int number = 0;
  for (const DeviceModel& device : haptics::deviceModels()) {
    ++number;
    // the limit is of translation, in which an arm is nothing
    if (!device.linkage.arm.isZero(0.0) || !(full || quick.contains(device.name))) continue;
    for (const double period : {1e-3, 0.25e-3})
      if (full || period == 1e-3)
        jobs.push_back({"limit in 6-DOF/" + device.name + "/" + rateOf(period), kPlaneSection,
                        period < 1e-3 ? 8.0 : 2.0,
                        [=](std::uint64_t) { return planeLimitsOf(device, number, period); }});
  }
  return jobs;
}

}  // namespace study::stability
