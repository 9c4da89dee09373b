// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/hands.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "app/study/comparison/course.h"
#include "app/study/comparison/scenes.h"
#include "app/study/stability/energy_balance.h"
#include "app/study/stability/failures.h"
#include "app/study/stability/presses.h"
#include "datasets/phantoms/phantoms.h"
#include "haptics/coupling/passivity.h"
#include "haptics/simulation/allowed_stiffness.h"
#include "resources/messages/messages.h"

namespace study::stability {
namespace {

using haptics::ClosedLoop;
using haptics::DeviceModel;
using haptics::HandMotion;
using haptics::Pose;
using haptics::Quat;
using haptics::TraceRow;
using haptics::Vec3;

const char* const kHandsSection = "Hands that move";

/// A phantom as one of the scenes.
comparison::Touched phantomCase(const std::string& name) {
  datasets::Phantom phantom = datasets::makePhantom(name).value();
  comparison::Touched made;
  made.name = name;
  made.volume = std::make_shared<const haptics::Volume>(std::move(phantom.volume));
  made.isovalue = phantom.isovalue;
  made.tool = phantom.tool;
  return made;
}

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

/// One way to run the loop of a hand that moves.
struct Way {
  const char* name;
  double stiffness;
  bool shipped, controlled;
};

/// What the paper's devices were driven at, on scenes with edges, holes and hooks: as shipped, and
/// for the table at the paper's 5000 N/m.
Outcome handsOn(const comparison::Touched& touched, double seconds, std::uint64_t seed) {
  Outcome outcome;
  const auto scene = haptics::makeScene(touched.volume, comparison::toolOf(touched)).value();
  Plot plot{"Energy given: " + touched.name,
            "What the loop has given to the hand, less what it has taken, since the start: a "
            "passive loop stays at zero or below",
            {"time [s]"},
            {"energy [mJ]"}};
  Table beyond{"Hands beyond what is allowed, and without the guard",
               {"scene", "hand", "loop", "K [N/m]", "allowed [N/m]", "energy given, most [mJ]",
                "beyond what damping takes [mJ]", "force step [N]", "contact"},
               {}};
  const DeviceModel device = haptics::findDeviceModel("lambda.7").value();
  const double allowed = allowedFor({device}, *scene);
  for (const Way& way :
       {Way{"as shipped", allowed, true, false}, Way{"no guard", 5000.0, false, false},
        Way{"no guard, passivity controller", 5000.0, false, true}})
    for (const auto& [name, motion] : {std::pair{"wedge", HandMotion::Wedge},
                                       {"pry", HandMotion::Pry},
                                       {"hook", HandMotion::Hook}}) {
      ClosedLoop loop = loopOf({device}, scene, touched.isovalue, way.stiffness, way.shipped);
      auto hand = haptics::Hand::aimed(
          motion, *scene, touched.isovalue,
          haptics::Hand::reachFor(1e-3, way.stiffness, loop.grip.stiffness), 1 + seed);
      const double wait = loop.limits.ramp_time;
      if (hand) hand = waiting(*hand, touched.place, wait, seconds);
      if (way.controlled) loop.passivity_damping = device.rating.damping;
      EnergyBalance balance{way.stiffness, loop.grip, loop.period};
      double step = 0.0, share = 1.0;
      std::optional<TraceRow> before;
      int non_finite = 0, inside = 0, contact = 0, tick = 0;
      Series series{std::string{name} + ", " + way.name, {}};
      const auto ticks = std::int64_t(1e3 * (seconds + wait));
      const auto run =
          !hand ? haptics::Expected<void>{tl::unexpected(hand.error())}
                : loop.run(*hand, ticks, [&](const TraceRow& row) {
                    if (before)
                      balance.add(row.energy, before->sent_W,
                                  haptics::motionBetween(before->X_WH, row.X_WH),
                                  scene->metric.whitened(haptics::motionBetween(row.X_WP, row.X_WD),
                                                         row.X_WP.linear()));
                    contact += row.contacts > 0;
                    non_finite += !row.X_WP.matrix().allFinite() ||
                                  !std::isfinite(row.coupling_W.force.norm());
                    if (tick % 10 == 0) {
                      series.points.push_back({row.time, 1e3 * row.energy});
                      inside += !isOutside(*scene->volume, touched.isovalue,
                                           scene->tool.shell.points, row.X_WP);
                    }
                    if (before)
                      step = std::max(step, (row.sent_W.force - before->sent_W.force).norm());
                    before = row;
                    share = row.stiffness_share;
                    ++tick;
                    return true;
                  });
      const auto mJ = [&](double energy) { return run ? 1e3 * energy : NAN; };
      if (!way.controlled) plot.series.push_back(std::move(series));
      if (!way.shipped) {
        beyond.rows.push_back({touched.name, name, way.name, shortly(way.stiffness),
                               shortly(allowed), shortly(mJ(balance.mostGiven())),
                               shortly(mJ(balance.mostLeft())), shortly(step),
                               std::to_string(contact)});
        continue;
      }
      const std::string title = "hands/" + touched.name + "/" + name;
      outcome.cases.push_back(
          {title + "/energy given beyond what damping takes, most", mJ(balance.mostLeft()), 1.0,
           "mJ", Case::Sense::AtMost,
           run ? "at " + shortly(allowed) + " N/m, which is allowed; the guard left " +
                     shortly(share) + " of it; largest step of force in a tick " + shortly(step) +
                     " N; given in all at most " + shortly(mJ(balance.mostGiven())) + " mJ"
               : resources::sentence(run.error())});
      outcome.cases.push_back(
          {title + "/energy given beyond what sampling gives, most", mJ(balance.mostOwn()), 1.0,
           "mJ", Case::Sense::AtMost,
           "A force that is held for a tick gives K/2 times the square of the change of the "
           "spring's stretch, at each stroke, without end: in all " +
               shortly(mJ(balance.sampled())) + " mJ here"});
      outcome.cases.push_back({title + "/not finite", double(non_finite), 0.0, ""});
      outcome.cases.push_back({title + "/looks that found it inside", double(inside), 0.0, ""});
      outcome.cases.push_back(
          {title + "/ticks in contact", double(contact), 100.0, "", Case::Sense::AtLeast});
    }
  outcome.tables.push_back(std::move(beyond));
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

/// What a few turns of the handle, to and fro, came to.
struct Turned {
  double handle = 0.0;   ///< J given to the hand, where it holds the handle
  double program = 0.0;  ///< J given by the program, at the tool as it reads and commands it
  double lost = 0.0;   ///< J that the torque about the handle that no motor makes would have given
  double force = 0.0;  ///< N, the largest
  bool finite = true;
};

/// The arm lies along y over a half-space and the hand turns the handle about x by 0.05 rad to and
/// fro, so that the tool at its end dips in and out; where a force lifts the handle meanwhile, the
/// way in and the way out differ, and work is done that nobody pays for.
Turned turnHandle(DeviceModel device, double arm, bool torque, double stiffness, bool shipped,
                  int turns, Series* series) {
  device.linkage.arm = {0.0, 0.0, -arm};
  device.linkage.torque = torque;
  Stage stage = makeStage("ball", 0.0, 1);
  // a flat wall, and a ball at the end of the arm
  stage.scene =
      sceneOf(datasets::sampledFloat(
                  cube(48), [](const Vec3& p) { return std::clamp(-1e5 * p.z(), -300.0, 300.0); }),
              ball(100, 3e-3));
  ClosedLoop loop = loopOf({device}, stage.scene, 0.0, stiffness, shipped);
  if (torque) loop.limits.torque = INFINITY;
  // the handle's own extent, not that of the ball 200 mm away
  loop.grip.gyration = 0.03;

  const Quat level{Eigen::AngleAxisd{0.5 * std::numbers::pi, Vec3::UnitX()}};  // -z becomes y
  std::vector<double> times;
  std::vector<Pose> poses;
  const Vec3 pivot{0.0, -arm, 3e-3};
  const double wait = loop.limits.ramp_time;
  for (int n = 0; n <= 250 * turns; ++n) {
    const double t = 2e-3 * n, angle = -0.05 * std::sin(2.0 * std::numbers::pi * 2.0 * t);
    // a little beside, a quarter of a turn late, as a hand is that gives way
    const Vec3 aside{0.0, 0.0, 2e-3 * (1.0 - std::cos(2.0 * std::numbers::pi * 2.0 * t))};
    const Pose X_WH = at(pivot + aside, Quat{Eigen::AngleAxisd{angle, Vec3::UnitX()}} * level);
    Pose X_WD = X_WH;
    X_WD.translation() += X_WH.linear() * device.linkage.arm;
    times.push_back(wait + t);
    poses.push_back(X_WD);
  }
  const haptics::Hand hand = haptics::Hand::along(std::move(times), std::move(poses)).value();
  Turned result;
  haptics::PassivityObserver program, lost;
  TraceRow before;
  bool first = true;
  const auto done = loop.run(hand, std::lround(1e3 * wait) + 500 * turns, [&](const TraceRow& row) {
    if (!first) {
      program.add(before.sent_W, haptics::motionBetween(before.X_WD, row.X_WD));
      if (!torque) {
        const Vec3 r = before.X_WD.translation() - before.X_WH.translation();
        lost.add({Vec3::Zero(), r.cross(before.sent_W.force)},
                 haptics::motionBetween(before.X_WH, row.X_WH));
      }
    }
    if (series && std::lround(1e3 * row.time) % 10 == 0)
      series->points.push_back({row.time, 1e3 * row.energy});
    result.handle = row.energy;
    result.force = std::max(result.force, row.sent_W.force.norm());
    result.finite = result.finite && row.X_WP.matrix().allFinite() && std::isfinite(row.energy);
    before = row;
    first = false;
    return true;
  });
  result.finite = result.finite && bool(done);
  result.program = program.energy();
  result.lost = lost.energy();
  return result;
}

Outcome turnedArm(int turns) {
  Outcome outcome;
  const DeviceModel omni = haptics::findDeviceModel("omni-arm-200").value();
  const std::vector<std::string> head{"arm [mm]",
                                      "torque motors",
                                      "K [N/m]",
                                      "given at the handle [mJ a turn]",
                                      "given by the program [mJ a turn]",
                                      "work of the torque not made [mJ a turn]",
                                      "largest force [N]"};
  Table table{"A handle turned with a long arm in contact", head, {}};
  Table beyond{"A handle turned at what is rated, whatever the arm, without the guard", head, {}};
  Plot plot{"Energy given to the hand by a device of three actuated degrees of freedom",
            "The handle is turned to and fro with a tool at the end of an arm in contact, at the "
            "stiffness that is allowed. Without torque motors the arm lowers it",
            {"time [s]"},
            {"energy [mJ]"}};
  const double mJ = 1e3 / turns;
  const auto row = [&](double arm, bool torque, double stiffness, const Turned& r) {
    return std::vector<std::string>{
        shortly(1e3 * arm),      torque ? "yes" : "no", shortly(stiffness), shortly(mJ * r.handle),
        shortly(mJ * r.program), shortly(mJ * r.lost),  shortly(r.force)};
  };
  for (const double arm : {0.02, 0.1, 0.2})
    for (const bool torque : {false, true}) {
      Series series{shortly(1e3 * arm) + " mm, " + (torque ? "torque" : "no torque"), {}};
      const double rated = omni.rating.stiffness,
                   allowed = torque ? rated
                                    : haptics::allowedStiffness(omni.rating, haptics::PointShell{},
                                                                {}, arm);
      const Turned r = turnHandle(omni, arm, torque, allowed, true, turns, &series);
      plot.series.push_back(std::move(series));
      table.rows.push_back(row(arm, torque, allowed, r));
      beyond.rows.push_back(
          row(arm, torque, rated, turnHandle(omni, arm, torque, rated, false, turns, nullptr)));
      const std::string name =
          "arm of " + shortly(1e3 * arm) + " mm, " + (torque ? "six" : "three") + " actuated";
      outcome.cases.push_back({name + "/energy given by the program", mJ * r.program, 1.0,
                               "mJ a turn", Case::Sense::AtMost,
                               "at the tool, force and torque together: that is passive whatever "
                               "the device leaves out"});
      outcome.cases.push_back({name + "/energy given at the handle", mJ * r.handle, 1.0,
                               "mJ a turn", Case::Sense::AtMost,
                               torque ? ""
                                      : "six sensed and three actuated, at " + shortly(allowed) +
                                            " N/m: the torque that no motor makes is missing, "
                                            "[Chan 2011], 3.1, so the longer the arm, the softer "
                                            "the spring must be"});
      outcome.cases.push_back({name + "/energy not accounted for",
                               mJ * std::abs(r.handle - r.program + r.lost), 1.0, "mJ a turn",
                               Case::Sense::AtMost,
                               "what the hand gets, " + shortly(mJ * r.handle) +
                                   " mJ, is what the program gives less the work of the torque "
                                   "that no motor makes, " +
                                   shortly(mJ * r.lost) + " mJ"});
      outcome.cases.push_back(
          {name + "/force", r.finite ? r.force : NAN, omni.rating.force * (1.0 + 1e-9), "N"});
    }
  outcome.tables.push_back(std::move(beyond));
  outcome.tables.push_back(std::move(table));
  outcome.plots.push_back(std::move(plot));
  outcome.remarks.push_back(
      "Without torque motors a loop that is passive by itself gives energy through the handle's "
      "passive rotation, as [Chan 2011], 3.1, says of large moment arms. A passivity controller "
      "between program and device cannot see it in force and torque; it would have to count the "
      "force alone, at the handle. What bounds it: the rated force, the arm, and the stiffness, "
      "which is therefore allowed to fall with the arm.");
  return outcome;
}

}  // namespace

std::vector<Job> handJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  std::vector<Job> jobs;
  for (const std::string name : {"sphere", "torus", "gyroid", "slot", "demo"})
    jobs.push_back({"hands/" + name, kHandsSection, full ? 5.0 : 2.0, [=](std::uint64_t seed) {
                      return handsOn(phantomCase(name), full ? 10.0 : 3.0, seed);
                    }});
  // the paper's, which are large: only one of them where it is quick
  for (const std::string& name : comparison::sceneNames())
    if (full || name == "hole")
      jobs.push_back({"hands/" + name, kHandsSection, full ? 20.0 : 5.0, [=](std::uint64_t seed) {
                        return handsOn(comparison::makeScene(name), full ? 10.0 : 3.0, seed);
                      }});
  jobs.push_back({"hands/turned arm", kHandsSection, 1.0,
                  [=](std::uint64_t) { return turnedArm(full ? 20 : 4); }});
  return jobs;
}

}  // namespace study::stability
