// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/presses.h"

#include <cmath>
#include <numbers>
#include <set>

#include "app/study/stability/failures.h"
#include "app/study/stability/limits.h"
#include "app/study/stability/wall.h"
#include "datasets/phantoms/shapes.h"
#include "haptics/coupling/passivity.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/simulation/allowed_stiffness.h"

namespace study::stability {
namespace {

using haptics::DeviceModel;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;

const char* const kPressSection = "Presses in six degrees of freedom";
constexpr double kPress = 2.0;   // N
constexpr double kSpeed = 0.06;  // m/s, of the hand at its fastest
constexpr double kRest = 0.2;    // s
constexpr double kSettle = 0.8;  // s: a handle on noise finds its place, ringing at some 7 Hz

template <class Distance>
haptics::Volume ramp(double noise, unsigned seed, Distance&& distance) {
  std::mt19937 engine{seed};
  std::normal_distribution<double> grain{0.0, 1.0};
  return datasets::sampledFloat(cube(48), [&](const Vec3& p) {
    return std::clamp(-1e5 * distance(p), -300.0, 300.0) +
           (noise > 0.0 ? 600.0 * noise * grain(engine) : 0.0);
  });
}

/// What a sweep goes through, and how the loop is run.
struct Sweep {
  std::string device, stage;
  Wall loop;
  std::vector<double> stiffnesses;  ///< beside the default and what is allowed
  std::vector<int> delays;
  std::vector<double> noises;  ///< the first is none
  bool other_loops = false;    ///< rows also without the guard and with what is not shipped
  std::string name() const {
    return "press/" + device + "/" + stage + (loop.period < 1e-3 ? "/" + rateOf(loop.period) : "");
  }
};

/// The greatest of some figures, and where it was.
struct Worst {
  double value = -INFINITY;
  std::string where = {};
  void add(double figure, double stiffness, double noise) {
    const double now = worse(value, figure);
    if (now <= value) return;
    value = now;
    where = "; worst at " + shortly(stiffness) + " N/m, noise of " + shortly(100.0 * noise) + " %";
  }
};

/// One press, as a row.
std::vector<std::string> rowOf(const Sweep& sweep, const char* loop, int delay, double noise,
                               double stiffness, double allowed, const PressResult& r) {
  return {sweep.device,
          sweep.stage,
          rateOf(sweep.loop.period),
          loop,
          std::to_string(delay),
          shortly(100.0 * noise),
          shortly(stiffness),
          shortly(stiffness / allowed),
          shortly(1e6 * r.amplitude),
          shortly(r.force_step),
          shortly(1e3 * r.energy),
          shortly(1e3 * r.risen),
          shortly(1e6 * r.rise),
          shortly(r.share),
          std::to_string(r.contact)};
}
const std::vector<std::string> kRowHead{"device",
                                        "scene",
                                        "rate",
                                        "loop",
                                        "delay",
                                        "noise [%]",
                                        "K [N/m]",
                                        "of what is allowed",
                                        "amplitude [um]",
                                        "force step [N]",
                                        "energy given [mJ]",
                                        "proxy's rises, sum [mJ]",
                                        "farthest rise [um]",
                                        "left by the guard",
                                        "contact"};

/// The loops that are not shipped, on the same press.
void addOtherLoops(Table& table, const Sweep& sweep, const Wall& late, const Stage& stage,
                   double noise, double allowed) {
  const double damping = late.device.rating.damping;
  const int delay = late.device.linkage.delay;
  const auto add = [&](const char* loop, const Wall& wall, double stiffness, bool shipped) {
    table.rows.push_back(rowOf(sweep, loop, delay, noise, stiffness, allowed,
                               press(wall, stage, stiffness, shipped)));
  };
  Wall damped = late, controlled = late;
  damped.damping = 0.25 * damping;
  controlled.controller = damping;
  for (const double stiffness : {allowed, 1.6 * allowed, 4.0 * allowed}) {
    add("no guard", late, stiffness, false);
    add("no guard, virtual damping", damped, stiffness, false);
    add("no guard, passivity controller", controlled, stiffness, false);
  }
}

Outcome pressesOf(const Sweep& sweep, std::uint64_t seed) {
  Outcome outcome;
  Table within{"Presses, as shipped", kRowHead, {}};
  Table beyond{"Beyond what is allowed, and without the guard", kRowHead, {}};
  const std::string title =
      sweep.device + ", " + sweep.stage +
      (sweep.loop.period < 1e-3 ? ", " + rateOf(sweep.loop.period) : std::string{});
  const auto plot = [&](const char* what, const char* unit, const char* description) {
    return Plot{title + ": " + what,
                description,
                {"stiffness [N/m]", Scale::Log},
                {std::string{what} + " [" + unit + "]", Scale::Log}};
  };
  Plot amplitudes = plot("amplitude at rest", "um",
                         "Worst over the noise, for each delay, also beyond what is allowed: the "
                         "encoder's own step up to the limit of the sampled spring");
  Plot energies = plot("energy given in a press", "mJ",
                       "Worst over the noise, for each delay, also beyond what is allowed; in the "
                       "lane of zero: the loop took energy. It announces the limit before the "
                       "amplitude does");
  amplitudes.bound = 3e6 * sweep.loop.device.linkage.encoder;
  amplitudes.bound_name = "three steps of the encoder";
  energies.bound = 1.0;
  energies.bound_name = "asked up to what is allowed";
  std::vector<Stage> stages;
  for (const double noise : sweep.noises)
    stages.push_back(makeStage(sweep.stage, noise, unsigned(301 + seed)));
  for (const int delay : sweep.delays) {
    Wall late = sweep.loop;
    late.device.linkage.delay = delay;
    const double allowed = allowedFor(late, *stages.front().scene);
    std::vector<double> all{allowed};
    const double begun = defaultFor(late, *stages.front().scene);
    if (begun < allowed) all.push_back(begun);
    all.insert(all.end(), sweep.stiffnesses.begin(), sweep.stiffnesses.end());
    std::sort(all.begin(), all.end());
    Series amplitude{"delay " + std::to_string(delay), {}}, energy = amplitude;
    Worst amplitude_at_rest, given, more, farthest;
    int non_finite = 0, inside = 0, untouched = 0;
    for (const double K : all) {
      const bool judged = K <= allowed;
      PressResult worst;
      double clean = 0.0;  // J given without noise, which comes first
      worst.energy = -INFINITY;
      for (std::size_t n = 0; n < stages.size(); ++n) {
        const double noise = sweep.noises[n];
        const PressResult r = press(late, stages[n], K);
        worst.amplitude = std::max(worst.amplitude, r.amplitude);
        worst.energy = std::max(worst.energy, r.energy);
        if (n == 0) clean = r.energy;
        if (judged) {
          amplitude_at_rest.add(r.amplitude, K, noise);
          given.add(r.energy, K, noise);
          farthest.add(r.rise, K, noise);
          more.add(r.energy - clean, K, noise);
        }
        // of these nothing is forgiven, however stiff
        non_finite += r.non_finite;
        inside += r.inside;
        untouched += judged && r.contact < 400;
        (judged ? within : beyond)
            .rows.push_back(rowOf(sweep, "as shipped", delay, noise, K, allowed, r));
      }
      amplitude.points.push_back({K, 1e6 * worst.amplitude});
      energy.points.push_back({K, std::max(0.0, 1e3 * worst.energy)});
    }
    if (sweep.other_loops)
      addOtherLoops(beyond, sweep, late, stages.front(), sweep.noises.front(), allowed);
    amplitudes.series.push_back(std::move(amplitude));
    energies.series.push_back(std::move(energy));
    const std::string name = sweep.name() + "/delay " + std::to_string(delay);
    const std::string range = "up to " + shortly(allowed) + " N/m, which is allowed";
    outcome.cases.push_back({name + "/amplitude at rest", 1e6 * amplitude_at_rest.value,
                             3e6 * late.device.linkage.encoder, "um", Case::Sense::AtMost,
                             range + "; three steps of the encoder" + amplitude_at_rest.where});
    outcome.cases.push_back({name + "/energy given", 1e3 * given.value, 1.0, "mJ",
                             Case::Sense::AtMost, range + given.where});
    outcome.cases.push_back({name + "/energy given more than without noise", 1e3 * more.value, 1.0,
                             "mJ", Case::Sense::AtMost,
                             range + "; the proxy's detours are of noise alone" + more.where});
    outcome.cases.push_back({name + "/proxy's farthest rise", 1e6 * farthest.value,
                             1e6 * stages.front().scene->lengths.epsilon, "um", Case::Sense::AtMost,
                             range +
                                 "; a move against the spring within a tick, its energy over "
                                 "the force: asked to be within the contact tolerance, though "
                                 "the filter bounds how many there are, not how far" +
                                 farthest.where});
    outcome.cases.push_back({name + "/not finite", double(non_finite), 0.0, ""});
    outcome.cases.push_back({name + "/looks that found it inside", double(inside), 0.0, ""});
    outcome.cases.push_back({name + "/presses that missed", double(untouched), 0.0, ""});
  }
  outcome.tables.push_back(std::move(within));
  outcome.tables.push_back(std::move(beyond));
  outcome.plots = {std::move(amplitudes), std::move(energies)};
  return outcome;
}

}  // namespace

haptics::ClosedLoop loopOf(const Wall& wall, std::shared_ptr<const haptics::Scene> scene,
                           double isovalue, double stiffness, bool shipped) {
  const DeviceModel& device = wall.device;
  haptics::ClosedLoop loop;
  loop.settings.isovalue = isovalue;
  loop.settings.stiffness = stiffness;
  loop.limits = shipped ? haptics::limitsOf(device.rating)
                        : haptics::ForceLimits{device.rating.force, device.rating.torque};
  loop.grip = device.heldBy(wall.hand, std::sqrt(scene->tool.shell.inertia.trace() / 3.0));
  loop.linkage = device.linkage;
  loop.period = wall.period;
  loop.damping = wall.damping;
  loop.passivity_damping = wall.controller;
  loop.scene = std::move(scene);
  return loop;
}

Stage makeStage(const std::string& name, double noise, unsigned seed) {
  Stage stage{name, nullptr, 0.0, at(0, 0, 0), at(0, 0, 0)};
  double top = 0.0;
  Quat q = Quat::Identity();
  if (name == "plane") {
    stage.scene = sceneOf(ramp(noise, seed, [](const Vec3& p) { return p.z(); }),
                          toolOf(datasets::platePoints(6, 0.02)));
  } else if (name == "groove") {
    datasets::shapes::Wedge wedge;
    wedge.bottom = -0.008;
    stage.scene = sceneOf(ramp(noise, seed, [&](const Vec3& p) { return wedge.distance(p); }),
                          toolOf(datasets::rodPoints(100, 0.016, 2e-3)));
    q = Quat{Eigen::AngleAxisd{0.5 * std::numbers::pi, Vec3::UnitZ()}};
    top = wedge.bottom + 2e-3 / std::sin(wedge.half_angle);
  } else {
    stage.scene =
        sceneOf(ramp(noise, seed, [](const Vec3& p) { return p.norm() - 0.015; }), ball(100, 3e-3));
    top = 0.018;
    stage.deepest = 0.5 * top;  // of the way to the middle of the ball
  }
  stage.X_touch = at({0, 0, top}, q);
  stage.X_from = at({0, 0, top + 6e-3}, q);
  return stage;
}

double allowedFor(const Wall& wall, const haptics::Scene& scene) {
  const haptics::Linkage& linkage = wall.device.linkage;
  return haptics::allowedStiffness(wall.device.rating, scene.tool.shell,
                                   {wall.period, linkage.delay}, linkage.arm.norm());
}
double defaultFor(const Wall& wall, const haptics::Scene& scene) {
  return std::min(0.5 * wall.device.rating.stiffness, allowedFor(wall, scene));
}

PressResult press(const Wall& wall, const Stage& stage, double stiffness, bool shipped) {
  haptics::ClosedLoop loop = loopOf(wall, stage.scene, stage.isovalue, stiffness, shipped);

  // so deep that coupling and grip, springs in series, press with what is asked
  Pose X_deep = stage.X_touch;
  X_deep.translation().z() -=
      std::min(stage.deepest, std::min(kPress, 0.5 * wall.device.rating.force) *
                                  (1.0 / stiffness + 1.0 / wall.hand.stiffness));
  const double way = stage.X_from.translation().z() - X_deep.translation().z();
  const double begin = loop.limits.ramp_time;  // s: armed, in the air
  const double down = begin + 1.5 * way / kSpeed;
  // until what the arrival set off has died, to 1 %; beyond the limit it does not
  const double left = 1.0 - stiffness / wall.theory();
  const double decay = 0.5 * loop.grip.damping / loop.grip.mass * left;
  const double up = down + kRest + kSettle + (decay > 0.0 ? std::min(4.6 / decay, 4.0) : 0.0);
  std::vector<double> times;
  std::vector<Pose> poses;
  for (int n = 0; n <= 100; ++n) {
    const double u = 0.01 * n, share = u * u * (3.0 - 2.0 * u);
    times.push_back(begin + u * (down - begin));
    poses.push_back(stage.X_from);
    poses.back().translation().z() -= share * way;
  }
  for (int n = 0; n <= 100; ++n) {
    times.push_back(up + 0.01 * n * (down - begin));
    poses.push_back(poses[std::size_t(100 - n)]);
  }
  const haptics::Hand hand = haptics::Hand::along(std::move(times), std::move(poses)).value();

  PressResult result;
  Vec3 lowest = Vec3::Constant(INFINITY), highest = -lowest, force = Vec3::Zero();
  Pose X_WP_before;
  bool first = true;
  const auto springEnergy = [&](const Pose& X_WP, const Pose& X_WD) {
    return 0.5 * stiffness *
           stage.scene->metric.whitened(haptics::motionBetween(X_WP, X_WD), X_WP.linear())
               .squaredNorm();
  };
  // a little longer than the hand takes, for the device to follow it
  const auto ticks = std::int64_t(std::lround((up + (down - begin) + 0.15) / wall.period));
  std::int64_t tick = 0;
  const auto done = loop.run(hand, ticks, [&](const haptics::TraceRow& row) {
    result.contact += row.contacts > 0;
    result.energy = row.energy;
    result.share = row.stiffness_share;
    if (!row.X_WP.matrix().allFinite() || !std::isfinite(row.coupling_W.force.norm()) ||
        !std::isfinite(row.coupling_W.torque.norm()) || !row.X_WH.matrix().allFinite())
      ++result.non_finite;
    if (tick++ % 50 == 0)
      result.inside += !isOutside(*stage.scene->volume, stage.isovalue,
                                  stage.scene->tool.shell.points, row.X_WP);
    if (!first) {
      const double rise = springEnergy(row.X_WP, row.X_WD) - springEnergy(X_WP_before, row.X_WD);
      result.risen += std::max(0.0, rise);
      const double pull = std::sqrt(2.0 * stiffness * springEnergy(X_WP_before, row.X_WD));
      if (pull > 0.1) result.rise = std::max(result.rise, rise / pull);
    }
    if (row.time >= up - kRest && row.time < up) {
      const Vec3 p = row.X_WH.translation();
      lowest = lowest.cwiseMin(p);
      highest = highest.cwiseMax(p);
      result.force_step = std::max(result.force_step, (row.sent_W.force - force).norm());
    }
    force = row.sent_W.force;
    X_WP_before = row.X_WP;
    first = false;
    return true;
  });
  if (!done) result.non_finite = int(ticks);
  result.amplitude = 0.5 * (highest - lowest).norm();
  return result;
}

std::vector<Job> pressJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  const std::vector<double> stiffnesses =
      full ? std::vector<double>{50, 200, 500, 1000, 2000, 3500, 5000, 7000, 10000, 14000, 20000}
           : std::vector<double>{50, 1000, 20000};
  const std::vector<double> noises =
      full ? std::vector<double>{0.0, 0.005, 0.02, 0.05, 0.1} : std::vector<double>{0.0, 0.02, 0.1};
  const std::vector<int> delays = full ? std::vector<int>{0, 1, 2, 4} : std::vector<int>{0, 1, 4};
  // one of each kind of mass, encoder and motors; full has all
  const std::set<std::string> quick{"falcon", "delta.3",     "omega.7", "sigma.7",
                                    "touch",  "premium-1.5", "polhem",  "omni-arm-200"};
  // run in other loops as well: a coarse encoder, torque motors, the stiffest, the weakest
  const std::set<std::string> varied =
      full ? std::set<std::string>{"falcon", "sigma.7", "lambda.7", "touch"}
           : std::set<std::string>{"sigma.7"};
  std::vector<Job> jobs;
  const auto add = [&](double cost, const Sweep& sweep) {
    jobs.push_back({sweep.name(), kPressSection, cost,
                    [=](std::uint64_t seed) { return pressesOf(sweep, seed); }});
  };
  for (const DeviceModel& device : haptics::deviceModels())
    for (const std::string& stage : kStages) {
      const bool other_loops = varied.contains(device.name) && (full || stage == "ball");
      const Wall loop{device};
      Sweep sweep{device.name, stage, loop, stiffnesses, delays, noises, other_loops};
      if (full || quick.contains(device.name)) add(full ? 10.0 : 1.0, sweep);
      if (!full && !other_loops) continue;
      sweep.loop.period = 0.25e-3;
      if (full) {
        sweep.stiffnesses = {50, 1000, 5000, 20000};
      } else {
        sweep.stiffnesses = {1000};
        sweep.delays = {0, 1};
      }
      add(4.0, sweep);
    }
  return jobs;
}

}  // namespace study::stability
