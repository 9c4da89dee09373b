// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include "app/study/comparison/course.h"
#include "app/study/stability/failures.h"
#include "app/study/stability/loops.h"
#include "resources/messages/messages.h"

namespace study::stability {
namespace {

using haptics::HandMotion;

/// Hands on scenes with edges, holes and hooks: as shipped, and for the table at the paper's 5000
/// N/m and 1 kHz, each force in time.
Outcome handsOn(const comparison::Touched& touched, double seconds, std::uint64_t seed) {
  static constexpr std::pair<const char*, HandMotion> kMotions[] = {
      {"wedge", HandMotion::Wedge}, {"pry", HandMotion::Pry}, {"hook", HandMotion::Hook}};
  Findings found;
  Plot& plot = found.plot("Energy given: " + touched.name,
                          "What the loop has given to the hand, less what it has taken, since the "
                          "start: a passive loop stays at zero or below",
                          {"time [s]"}, {"energy [mJ]"});
  const auto scene = haptics::makeScene(touched.volume, toolOf(touched)).value();
  const haptics::DeviceModel device = haptics::findDeviceModel("lambda.7").value();
  const Wall plain{device}, shipped = asShipped(device);
  const double allowed = allowedFor(shipped, *scene);
  for (const Way& way :
       {Way{shipped, allowed, true, "as shipped"}, Way{plain, 5000.0, false, kLoops[0].unguarded},
        Way{withLoop(plain, kLoops[2]), 5000.0, false, kLoops[2].unguarded}})
    for (const auto& [name, motion] : kMotions) {
      haptics::ClosedLoop loop = loopOf(way, scene, touched.isovalue);
      const auto hand = haptics::Hand::aimed(
          motion, *scene, touched.isovalue,
          haptics::Hand::reachFor(1e-3, way.stiffness, loop.grip.stiffness), 1 + seed);
      const double wait = loop.limits.ramp_time;
      const double period = way.wall.period;
      const LoopResult run =
          hand ? runLoop(loop, waiting(*hand, placeOf(touched, 1 + seed), wait, seconds, period),
                         std::lround((seconds + wait) / period))
               : LoopResult{.refused = hand.error()};
      const auto mJ = [&](double energy) { return run.refused ? NAN : 1e3 * energy; };
      if (way.wall.controller == 0.0)
        plot.series.push_back({std::string{name} + ", " + way.name, run.given});
      if (!way.shipped) {
        found.row("Hands beyond what is allowed, and without the guard",
                  {{"scene", touched.name},
                   {"hand", name},
                   {"loop", way.name},
                   {"rate", rateOf(period)},
                   {"K [N/m]", shortly(way.stiffness)},
                   {"allowed [N/m]", shortly(allowed)},
                   {"energy given, most [mJ]", shortly(mJ(run.balance.most_given))},
                   {"beyond what damping takes [mJ]", shortly(mJ(run.balance.most_left))},
                   {"force step [N]", shortly(run.force_step)},
                   {"contact", std::to_string(run.contact)}});
        continue;
      }
      found.subject = "hands/" + touched.name + "/" + name;
      found.atMost(
          "energy given beyond what damping takes, most", mJ(run.balance.most_left), 1.0, "mJ",
          run.refused ? resources::sentence(*run.refused)
                      : rateOf(period) + ", " + shortly(loop.linkage.delay) + " periods late, at " +
                            shortly(allowed) + " N/m, which is allowed; the guard left " +
                            shortly(run.share) + " of it; largest step of force in a tick " +
                            shortly(run.force_step) + " N; given in all at most " +
                            shortly(mJ(run.balance.most_given)) + " mJ");
      found.atMost("energy given beyond what sampling gives, most", mJ(run.balance.most_own), 1.0,
                   "mJ",
                   "which a held force gives at each stroke, without end: in all " +
                       shortly(mJ(run.balance.sampled)) + " mJ here");
      found.none("not finite", run.non_finite);
      found.none("looks that found it inside", run.inside);
      found.atLeast("milliseconds in contact", std::min(kContactEnough, 1e3 * period * run.contact),
                    100.0, "", "counted up to 200, so that there is something to be judged");
    }
  return std::move(found.outcome);
}

/// What lies between the handle's pivot and a contact.
struct Lever {
  double arm;    ///< m, from the pivot to the tool's origin
  double reach;  ///< m, from there to the ball at the tool's end; 0: the tool is that ball
  bool torque;   ///< the device has torque motors
};

/// A ball, or two of them on either side of the origin, of which one is at the end of the lever.
haptics::Tool toolAt(const Lever& lever) {
  std::vector<Vec3> points;
  for (const Vec3& p : datasets::ballPoints(100, 3e-3)) {
    points.push_back(p + Vec3{0.0, 0.0, -lever.reach});
    if (lever.reach > 0.0) points.push_back(p + Vec3{0.0, 0.0, lever.reach});
  }
  return toolOf(std::move(points));
}

/// The lever lies along y over a half-space and the hand turns the handle about x by 0.05 rad to
/// and fro, so that the ball at its end dips in and out; where a force lifts the handle meanwhile,
/// the way in and the way out differ, and work is done that nobody pays for.
haptics::Hand turning(const Lever& lever, double wait, int turns) {
  const Quat level = turn(0.5 * std::numbers::pi, Vec3::UnitX());  // -z becomes y
  std::vector<double> times;
  std::vector<Pose> poses;
  const Vec3 pivot{0.0, -lever.arm - lever.reach, 3e-3};
  for (int n = 0; n <= 250 * turns; ++n) {
    const double t = 2e-3 * n, phase = 2.0 * std::numbers::pi * 2.0 * t;
    // a little beside, a quarter of a turn late, as a hand is that gives way
    const Vec3 aside{0.0, 0.0, 2e-3 * (1.0 - std::cos(phase))};
    times.push_back(wait + t);
    poses.push_back(at(pivot + aside, turn(-0.05 * std::sin(phase), Vec3::UnitX()) * level));
    poses.back().translation() += poses.back().linear() * Vec3{0.0, 0.0, -lever.arm};
  }
  return haptics::Hand::along(std::move(times), std::move(poses)).value();
}

Outcome turnedHandle(int turns) {
  Findings found;
  for (const char* lever : {"with an arm", "with a long tool"})
    found.plot("Energy given to the hand by a device of three actuated degrees of freedom, " +
                   std::string{lever},
               "The handle is turned to and fro with the end of a lever in contact, at the "
               "stiffness that is allowed. Without torque motors the lever lowers it",
               {"time [s]"}, {"energy [mJ]"});
  const double mJ = 1e3 / turns;
  for (const Lever& lever :
       {Lever{0.02, 0.0, false}, Lever{0.02, 0.0, true}, Lever{0.1, 0.0, false},
        Lever{0.1, 0.0, true}, Lever{0.2, 0.0, false}, Lever{0.2, 0.0, true},
        Lever{0.0, 0.05, false}, Lever{0.0, 0.1, false}, Lever{0.0, 0.2, false}}) {
    const bool is_arm = lever.arm > 0.0;
    Wall wall = asShipped(haptics::findDeviceModel(is_arm ? "omni-arm-200" : "omega.6").value());
    wall.device.linkage.arm = {0.0, 0.0, -lever.arm};
    wall.device.linkage.torque = lever.torque;
    const auto scene = sceneOf(ramp(0.0, 1, datasets::shapes::HalfSpace{}), toolAt(lever));
    const double rated = wall.device.rating.stiffness;
    const double allowed = lever.torque ? rated : allowedFor(wall, *scene);
    const std::string length = shortly(1e3 * (lever.arm + lever.reach)) + " mm";
    const auto turned = [&](const char* caption, double stiffness, bool shipped) {
      haptics::ClosedLoop loop = loopOf({wall, stiffness, shipped}, scene, 0.0);
      if (lever.torque) loop.limits.torque = INFINITY;
      // the handle's own extent, not that of the ball 200 mm away
      loop.grip.gyration = 0.03;
      const double wait = loop.limits.ramp_time;
      LoopResult r = runLoop(loop, turning(lever, wait, turns),
                             std::lround((wait + 0.5 * turns) / wall.period));
      found.row(caption, {{"lever", (is_arm ? "arm of " : "tool that reaches ") + length},
                          {"torque motors", lever.torque ? "yes" : "no"},
                          {"rate", rateOf(wall.period)},
                          {"delay", shortly(wall.device.linkage.delay)},
                          {"K [N/m]", shortly(stiffness)},
                          {"given at the handle [mJ a turn]", shortly(mJ * r.energy)},
                          {"given by the program [mJ a turn]", shortly(mJ * r.program)},
                          {"work of the torque not made [mJ a turn]", shortly(mJ * r.lost)},
                          {"largest force [N]", shortly(r.force)}});
      return r;
    };
    turned("A handle turned at what is rated, whatever the lever, without the guard", rated, false);
    const LoopResult r =
        turned("A handle turned with the end of a lever in contact", allowed, true);
    found.outcome.plots[is_arm ? 0 : 1].series.push_back(
        {length + ", " + (lever.torque ? "torque" : "no torque"), r.given});
    found.subject = (is_arm ? "arm of " : "reach of ") + length + ", " +
                    (lever.torque ? "six" : "three") + " actuated";
    if (is_arm)
      found.atMost("energy given by the program", mJ * r.program, 1.0, "mJ a turn",
                   "at the tool, force and torque together: that is passive whatever the device "
                   "leaves out");
    found.atMost("energy given at the handle", mJ * r.energy, 1.0, "mJ a turn",
                 "at " + shortly(allowed) + " N/m, which is allowed");
    if (is_arm)
      found.atMost("energy not accounted for", mJ * std::abs(r.energy - r.program + r.lost), 1.0,
                   "mJ a turn",
                   "what the hand gets is what the program gives less the work of the torque that "
                   "no motor makes");
    found.atMost("force", r.non_finite > 0 ? NAN : r.force, wall.device.rating.force * (1.0 + 1e-9),
                 "N");
  }
  found.outcome.remarks.push_back(
      "Without torque motors a loop that is passive by itself gives energy through the handle's "
      "passive rotation, as [Chan 2011], 3.1, says of large moment arms. A passivity controller "
      "between program and device cannot see it in force and torque; it would have to count the "
      "force alone, at the handle. What bounds it: the rated force, the lever, and the stiffness, "
      "which is therefore allowed to fall with the lever.");
  return std::move(found.outcome);
}

}  // namespace

std::vector<Job> handJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  std::vector<Job> jobs;
  const auto add = [&](const std::string& scene, comparison::Touched (*make)(const std::string&),
                       double cost) {
    jobs.push_back({"hands/" + scene, "Hands that move", cost, [=](std::uint64_t seed) {
                      return handsOn(make(scene), full ? 10.0 : 3.0, seed);
                    }});
  };
  for (const char* name : {"sphere", "torus", "gyroid", "slot", "demo"})
    add(name, comparison::phantomScene, full ? 5.0 : 2.0);
  // the paper's, which are large: only one of them where it is quick
  for (const std::string& name : comparison::sceneNames())
    if (full || name == "hole") add(name, comparison::makeScene, full ? 20.0 : 5.0);
  jobs.push_back({"hands/turned arm", "Hands that move", 1.0,
                  [=](std::uint64_t) { return turnedHandle(full ? 20 : 4); }});
  return jobs;
}

}  // namespace study::stability
