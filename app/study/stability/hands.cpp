// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/hands.h"

#include <cmath>
#include <numbers>

#include "app/study/comparison/course.h"
#include "app/study/comparison/scenes.h"
#include "app/study/stability/failures.h"
#include "app/study/stability/presses.h"
#include "datasets/phantoms/phantoms.h"
#include "haptics/coupling/passivity.h"

namespace study {
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
comparison::Case phantomCase(const std::string& name) {
  datasets::Phantom phantom = datasets::makePhantom(name).value();
  comparison::Case made;
  made.name = name;
  made.volume = std::make_shared<const haptics::Volume>(std::move(phantom.volume));
  made.isovalue = phantom.isovalue;
  made.tool = phantom.tool;
  return made;
}

haptics::Hand movedTo(const Pose& X_place, const haptics::Hand& hand, double seconds) {
  const Pose X_to = comparison::movedTo(X_place, hand);
  std::vector<double> times;
  std::vector<Pose> poses;
  for (double t = 0.0; t <= seconds; t += 1e-3) {
    times.push_back(t);
    poses.push_back(X_to * hand.at(t));
  }
  return haptics::Hand::along(std::move(times), std::move(poses)).value();
}

/// What the paper's devices were driven at, on scenes with edges, holes and hooks.
Outcome handsAt5000(const comparison::Case& touched, double seconds, std::uint64_t seed) {
  Outcome outcome;
  const auto scene = haptics::makeScene(touched.volume, comparison::toolOf(touched)).value();
  Plot plot{"Energy given at 5000 N/m: " + touched.name,
            "What the loop has given to the hand, less what it has taken, since the start: a "
            "passive loop stays at zero or below",
            {"time [s]"},
            {"energy [mJ]"}};
  const DeviceModel device = haptics::findDeviceModel("lambda.7").value();
  for (const bool controlled : {false, true})
    for (const auto& [name, motion] : {std::pair{"wedge", HandMotion::Wedge},
                                       {"pry", HandMotion::Pry},
                                       {"hook", HandMotion::Hook}}) {
      ClosedLoop loop = loopOf({device}, scene, touched.isovalue, 5000.0);
      auto hand = haptics::Hand::aimed(motion, *scene, touched.isovalue,
                                       haptics::Hand::reachFor(1e-3, 5000.0, loop.grip.stiffness),
                                       1 + seed);
      if (hand && touched.place) hand = movedTo(*touched.place, *hand, seconds);
      if (controlled) loop.passivity_damping = device.rating.damping;
      const std::string title =
          "5000 N/m/" + touched.name + "/" + name + (controlled ? ", passivity controller" : "");
      double most = 0.0, step = 0.0;
      int non_finite = 0, inside = 0, contact = 0, tick = 0;
      Vec3 force = Vec3::Zero();
      Series series{std::string{name} + (controlled ? ", controller" : ""), {}};
      const auto run = !hand
                           ? haptics::Expected<void>{tl::unexpected(hand.error())}
                           : loop.run(*hand, std::int64_t(1e3 * seconds), [&](const TraceRow& row) {
                               most = worse(most, row.energy);
                               contact += row.contacts > 0;
                               non_finite += !row.X_WP.matrix().allFinite() ||
                                             !std::isfinite(row.coupling_W.force.norm());
                               if (tick % 10 == 0) {
                                 series.points.push_back({row.time, 1e3 * row.energy});
                                 inside += !isOutside(*scene->volume, touched.isovalue,
                                                      scene->tool.shell.points, row.X_WP);
                               }
                               step = std::max(step, (row.sent_W.force - force).norm());
                               force = row.sent_W.force;
                               ++tick;
                               return true;
                             });
      outcome.cases.push_back(
          {title + "/energy given, most", run ? 1e3 * most : NAN, 1.0, "mJ", Case::Sense::AtMost,
           run ? "largest step of force in a tick " + shortly(step) +
                     " N; a sampled spring gives a little at each stroke, and on a rough surface "
                     "the strokes are many"
               : run.error().what});
      outcome.cases.push_back({title + "/not finite", double(non_finite), 0.0, ""});
      outcome.cases.push_back({title + "/looks that found it inside", double(inside), 0.0, ""});
      outcome.cases.push_back(
          {title + "/ticks in contact", double(contact), 100.0, "", Case::Sense::AtLeast});
      plot.series.push_back(std::move(series));
    }
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
Turned turnHandle(DeviceModel device, double arm, bool torque, double stiffness, int turns,
                  Series* series) {
  device.linkage.arm = {0.0, 0.0, -arm};
  device.linkage.torque = torque;
  Stage stage = makeStage("ball", 0.0, 1);
  // a flat wall, and a ball at the end of the arm
  stage.scene = made::scene(
      datasets::sampledFloat(failures::cube(48),
                             [](const Vec3& p) { return std::clamp(-1e5 * p.z(), -300.0, 300.0); }),
      failures::ball(100, 3e-3));
  ClosedLoop loop = loopOf({device}, stage.scene, 0.0, stiffness);
  if (torque) loop.limits.torque = INFINITY;
  // the handle's own extent, not that of the ball 200 mm away
  loop.grip.gyration = 0.03;

  const Quat level{Eigen::AngleAxisd{0.5 * std::numbers::pi, Vec3::UnitX()}};  // -z becomes y
  std::vector<double> times;
  std::vector<Pose> poses;
  const Vec3 pivot{0.0, -arm, 3e-3};
  for (int n = 0; n <= 250 * turns; ++n) {
    const double t = 2e-3 * n, angle = -0.05 * std::sin(2.0 * std::numbers::pi * 2.0 * t);
    // a little beside, a quarter of a turn late, as a hand is that gives way
    const Vec3 aside{0.0, 0.0, 2e-3 * (1.0 - std::cos(2.0 * std::numbers::pi * 2.0 * t))};
    const Pose X_WH =
        failures::at(pivot + aside, Quat{Eigen::AngleAxisd{angle, Vec3::UnitX()}} * level);
    Pose X_WD = X_WH;
    X_WD.translation() += X_WH.linear() * device.linkage.arm;
    times.push_back(t);
    poses.push_back(X_WD);
  }
  const haptics::Hand hand = haptics::Hand::along(std::move(times), std::move(poses)).value();
  Turned result;
  haptics::PassivityObserver program, lost;
  TraceRow before;
  bool first = true;
  const auto done = loop.run(hand, 500 * turns, [&](const TraceRow& row) {
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
  Table table{"A handle turned with a long arm in contact",
              {"arm [mm]", "torque motors", "given at the handle [mJ a turn]",
               "given by the program [mJ a turn]", "work of the torque not made [mJ a turn]",
               "largest force [N]"},
              {}};
  Plot plot{"Energy given to the hand by a device of three actuated degrees of freedom",
            "The handle is turned to and fro with a tool at the end of an arm in contact. With "
            "torque motors, or a short arm, the loop takes energy; without, the longer the arm the "
            "more it gives, up to what the rated force does on the way",
            {"time [s]"},
            {"energy [mJ]"}};
  for (const double arm : {0.02, 0.1, 0.2})
    for (const bool torque : {false, true}) {
      Series series{shortly(1e3 * arm) + " mm, " + (torque ? "torque" : "no torque"), {}};
      const Turned r = turnHandle(omni, arm, torque, omni.rating.stiffness, turns, &series);
      plot.series.push_back(std::move(series));
      const double mJ = 1e3 / turns;
      table.rows.push_back({shortly(1e3 * arm), torque ? "yes" : "no", shortly(mJ * r.handle),
                            shortly(mJ * r.program), shortly(mJ * r.lost), shortly(r.force)});
      const std::string name =
          "arm of " + shortly(1e3 * arm) + " mm, " + (torque ? "six" : "three") + " actuated";
      outcome.cases.push_back({name + "/energy given by the program", mJ * r.program, 1.0,
                               "mJ a turn", Case::Sense::AtMost,
                               "at the tool, force and torque together: that is passive whatever "
                               "the device leaves out"});
      outcome.cases.push_back({name + "/energy given at the handle", mJ * r.handle, 1.0,
                               "mJ a turn", Case::Sense::AtMost,
                               torque ? ""
                                      : "six sensed and three actuated: the torque that no "
                                        "motor makes is missing, [Chan 2011], 3.1; the longer "
                                        "the arm, the more"});
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
  outcome.tables.push_back(std::move(table));
  outcome.plots.push_back(std::move(plot));
  outcome.remarks.push_back(
      "Without torque motors a loop that is passive by itself gives energy through the handle's "
      "passive rotation, as [Chan 2011], 3.1, says of large moment arms. A passivity controller "
      "between program and device cannot see it in force and torque; it would have to count the "
      "force alone, at the handle. What bounds it: the rated force, and the arm.");
  return outcome;
}

}  // namespace

std::vector<Job> handJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  std::vector<Job> jobs;
  for (const std::string name : {"sphere", "torus", "gyroid", "slot", "demo"})
    jobs.push_back({"hands/" + name, kHandsSection, full ? 5.0 : 2.0, [=](std::uint64_t seed) {
                      return handsAt5000(phantomCase(name), full ? 10.0 : 3.0, seed);
                    }});
  // the paper's, which are large: only one of them where it is quick
  for (const std::string& name : comparison::sceneNames())
    if (full || name == "hole")
      jobs.push_back({"hands/" + name, kHandsSection, full ? 20.0 : 5.0, [=](std::uint64_t seed) {
                        return handsAt5000(comparison::makeScene(name), full ? 10.0 : 3.0, seed);
                      }});
  jobs.push_back({"hands/turned arm", kHandsSection, 1.0,
                  [=](std::uint64_t) { return turnedArm(full ? 20 : 4); }});
  return jobs;
}

}  // namespace study
