// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/presses.h"

#include <cmath>
#include <numbers>
#include <set>

#include "app/study/stability/failures.h"
#include "app/study/stability/wall.h"
#include "datasets/phantoms/shapes.h"
#include "haptics/coupling/passivity.h"

namespace study {
namespace {

using haptics::DeviceModel;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;

const char* const kPressSection = "Presses in six degrees of freedom";
constexpr double kPress = 2.0;              // N
constexpr double kSpeed = 0.06;             // m/s, of the hand at its fastest
constexpr double kHold = 0.6, kRest = 0.2;  // s

template <class Distance>
haptics::Volume ramp(double noise, unsigned seed, Distance&& distance) {
  std::mt19937 engine{seed};
  std::normal_distribution<double> grain{0.0, 1.0};
  return datasets::sampledFloat(failures::cube(48), [&](const Vec3& p) {
    return std::clamp(-1e5 * distance(p), -300.0, 300.0) +
           (noise > 0.0 ? 600.0 * noise * grain(engine) : 0.0);
  });
}

/// What a sweep goes through, and how the loop is run.
struct Sweep {
  std::string device, stage;
  std::string variant;  ///< empty, or what of the loop is other than plain, with a ", " before it
  Wall loop;
  std::vector<double> stiffnesses;
  std::vector<int> delays;
  std::vector<double> noises;       ///< with no delay or one; the first is none
  std::vector<double> late_noises;  ///< with more; a part of `noises`, the first is none
  std::string name() const {
    return "press/" + device + "/" + stage + (variant.empty() ? "" : "/" + variant.substr(2));
  }
};

/// The greatest of some figures, and where it was.
struct Worst {
  double value = -INFINITY;
  std::string where;
  void add(double figure, double stiffness, double noise) {
    const double now = worse(value, figure);
    if (now <= value) return;
    value = now;
    where = "; worst at " + shortly(stiffness) + " N/m, noise of " + shortly(100.0 * noise) + " %";
  }
};

Outcome pressesOf(const Sweep& sweep, std::uint64_t seed) {
  Outcome outcome;
  Table table{"Presses",
              {"device", "scene", "loop", "delay", "noise [%]", "K [N/m]", "amplitude [um]",
               "force step [N]", "energy given [mJ]", "proxy's rises, sum [mJ]",
               "farthest rise [um]", "contact"},
              {}};
  const auto plot = [&](const char* what, const char* unit, const char* description) {
    return Plot{sweep.device + ", " + sweep.stage + sweep.variant + ": " + what,
                description,
                {"stiffness [N/m]", Scale::Log},
                {std::string{what} + " [" + unit + "]", Scale::Log}};
  };
  Plot amplitudes = plot("amplitude at rest", "um",
                         "Worst over the noise, for each delay: the encoder's own step up to the "
                         "limit of the sampled spring, far more beyond");
  Plot energies = plot("energy given in a press", "mJ",
                       "Worst over the noise, for each delay; in the lane of zero: the loop took "
                       "energy. It announces the limit before the amplitude does");
  amplitudes.bound = 3e6 * sweep.loop.device.linkage.encoder;
  amplitudes.bound_name = "three steps of the encoder";
  energies.bound = 1.0;
  energies.bound_name = "allowed up to 0.8 of the limit";
  std::vector<Stage> stages;
  for (const double noise : sweep.noises)
    stages.push_back(makeStage(sweep.stage, noise, unsigned(301 + seed)));
  for (const int delay : sweep.delays) {
    Wall late = sweep.loop;
    late.device.linkage.delay = delay;
    const std::vector<double>& noises = delay > 1 ? sweep.late_noises : sweep.noises;
    // all is held to its bound up to 0.8 of the sampled spring's limit, as asked, and energies once
    // more up to half of it, which is what the coupling should be allowed
    const double ceiling = ceilingOf(late, stages.front(), 0.8),
                 allowed = ceilingOf(late, stages.front(), 0.5);
    std::vector<double> all{ceiling};
    if (allowed < ceiling) all.push_back(allowed);
    all.insert(all.end(), sweep.stiffnesses.begin(), sweep.stiffnesses.end());
    std::sort(all.begin(), all.end());
    Series amplitude{"delay " + std::to_string(delay), {}}, energy = amplitude;
    Worst amplitude_at_rest, given, given_allowed, more, farthest;
    int non_finite = 0, inside = 0, untouched = 0;
    for (const double K : all) {
      PressResult worst;
      double clean = 0.0;  // J given without noise, which comes first
      worst.energy = -INFINITY;
      for (std::size_t n = 0; n < noises.size(); ++n) {
        const auto stage = std::find(sweep.noises.begin(), sweep.noises.end(), noises[n]);
        const PressResult r = press(late, stages[std::size_t(stage - sweep.noises.begin())], K);
        worst.amplitude = std::max(worst.amplitude, r.amplitude);
        worst.energy = std::max(worst.energy, r.energy);
        if (n == 0) clean = r.energy;
        if (K <= ceiling) {
          amplitude_at_rest.add(r.amplitude, K, noises[n]);
          given.add(r.energy, K, noises[n]);
          farthest.add(r.rise, K, noises[n]);
        }
        if (K <= allowed) {
          given_allowed.add(r.energy, K, noises[n]);
          more.add(r.energy - clean, K, noises[n]);
        }
        non_finite += r.non_finite;
        inside += r.inside;
        untouched += K <= ceiling && r.contact < 400;
        table.rows.push_back(
            {sweep.device, sweep.stage, sweep.variant.empty() ? "plain" : sweep.variant.substr(2),
             std::to_string(delay), shortly(100.0 * noises[n]), shortly(K),
             shortly(1e6 * r.amplitude), shortly(r.force_step), shortly(1e3 * r.energy),
             shortly(1e3 * r.risen), shortly(1e6 * r.rise), std::to_string(r.contact)});
      }
      amplitude.points.push_back({K, 1e6 * worst.amplitude});
      energy.points.push_back({K, std::max(0.0, 1e3 * worst.energy)});
    }
    amplitudes.series.push_back(std::move(amplitude));
    energies.series.push_back(std::move(energy));
    const std::string name = sweep.name() + "/delay " + std::to_string(delay);
    const std::string range = "up to " + shortly(ceiling) + " N/m";
    const std::string range_allowed = "up to " + shortly(allowed) + " N/m";
    outcome.cases.push_back({name + "/amplitude at rest", 1e6 * amplitude_at_rest.value,
                             3e6 * late.device.linkage.encoder, "um", Case::Sense::AtMost,
                             range + "; three steps of the encoder" + amplitude_at_rest.where});
    outcome.cases.push_back({name + "/energy given, as asked", 1e3 * given.value, 1.0, "mJ",
                             Case::Sense::AtMost,
                             range +
                                 ", the rating or 0.8 of the sampled spring's limit. Near its "
                                 "limit what the arrival set off shakes for long, and each "
                                 "stroke gives some energy before the hand damps it away" +
                                 given.where});
    outcome.cases.push_back(
        {name + "/energy given, up to half the limit", 1e3 * given_allowed.value, 1.0, "mJ",
         Case::Sense::AtMost,
         range_allowed + ": what the coupling should be allowed" + given_allowed.where});
    outcome.cases.push_back(
        {name + "/energy given more than without noise", 1e3 * more.value, 1.0, "mJ",
         Case::Sense::AtMost,
         range_allowed + "; the proxy's detours are of noise alone" + more.where});
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
  outcome.tables.push_back(std::move(table));
  outcome.plots = {std::move(amplitudes), std::move(energies)};
  return outcome;
}

}  // namespace

haptics::ClosedLoop loopOf(const Wall& wall, std::shared_ptr<const haptics::Scene> scene,
                           double isovalue, double stiffness) {
  const DeviceModel& device = wall.device;
  haptics::ClosedLoop loop;
  loop.settings.isovalue = isovalue;
  loop.settings.stiffness = stiffness;
  loop.limits = {device.rating.force, device.rating.torque, 0.0, 0.02};
  loop.grip = device.heldBy(wall.hand, std::sqrt(scene->tool.shell.inertia.trace() / 3.0));
  loop.linkage = device.linkage;
  loop.period = wall.period;
  loop.damping = wall.damping;
  loop.passivity_damping = wall.controller;
  loop.scene = std::move(scene);
  return loop;
}

Stage makeStage(const std::string& name, double noise, unsigned seed) {
  using failures::at;
  Stage stage{name, nullptr, 0.0, at(0, 0, 0), at(0, 0, 0)};
  double top = 0.0;
  Quat q = Quat::Identity();
  if (name == "plane") {
    stage.scene = made::scene(ramp(noise, seed, [](const Vec3& p) { return p.z(); }),
                              made::tool(datasets::platePoints(6, 0.02)));
  } else if (name == "groove") {
    datasets::shapes::Wedge wedge;
    wedge.bottom = -0.008;
    stage.scene = made::scene(ramp(noise, seed, [&](const Vec3& p) { return wedge.distance(p); }),
                              made::tool(datasets::rodPoints(100, 0.016, 2e-3)));
    q = Quat{Eigen::AngleAxisd{0.5 * std::numbers::pi, Vec3::UnitZ()}};
    top = wedge.bottom + 2e-3 / std::sin(wedge.half_angle);
  } else {
    stage.scene = made::scene(ramp(noise, seed, [](const Vec3& p) { return p.norm() - 0.015; }),
                              failures::ball(100, 3e-3));
    top = 0.018;
    stage.deepest = 0.5 * top;  // of the way to the middle of the ball
  }
  stage.X_touch = at({0, 0, top}, q);
  stage.X_from = at({0, 0, top + 6e-3}, q);
  return stage;
}

double ceilingOf(const Wall& wall, const Stage& stage, double share) {
  double limit = share * wall.theory();
  if (wall.device.linkage.torque) {
    const haptics::Mat3& inertia = stage.scene->tool.shell.inertia;
    limit *= inertia.trace() / 3.0 / haptics::largestInertia(inertia);
  }
  return std::min(wall.device.rating.stiffness, limit);
}

PressResult press(const Wall& wall, const Stage& stage, double stiffness) {
  haptics::ClosedLoop loop = loopOf(wall, stage.scene, stage.isovalue, stiffness);

  // so deep that coupling and grip, springs in series, press with what is asked
  Pose X_deep = stage.X_touch;
  X_deep.translation().z() -=
      std::min(stage.deepest, std::min(kPress, 0.5 * wall.device.rating.force) *
                                  (1.0 / stiffness + 1.0 / wall.hand.stiffness));
  const double way = stage.X_from.translation().z() - X_deep.translation().z();
  const double down = 1.5 * way / kSpeed;
  // until what the arrival set off has died, to 1 %; beyond the limit it does not
  const double left = 1.0 - stiffness / wall.theory();
  const double decay = 0.5 * loop.grip.damping / loop.grip.mass * left;
  const double up = down + kRest + 0.3 + (decay > 0.0 ? std::min(4.6 / decay, 4.0) : 0.0);
  std::vector<double> times;
  std::vector<Pose> poses;
  for (int n = 0; n <= 100; ++n) {
    const double u = 0.01 * n, share = u * u * (3.0 - 2.0 * u);
    times.push_back(u * down);
    poses.push_back(stage.X_from);
    poses.back().translation().z() -= share * way;
  }
  for (int n = 0; n <= 100; ++n) {
    times.push_back(up + 0.01 * n * down);
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
  const auto ticks = std::int64_t(std::lround((up + down + 0.15) / wall.period));
  std::int64_t tick = 0;
  const auto done = loop.run(hand, ticks, [&](const haptics::TraceRow& row) {
    result.contact += row.contacts > 0;
    result.energy = row.energy;
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
           : std::vector<double>{50, 1000, 5000, 20000};
  const std::vector<double> noises =
      full ? std::vector<double>{0.0, 0.005, 0.02, 0.05, 0.1} : std::vector<double>{0.0, 0.02};
  const std::vector<int> delays = full ? std::vector<int>{0, 1, 2, 4} : std::vector<int>{0, 1};
  // one of each kind of mass, encoder and motors; full has all
  const std::set<std::string> quick{"falcon", "delta.3",     "omega.7", "sigma.7",
                                    "touch",  "premium-1.5", "polhem",  "omni-arm-200"};
  // run in other ways as well: a coarse encoder, torque motors, the stiffest, the weakest
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
      const Wall loop{device};
      if (full || quick.contains(device.name)) {
        const Sweep all{
            device.name, stage,  "",     loop,
            stiffnesses, delays, noises, full ? std::vector<double>{0.0, 0.02, 0.1} : noises};
        add(full ? 10.0 : 1.0, all);
      }
      if (!varied.contains(device.name) || !(full || stage == "ball")) continue;
      const std::vector<double> some =
          full ? std::vector<double>{0.0, 0.02, 0.05} : std::vector<double>{0.0, 0.02};
      const Sweep plain{device.name, stage, "", loop, {1000, 5000, 20000}, {0, 1}, some, {}};
      Sweep fast = plain, damped = plain, controlled = plain;
      fast.variant = ", 4 kHz";
      fast.loop.period = 0.25e-3;
      add(4.0, fast);
      damped.variant = ", virtual damping";
      damped.loop.damping = 0.25 * device.rating.damping;
      add(1.0, damped);
      controlled.variant = ", passivity controller";
      controlled.loop.controller = device.rating.damping;
      add(1.0, controlled);
    }
  return jobs;
}

}  // namespace study
