// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/limits.h"

#include <cmath>

namespace study::stability {
namespace {

using haptics::DeviceModel;

const char* const kWallSection = "The stiffest wall";

/// N of dry friction: what a light device of tendons has. Each device is tried without it, its
/// model's own, and with it.
constexpr double kDryFriction = 0.2;

/// One way to run the loop.
struct Variant {
  std::size_t loop;  ///< its place in kLoops, apart from delay
  std::string name;
  Wall wall;
};

std::vector<Variant> variants(const DeviceModel& device, double period,
                              const std::vector<int>& delays) {
  std::vector<Variant> all;
  for (const int delay : delays) {
    const std::string late = delay == 0   ? ""
                             : delay == 1 ? ", a period late"
                                          : ", " + std::to_string(delay) + " periods late";
    Wall wall{device, {}, period};
    wall.device.linkage.delay = delay;
    for (std::size_t loop = 0; loop < std::size(kLoops); ++loop)
      all.push_back({loop, kLoops[loop].name + late, withLoop(wall, kLoops[loop])});
  }
  Wall loose{device, {}, period}, dry = loose;
  loose.hand.damping = 2.0;
  all.push_back({0, "loose hand", loose});
  dry.device.coulomb = kDryFriction;
  all.push_back({0, "dry friction", dry});
  return all;
}

Outcome wallLimitsOf(const DeviceModel& device, int number, double period,
                     const std::vector<int>& delays) {
  Outcome outcome;
  Table table{"Measured limits of stiffness",
              {"device", "rate", "loop", "b + b_hand [N s/m]", "measured [N/m]",
               "2b/(T (1 + 2 delay)) [N/m]", "linear [N/m]", "measured / theory", "rated [N/m]"},
              {}};
  std::vector<Plot> plots;
  for (const Loop& loop : kLoops)
    plots.push_back(limitPlot(
        std::string{"Measured limit over 2b / (T (1 + 2 delay)), "} + loop.name + ", " +
            rateOf(period),
        "One mark for each device, in the order of the table of devices, and delay; b counts "
        "device, hand and virtual damper. What is plain lies near 1; the passivity "
        "controller lies above"));
  // dry friction beside the plain loop in time; what is not shipped is a row, no case
  double in_time = NAN;
  for (const Variant& variant : variants(device, period, delays)) {
    const Wall& wall = variant.wall;
    const bool controlled = wall.controller > 0.0, dry = wall.device.coulomb > 0.0;
    const Limit limit = measuredLimit(wall);
    const double measured = limit.stiffness, theory = wall.theory();
    const double linear = controlled || dry ? NAN : linearLimit(wall);
    const std::string name = "limit/" + device.name + "/" + rateOf(period) + "/" + variant.name;
    if (variant.name == "plain") {
      Case each = limitCase(device, period, 0);
      each.name = name;
      Case above = each;
      above.name += ", from above";
      above.bound = 1.15;
      above.sense = Case::Sense::AtMost;
      outcome.cases.push_back(std::move(each));
      outcome.cases.push_back(std::move(above));
      in_time = measured;
    } else if (dry) {
      outcome.cases.push_back(
          {name, measured / in_time, 0.95, "", Case::Sense::AtLeast,
           "over the plain limit, with " + shortly(kDryFriction) + " N: what is dry only helps"});
    } else if (!controlled && wall.damping == 0.0) {
      outcome.cases.push_back(
          {name, measured / linear, 0.85, "", Case::Sense::AtLeast,
           "over the limit of the linear sampled system; theory " + shortly(theory) + " N/m"});
      outcome.cases.push_back({name + ", from above", measured / linear, 1.15, "",
                               Case::Sense::AtMost,
                               "a press that does not see the shaking would find no limit"});
    }
    table.rows.push_back({device.name, rateOf(period), variant.name, shortly(wall.totalDamping()),
                          toWords(limit), shortly(theory),
                          std::isnan(linear) ? "" : shortly(linear), shortly(measured / theory),
                          shortly(device.rating.stiffness)});
    plots[variant.loop].series.push_back(
        {variant.name, {{double(number), measured / theory}}, false});
  }
  outcome.tables.push_back(std::move(table));
  outcome.plots = std::move(plots);
  if (period < 1e-3 || in_time == 0.0) return outcome;

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
  outcome.plots.push_back(std::move(presses));
  return outcome;
}

}  // namespace

std::string rateOf(double period) { return shortly(1e-3 / period) + " kHz"; }

Wall withLoop(Wall plain, const Loop& loop) {
  plain.damping = loop.damping * plain.device.rating.damping;
  plain.controller = loop.controller * plain.device.rating.damping;
  return plain;
}

Plot limitPlot(const std::string& title, const std::string& description) {
  Plot plot{title, description, {"device, by its number"}, {"measured / theory", Scale::Log}};
  plot.bound = 0.85;
  plot.bound_name = "not below 0.85";
  return plot;
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
          "over 2 (b + b_hand) / T, with " + shortly(wall.totalDamping()) + " N s/m in all"};
}

std::vector<Job> limitJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  const std::vector<int> delays = full ? std::vector<int>{0, 1, 2, 4} : std::vector<int>{0, 1};
  std::vector<Job> jobs;
  int number = 0;
  for (const DeviceModel& device : haptics::deviceModels()) {
    ++number;
    // the wall has one degree of freedom, in which an arm is nothing
    if (!device.linkage.arm.isZero(0.0)) continue;
    for (const double period : {1e-3, 0.25e-3})
      jobs.push_back({"limit/" + device.name + "/" + rateOf(period), kWallSection,
                      (period < 1e-3 ? 2.0 : 0.5) * (full ? 2.0 : 1.0),
                      [=](std::uint64_t) { return wallLimitsOf(device, number, period, delays); }});
  }
  return jobs;
}

}  // namespace study::stability
