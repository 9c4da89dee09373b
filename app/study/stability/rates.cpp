// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "app/study/stability/failures.h"
#include "app/study/stability/loops.h"
#include "resources/messages/messages.h"

namespace study::stability {
namespace {

using haptics::HandMotion;

/// A device at a rate that its link carries, at what a session allows it there, through every
/// hand, each for so many seconds after the ramp.
Outcome handsAt(const std::string& job, const haptics::DeviceModel& device, haptics::ServoRate rate,
                double seconds, std::uint64_t seed) {
  static constexpr std::pair<const char*, HandMotion> kMotions[] = {{"tap", HandMotion::Tap},
                                                                    {"wedge", HandMotion::Wedge},
                                                                    {"pry", HandMotion::Pry},
                                                                    {"hook", HandMotion::Hook}};
  static const comparison::Touched touched = comparison::phantomScene("demo");
  static const auto scene = haptics::makeScene(touched.volume, toolOf(touched)).value();
  Findings found;
  const Wall wall = drivenAt(device, rate);
  const double allowed = allowedFor(wall, *scene);
  const std::string delay = shortly(wall.device.linkage.delay);
  const bool turns = device.rating.sensed >= 6;
  for (const auto& [name, motion] : kMotions) {
    haptics::ClosedLoop loop = loopOf({wall, allowed, true}, scene, touched.isovalue);
    // half of what it may push, and no deeper than tools slip from
    const double depth = std::min(0.5 * device.rating.force / allowed, 3e-3);
    const auto hand = haptics::Hand::aimed(
        motion, *scene, touched.isovalue,
        haptics::Hand::reachFor(depth, allowed, loop.grip.stiffness), 1 + seed);
    const double wait = loop.limits.ramp_time;
    const std::int64_t ticks = std::lround((seconds + wait) / rate.period());
    const LoopResult run = hand ? runLoop(loop,
                                          waiting(*hand, placeOf(touched, 1 + seed), wait, seconds,
                                                  rate.period(), turns),
                                          ticks)
                                : LoopResult{.non_finite = int(ticks), .refused = hand.error()};
    const auto mJ = [&](double energy) { return run.refused ? NAN : 1e3 * energy; };
    found.row("Every device at every rate of its link, as shipped",
              {{"device", device.name},
               {"rate", rateOf(rate.period())},
               {"delay", delay},
               {"lead", shortly(wall.lead / rate.period())},
               {"hand", name},
               {"allowed [N/m]", shortly(allowed)},
               {"given at the handle [mJ a second]", shortly(mJ(run.energy) / seconds)},
               {"energy given, most [mJ]", shortly(mJ(run.balance.most_given))},
               {"beyond what sampling gives [mJ]", shortly(mJ(run.balance.most_own))},
               {"beyond what damping takes [mJ]", shortly(mJ(run.balance.most_left))},
               {"force step [N]", shortly(run.force_step)},
               {"ticks", std::to_string(ticks)},
               {"cut", std::to_string(run.cut)},
               {"contact", std::to_string(run.contact)},
               {"left by the guard", shortly(run.share)},
               {"looks that found it inside",
                std::to_string(run.inside) + " of " + std::to_string(run.looks)}});
    found.subject = job + "/" + name;
    // a torque that no motor makes gives energy with every turn, by the square of its angle
    if (!turns || device.linkage.torque)
      found.atMost(
          "energy given beyond what damping takes, most", mJ(run.balance.most_left), 1.0, "mJ",
          run.refused ? resources::sentence(*run.refused)
                      : delay + " periods late, of which " + shortly(wall.lead / rate.period()) +
                            " are led, at " + shortly(allowed) + " N/m, which is allowed");
    found.none("not finite", run.non_finite);
    found.none("looks that found it inside", run.inside);
    found.atLeast("milliseconds in contact",
                  std::min(kContactEnough, 1e3 * rate.period() * run.contact), 100.0, "",
                  "counted up to 200, so that there is something to be judged");
  }
  return std::move(found.outcome);
}

}  // namespace

std::vector<Job> rateJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  // of each kind of link one: late by a millisecond, by half a round of 4 kHz and led, in time
  const std::set<std::string> quick{"falcon", "lambda.7", "touch"};
  constexpr double kTwentyMinutes = 1200.0;  // s for a device, all its rates and hands
  constexpr double kTickCost = 25e-6;        // s
  std::vector<Job> jobs;
  for (const haptics::DeviceModel& device : haptics::deviceModels()) {
    if (!full && !quick.contains(device.name)) continue;
    std::vector<haptics::ServoRate> rates;
    for (const haptics::ServoRate rate : haptics::kServoRates)
      if (rate.hz <= haptics::rateOf(device.rating).hz) rates.push_back(rate);
    const double seconds = full ? kTwentyMinutes / (4.0 * double(rates.size())) : 2.0;
    for (const haptics::ServoRate rate : rates) {
      const std::string name = "rates/" + device.name + "/" + rateOf(rate.period());
      jobs.push_back(
          {name, "Every device at every rate of its link", 4.0 * seconds * rate.hz * kTickCost,
           [=](std::uint64_t seed) { return handsAt(name, device, rate, seconds, seed); }});
    }
  }
  return jobs;
}

}  // namespace study::stability
