// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/stability.h"

#include <numbers>

#include "app/study/comparison/course.h"
#include "app/study/comparison/scenes.h"
#include "app/study/stability/failures.h"
#include "app/study/stability/limits.h"
#include "app/study/stability/presses.h"
#include "haptics/coupling/passivity.h"
#include "haptics/simulation/allowed_stiffness.h"
#include "resources/messages/messages.h"

namespace study::stability {
namespace {

using haptics::HandMotion;
using haptics::TraceRow;

/// The hand, at another place if there is one, once the force has ramped in: what rises while
/// something is pressed gives energy by itself.
haptics::Hand waiting(const haptics::Hand& hand, const std::optional<Pose>& place, double wait,
                      double seconds) {
  const Pose X_to = place ? comparison::movedTo(*place, hand) : Pose::Identity();
  std::vector<double> times{0.0};
  std::vector<Pose> poses{X_to * hand.at(0.0)};
  for (double t = 0.0; t <= seconds; t += 1e-3) {
    times.push_back(wait + 1e-3 + t);
    poses.push_back(X_to * hand.at(t));
  }
  return haptics::Hand::along(std::move(times), std::move(poses)).value();
}

/// What the paper's devices were driven at, on scenes with edges, holes and hooks: as shipped, and
/// for the table at the paper's 5000 N/m.
Outcome handsOn(const comparison::Touched& touched, double seconds, std::uint64_t seed) {
  static constexpr std::pair<const char*, HandMotion> kMotions[] = {
      {"wedge", HandMotion::Wedge}, {"pry", HandMotion::Pry}, {"hook", HandMotion::Hook}};
  Findings found;
  Plot& plot = found.plot("Energy given: " + touched.name,
                          "What the loop has given to the hand, less what it has taken, since the "
                          "start: a passive loop stays at zero or below",
                          {"time [s]"}, {"energy [mJ]"});
  const auto scene = haptics::makeScene(touched.volume, comparison::toolOf(touched)).value();
  const Wall plain{haptics::findDeviceModel("lambda.7").value()};
  const double allowed = allowedFor(plain, *scene);
  for (const Way& way :
       {Way{"as shipped", plain, allowed, true}, Way{kLoops[0].unguarded, plain, 5000.0},
        Way{kLoops[2].unguarded, withLoop(plain, kLoops[2]), 5000.0}})
    for (const auto& [name, motion] : kMotions) {
      haptics::ClosedLoop loop =
          loopOf(way.wall, scene, touched.isovalue, way.stiffness, way.shipped);
      const auto hand = haptics::Hand::aimed(
          motion, *scene, touched.isovalue,
          haptics::Hand::reachFor(1e-3, way.stiffness, loop.grip.stiffness), 1 + seed);
      const double wait = loop.limits.ramp_time;
      EnergyBalance balance{way.stiffness, loop.grip, loop.period};
      double step = 0.0;
      Series series{std::string{name} + ", " + way.loop, {}};
      int tick = 0;
      const auto look = [&](const TraceRow& row, const TraceRow* before) {
        if (tick++ % 10 == 0) series.points.push_back({row.time, 1e3 * row.energy});
        if (!before) return;
        balance.add(
            row.energy, before->sent_W, haptics::motionBetween(before->X_WH, row.X_WH),
            scene->metric.whitened(haptics::motionBetween(row.X_WP, row.X_WD), row.X_WP.linear()));
        step = std::max(step, (row.sent_W.force - before->sent_W.force).norm());
      };
      const LoopResult run = hand ? runLoop(loop, waiting(*hand, touched.place, wait, seconds),
                                            std::int64_t(1e3 * (seconds + wait)), 10, look)
                                  : LoopResult{.refused = hand.error()};
      const auto mJ = [&](double energy) { return run.refused ? NAN : 1e3 * energy; };
      if (way.wall.controller == 0.0) plot.series.push_back(std::move(series));
      if (!way.shipped) {
        found.row("Hands beyond what is allowed, and without the guard",
                  {{"scene", touched.name},
                   {"hand", name},
                   {"loop", way.loop},
                   {"K [N/m]", shortly(way.stiffness)},
                   {"allowed [N/m]", shortly(allowed)},
                   {"energy given, most [mJ]", shortly(mJ(balance.most_given))},
                   {"beyond what damping takes [mJ]", shortly(mJ(balance.most_left))},
                   {"force step [N]", shortly(step)},
                   {"contact", std::to_string(run.contact)}});
        continue;
      }
      found.subject = "hands/" + touched.name + "/" + name;
      found.atMost("energy given beyond what damping takes, most", mJ(balance.most_left), 1.0, "mJ",
                   run.refused
                       ? resources::sentence(*run.refused)
                       : "at " + shortly(allowed) + " N/m, which is allowed; the guard left " +
                             shortly(run.share) + " of it; largest step of force in a tick " +
                             shortly(step) + " N; given in all at most " +
                             shortly(mJ(balance.most_given)) + " mJ");
      found.atMost("energy given beyond what sampling gives, most", mJ(balance.most_own), 1.0, "mJ",
                   "A force that is held for a tick gives K/2 times the square of the change of "
                   "the spring's stretch, at each stroke, without end: in all " +
                       shortly(mJ(balance.sampled)) + " mJ here");
      found.none("not finite", run.non_finite);
      found.none("looks that found it inside", run.inside);
      found.atLeast("ticks in contact", run.contact, 100.0);
    }
  return std::move(found.outcome);
}

/// What a few turns of the handle, to and fro, came to.
struct Turned {
  double handle = 0.0;   ///< J given to the hand, where it holds the handle
  double program = 0.0;  ///< J given by the program, at the tool as it reads and commands it
  double lost = 0.0;   ///< J that the torque about the handle that no motor makes would have given
  double force = 0.0;  ///< N, the largest; not a number where anything was none
  Series energy = {};  ///< mJ given at the handle, over time
};

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
Turned turnHandle(haptics::DeviceModel device, const Lever& lever, double stiffness, bool shipped,
                  int turns) {
  device.linkage.arm = {0.0, 0.0, -lever.arm};
  device.linkage.torque = lever.torque;
  const auto scene = sceneOf(ramp(0.0, 1, [](const Vec3& p) { return p.z(); }), toolAt(lever));
  haptics::ClosedLoop loop = loopOf({device}, scene, 0.0, stiffness, shipped);
  if (lever.torque) loop.limits.torque = INFINITY;
  // the handle's own extent, not that of the ball 200 mm away
  loop.grip.gyration = 0.03;

  const Quat level = turn(0.5 * std::numbers::pi, Vec3::UnitX());  // -z becomes y
  std::vector<double> times;
  std::vector<Pose> poses;
  const Vec3 pivot{0.0, -lever.arm - lever.reach, 3e-3};
  const double wait = loop.limits.ramp_time;
  for (int n = 0; n <= 250 * turns; ++n) {
    const double t = 2e-3 * n, phase = 2.0 * std::numbers::pi * 2.0 * t;
    // a little beside, a quarter of a turn late, as a hand is that gives way
    const Vec3 aside{0.0, 0.0, 2e-3 * (1.0 - std::cos(phase))};
    times.push_back(wait + t);
    poses.push_back(at(pivot + aside, turn(-0.05 * std::sin(phase), Vec3::UnitX()) * level));
    poses.back().translation() += poses.back().linear() * device.linkage.arm;
  }
  const haptics::Hand hand = haptics::Hand::along(std::move(times), std::move(poses)).value();
  Turned result;
  haptics::PassivityObserver program, lost;
  const auto look = [&](const TraceRow& row, const TraceRow* before) {
    if (before) {
      program.add(before->sent_W, haptics::motionBetween(before->X_WD, row.X_WD));
      const Vec3 r = before->X_WD.translation() - before->X_WH.translation();
      if (!lever.torque)
        lost.add({Vec3::Zero(), r.cross(before->sent_W.force)},
                 haptics::motionBetween(before->X_WH, row.X_WH));
    }
    if (std::lround(1e3 * row.time) % 10 == 0)
      result.energy.points.push_back({row.time, 1e3 * row.energy});
    result.force = std::max(result.force, row.sent_W.force.norm());
  };
  const LoopResult run = runLoop(loop, hand, std::lround(1e3 * wait) + 500 * turns, 50, look);
  if (run.non_finite > 0 || !std::isfinite(run.energy)) result.force = NAN;
  result.handle = run.energy;
  result.program = program.energy();
  result.lost = lost.energy();
  return result;
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
  std::vector<Lever> levers;
  for (const double arm : {0.02, 0.1, 0.2})
    for (const bool torque : {false, true}) levers.push_back({arm, 0.0, torque});
  for (const double reach : {0.05, 0.1, 0.2}) levers.push_back({0.0, reach, false});
  for (const Lever& lever : levers) {
    const bool is_arm = lever.arm > 0.0;
    const haptics::DeviceModel device =
        haptics::findDeviceModel(is_arm ? "omni-arm-200" : "omega.6").value();
    const double rated = device.rating.stiffness;
    const double allowed =
        lever.torque ? rated
                     : haptics::allowedStiffness(device.rating, toolAt(lever).shell, {}, lever.arm);
    const std::string length = shortly(1e3 * (lever.arm + lever.reach)) + " mm";
    const auto turned = [&](const char* caption, double stiffness, bool shipped) {
      Turned r = turnHandle(device, lever, stiffness, shipped, turns);
      found.row(caption, {{"lever", (is_arm ? "arm of " : "tool that reaches ") + length},
                          {"torque motors", lever.torque ? "yes" : "no"},
                          {"K [N/m]", shortly(stiffness)},
                          {"given at the handle [mJ a turn]", shortly(mJ * r.handle)},
                          {"given by the program [mJ a turn]", shortly(mJ * r.program)},
                          {"work of the torque not made [mJ a turn]", shortly(mJ * r.lost)},
                          {"largest force [N]", shortly(r.force)}});
      return r;
    };
    turned("A handle turned at what is rated, whatever the lever, without the guard", rated, false);
    Turned r = turned("A handle turned with the end of a lever in contact", allowed, true);
    r.energy.name = length + ", " + (lever.torque ? "torque" : "no torque");
    found.outcome.plots[is_arm ? 0 : 1].series.push_back(std::move(r.energy));
    found.subject = (is_arm ? "arm of " : "reach of ") + length + ", " +
                    (lever.torque ? "six" : "three") + " actuated";
    if (is_arm)
      found.atMost("energy given by the program", mJ * r.program, 1.0, "mJ a turn",
                   "at the tool, force and torque together: that is passive whatever the device "
                   "leaves out");
    found.atMost("energy given at the handle", mJ * r.handle, 1.0, "mJ a turn",
                 lever.torque ? ""
                              : "six sensed and three actuated, at " + shortly(allowed) +
                                    " N/m: the torque that no motor makes is missing, [Chan 2011], "
                                    "3.1, so the longer the lever, the softer the spring must be");
    if (is_arm)
      found.atMost("energy not accounted for", mJ * std::abs(r.handle - r.program + r.lost), 1.0,
                   "mJ a turn",
                   "what the hand gets, " + shortly(mJ * r.handle) +
                       " mJ, is what the program gives less the work of the torque that no motor "
                       "makes, " +
                       shortly(mJ * r.lost) + " mJ");
    found.atMost("force", r.force, device.rating.force * (1.0 + 1e-9), "N");
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
  struct Row {
    std::string scene;
    comparison::Touched (*make)(const std::string&);
    double cost;  // s
  };
  std::vector<Row> rows;
  for (const char* name : {"sphere", "torus", "gyroid", "slot", "demo"})
    rows.push_back({name, comparison::phantomScene, full ? 5.0 : 2.0});
  // the paper's, which are large: only one of them where it is quick
  for (const std::string& name : comparison::sceneNames())
    if (full || name == "hole") rows.push_back({name, comparison::makeScene, full ? 20.0 : 5.0});
  std::vector<Job> jobs;
  for (const Row& row : rows)
    jobs.push_back({"hands/" + row.scene, "Hands that move", row.cost, [=](std::uint64_t seed) {
                      return handsOn(row.make(row.scene), full ? 10.0 : 3.0, seed);
                    }});
  jobs.push_back({"hands/turned arm", "Hands that move", 1.0,
                  [=](std::uint64_t) { return turnedHandle(full ? 20 : 4); }});
  return jobs;
}

}  // namespace study::stability
