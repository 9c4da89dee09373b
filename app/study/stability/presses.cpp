// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/presses.h"

#include <numbers>
#include <set>

#include "app/study/stability/failures.h"
#include "app/study/stability/limits.h"
#include "app/study/stability/stability.h"
#include "datasets/phantoms/shapes.h"
#include "haptics/coupling/passivity.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/simulation/allowed_stiffness.h"

namespace study::stability {
namespace {

using haptics::TraceRow;

constexpr double kPress = 2.0;   // N
constexpr double kSpeed = 0.06;  // m/s, of the hand at its fastest
constexpr double kRest = 0.2;    // s
constexpr double kSettle = 0.8;  // s: a handle on noise finds its place, ringing at some 7 Hz

/// What a sweep goes through, and how the loop is run.
struct Sweep {
  std::string stage;
  Wall loop;
  std::vector<double> stiffnesses;  ///< beside the default and what is allowed
  std::vector<int> delays;
  std::vector<double> noises;  ///< the first is none
  bool other_loops = false;    ///< also without the guard and with what is not shipped
  /// Names it with something between its parts.
  std::string name(const std::string& between) const {
    return loop.device.name + between + stage +
           (loop.period < 1e-3 ? between + rateOf(loop.period) : "");
  }
};

/// All that are tried with one delay, the softest first.
std::vector<Way> waysWith(const Sweep& sweep, const Wall& wall, double allowed) {
  std::vector<double> stiffnesses{allowed};
  const double begun = 0.5 * wall.device.rating.stiffness;  // what the program begins with
  if (begun < allowed) stiffnesses.push_back(begun);
  stiffnesses.insert(stiffnesses.end(), sweep.stiffnesses.begin(), sweep.stiffnesses.end());
  std::sort(stiffnesses.begin(), stiffnesses.end());
  std::vector<Way> all;
  for (const double K : stiffnesses) all.push_back({"as shipped", wall, K, true});
  if (!sweep.other_loops) return all;
  for (const double share : {1.0, 1.6, 4.0})
    for (const Loop& loop : kLoops)
      all.push_back({loop.unguarded, withLoop(wall, loop), share * allowed});
  return all;
}

/// A case of the presses at what is allowed: the greatest of a figure, and where it was.
struct Worst {
  const char *what, *unit;
  double scale, bound;  ///< from SI to the unit; in the unit
  const char* note;
  double (*of)(const PressResult&, double clean);  ///< clean: J given without noise
  double value = -INFINITY;
  std::string where = {};
  void add(double figure, double stiffness, double noise) {
    const double now = worse(value, figure);
    if (now <= value) return;
    value = now;
    where = "; worst at " + shortly(stiffness) + " N/m, noise of " + shortly(100.0 * noise) + " %";
  }
};

Outcome pressesOf(const Sweep& sweep, unsigned seed) {
  Findings found;
  found.plot(sweep.name(", ") + ": amplitude at rest",
             "Worst over the noise, for each delay, also beyond what is allowed: the encoder's own "
             "step up to the limit of the sampled spring",
             {"stiffness [N/m]", Scale::Log}, {"amplitude at rest [um]", Scale::Log});
  found.plot(sweep.name(", ") + ": energy given in a press",
             "Worst over the noise, for each delay, also beyond what is allowed; in the lane of "
             "zero: the loop took energy. It announces the limit before the amplitude does",
             {"stiffness [N/m]", Scale::Log}, {"energy given in a press [mJ]", Scale::Log});
  Plot &amplitudes = found.outcome.plots[0], &energies = found.outcome.plots[1];
  const double encoder_steps = 3e6 * sweep.loop.device.linkage.encoder;
  amplitudes.bound = encoder_steps;
  amplitudes.bound_name = "three steps of the encoder";
  energies.bound = 1.0;
  energies.bound_name = "asked up to what is allowed";
  std::vector<Stage> stages;
  for (const double noise : sweep.noises)
    stages.push_back(makeStage(sweep.stage, noise, 301 + seed));
  for (const int delay : sweep.delays) {
    Wall wall = sweep.loop;
    wall.device.linkage.delay = delay;
    const double allowed = allowedFor(wall, *stages.front().scene);
    Worst cases[] = {
        {"amplitude at rest", "um", 1e6, encoder_steps, "; three steps of the encoder",
         [](const PressResult& r, double) { return r.amplitude; }},
        {"energy given", "mJ", 1e3, 1.0, "", [](const PressResult& r, double) { return r.energy; }},
        {"energy given more than without noise", "mJ", 1e3, 1.0,
         "; the proxy's detours are of noise alone",
         [](const PressResult& r, double clean) { return r.energy - clean; }},
        {"proxy's farthest rise", "um", 1e6, 1e6 * stages.front().scene->lengths.epsilon,
         "; a move against the spring within a tick, its energy over the force: asked to be within "
         "the contact tolerance, though the filter bounds how many there are, not how far",
         [](const PressResult& r, double) { return r.rise; }}};
    Series amplitude{"delay " + std::to_string(delay), {}}, energy = amplitude;
    int non_finite = 0, inside = 0, untouched = 0;
    double clean = 0.0;
    for (const Way& way : waysWith(sweep, wall, allowed))
      for (std::size_t n = 0; n < (way.shipped ? stages.size() : 1); ++n) {
        const double K = way.stiffness, noise = sweep.noises[n];
        const bool judged = way.shipped && K <= allowed;
        const PressResult r = press(way.wall, stages[n], K, way.shipped);
        found.row(judged ? "Presses, as shipped" : "Beyond what is allowed, and without the guard",
                  {{"device", wall.device.name},
                   {"scene", sweep.stage},
                   {"rate", rateOf(sweep.loop.period)},
                   {"loop", way.loop},
                   {"delay", std::to_string(delay)},
                   {"noise [%]", shortly(100.0 * noise)},
                   {"K [N/m]", shortly(K)},
                   {"of what is allowed", shortly(K / allowed)},
                   {"amplitude [um]", shortly(1e6 * r.amplitude)},
                   {"force step [N]", shortly(r.force_step)},
                   {"energy given [mJ]", shortly(1e3 * r.energy)},
                   {"proxy's rises, sum [mJ]", shortly(1e3 * r.risen)},
                   {"farthest rise [um]", shortly(1e6 * r.rise)},
                   {"left by the guard", shortly(r.share)},
                   {"contact", std::to_string(r.contact)}});
        if (!way.shipped) continue;
        // of these nothing is forgiven, however stiff
        non_finite += r.non_finite;
        inside += r.inside;
        untouched += judged && r.contact < 400;
        if (n == 0) {
          clean = r.energy;
          amplitude.points.push_back({K, 0.0});
          energy.points.push_back({K, 0.0});
        }
        double &highest = amplitude.points.back().y, &most = energy.points.back().y;
        highest = std::max(highest, 1e6 * r.amplitude);
        most = std::max(most, 1e3 * r.energy);
        if (!judged) continue;
        for (Worst& worst : cases) worst.add(worst.of(r, clean), K, noise);
      }
    amplitudes.series.push_back(std::move(amplitude));
    energies.series.push_back(std::move(energy));
    found.subject = "press/" + sweep.name("/") + "/delay " + std::to_string(delay);
    for (const Worst& worst : cases)
      found.atMost(
          worst.what, worst.scale * worst.value, worst.bound, worst.unit,
          "up to " + shortly(allowed) + " N/m, which is allowed" + worst.note + worst.where);
    found.none("not finite", non_finite);
    found.none("looks that found it inside", inside);
    found.none("presses that missed", untouched);
  }
  return std::move(found.outcome);
}

}  // namespace

haptics::ClosedLoop loopOf(const Wall& wall, std::shared_ptr<const haptics::Scene> scene,
                           double isovalue, double stiffness, bool shipped) {
  const haptics::DeviceModel& device = wall.device;
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

LoopResult runLoop(haptics::ClosedLoop& loop, const haptics::Hand& hand, std::int64_t ticks,
                   int look, const std::function<void(const TraceRow&, const TraceRow*)>& each) {
  LoopResult result;
  std::optional<TraceRow> before;
  std::int64_t tick = 0;
  const auto done = loop.run(hand, ticks, [&](const TraceRow& row) {
    result.energy = row.energy;
    result.share = row.stiffness_share;
    result.contact += row.contacts > 0;
    result.non_finite += !row.X_WP.matrix().allFinite() || !row.X_WH.matrix().allFinite() ||
                         !std::isfinite(row.coupling_W.force.norm()) ||
                         !std::isfinite(row.coupling_W.torque.norm());
    if (tick++ % look == 0)
      result.inside += !isOutside(*loop.scene->volume, loop.settings.isovalue,
                                  loop.scene->tool.shell.points, row.X_WP);
    each(row, before ? &*before : nullptr);
    before = row;
    return true;
  });
  if (done) return result;
  result.non_finite = int(ticks);
  result.refused = done.error();
  return result;
}

Stage makeStage(const std::string& name, double noise, unsigned seed) {
  static const datasets::shapes::Wedge wedge{.bottom = -0.008};
  struct Row {
    std::string name;
    double (*distance)(const Vec3&);
    std::vector<Vec3> points;
    double touch, angle, deepest;  // m, height of the tool; rad, about z; m
  };
  for (const Row& row :
       {Row{"plane", [](const Vec3& p) { return p.z(); }, datasets::platePoints(6, 0.02), 0.0, 0.0,
            INFINITY},
        Row{"groove", [](const Vec3& p) { return wedge.distance(p); },
            datasets::rodPoints(100, 0.016, 2e-3), wedge.bottom + 2e-3 / std::sin(wedge.half_angle),
            0.5 * std::numbers::pi, INFINITY},
        // half of the way to the middle of the ball
        Row{"ball", [](const Vec3& p) { return p.norm() - 0.015; }, datasets::ballPoints(100, 3e-3),
            0.018, 0.0, 0.009}}) {
    if (row.name != name) continue;
    return {sceneOf(ramp(noise, seed, row.distance), toolOf(row.points)),
            at({0, 0, row.touch}, turn(row.angle, Vec3::UnitZ())), row.deepest};
  }
  return {};
}

double allowedFor(const Wall& wall, const haptics::Scene& scene) {
  const haptics::Linkage& linkage = wall.device.linkage;
  return haptics::allowedStiffness(wall.device.rating, scene.tool.shell,
                                   {wall.period, linkage.delay}, linkage.arm.norm());
}

PressResult press(const Wall& wall, const Stage& stage, double stiffness, bool shipped) {
  haptics::ClosedLoop loop = loopOf(wall, stage.scene, 0.0, stiffness, shipped);

  // so deep that coupling and grip, springs in series, press with what is asked
  const double deep = std::min(stage.deepest, std::min(kPress, 0.5 * wall.device.rating.force) *
                                                  (1.0 / stiffness + 1.0 / wall.hand.stiffness));
  Pose X_from = stage.X_touch;  // in the air
  X_from.translation().z() += 6e-3;
  const double way = X_from.translation().z() - (stage.X_touch.translation().z() - deep);
  const double begin = loop.limits.ramp_time;  // s: armed
  const double down = begin + 1.5 * way / kSpeed;
  // until what the arrival set off has died, to 1 %; beyond the limit it does not
  const double left = 1.0 - stiffness / wall.theory();
  const double decay = 0.5 * loop.grip.damping / loop.grip.mass * left;
  const double up = down + kRest + kSettle + (decay > 0.0 ? std::min(4.6 / decay, 4.0) : 0.0);
  std::vector<double> times;
  std::vector<Pose> poses;
  for (int n = 0; n <= 201; ++n) {
    const double u = 0.01 * (n <= 100 ? n : 201 - n), share = u * u * (3.0 - 2.0 * u);
    times.push_back((n <= 100 ? begin : up) + 0.01 * (n % 101) * (down - begin));
    poses.push_back(X_from);
    poses.back().translation().z() -= share * way;
  }
  const haptics::Hand hand = haptics::Hand::along(std::move(times), std::move(poses)).value();

  PressResult result;
  Vec3 lowest = Vec3::Constant(INFINITY), highest = -lowest;
  const auto springEnergy = [&](const Pose& X_WP, const Pose& X_WD) {
    return 0.5 * stiffness *
           stage.scene->metric.whitened(haptics::motionBetween(X_WP, X_WD), X_WP.linear())
               .squaredNorm();
  };
  // a little longer than the hand takes, for the device to follow it
  const auto ticks = std::lround((up + (down - begin) + 0.15) / wall.period);
  const auto look = [&](const TraceRow& row, const TraceRow* before) {
    if (!before) return;
    const double pulled = springEnergy(before->X_WP, row.X_WD);
    const double rise = springEnergy(row.X_WP, row.X_WD) - pulled;
    result.risen += std::max(0.0, rise);
    const double pull = std::sqrt(2.0 * stiffness * pulled);
    if (pull > 0.1) result.rise = std::max(result.rise, rise / pull);
    if (row.time < up - kRest || row.time >= up) return;
    lowest = lowest.cwiseMin(row.X_WH.translation());
    highest = highest.cwiseMax(row.X_WH.translation());
    result.force_step =
        std::max(result.force_step, (row.sent_W.force - before->sent_W.force).norm());
  };
  static_cast<LoopResult&>(result) = runLoop(loop, hand, ticks, 50, look);
  result.amplitude = 0.5 * (highest - lowest).norm();
  return result;
}

std::vector<Job> pressJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  const std::vector<double> few{0.0, 0.02, 0.1}, all{0.0, 0.005, 0.02, 0.05, 0.1};
  /// What is pressed at one rate.
  struct Rate {
    Depth depth;
    double period, cost;  // s
    std::vector<double> stiffnesses;
    std::vector<int> delays;
    std::vector<double> noises;
  };
  const Rate rates[] = {{Depth::Quick, 1e-3, 1.0, {50, 1000, 20000}, {0, 1, 4}, few},
                        {Depth::Quick, 0.25e-3, 4.0, {1000}, {0, 1}, few},
                        {Depth::Full,
                         1e-3,
                         10.0,
                         {50, 200, 500, 1000, 2000, 3500, 5000, 7000, 10000, 14000, 20000},
                         {0, 1, 2, 4},
                         all},
                        {Depth::Full, 0.25e-3, 4.0, {50, 1000, 5000, 20000}, {0, 1, 2, 4}, all}};
  // one of each kind of mass, encoder and motors; full has all
  const std::set<std::string> quick{"falcon", "delta.3",     "omega.7", "sigma.7",
                                    "touch",  "premium-1.5", "polhem",  "omni-arm-200"};
  // run in other loops as well: a coarse encoder, torque motors, the stiffest, the weakest
  const std::set<std::string> varied =
      full ? std::set<std::string>{"falcon", "sigma.7", "lambda.7", "touch"}
           : std::set<std::string>{"sigma.7"};
  std::vector<Job> jobs;
  for (const haptics::DeviceModel& device : haptics::deviceModels())
    for (const std::string stage : {"plane", "groove", "ball"})
      for (const Rate& rate : rates) {
        const bool other_loops = varied.contains(device.name) && (full || stage == "ball");
        if (rate.depth != depth) continue;
        if (!full && !(rate.period == 1e-3 ? quick.contains(device.name) : other_loops)) continue;
        const Sweep sweep{
            stage,      Wall{device, {}, rate.period}, rate.stiffnesses, rate.delays, rate.noises,
            other_loops};
        jobs.push_back({"press/" + sweep.name("/"), "Presses in six degrees of freedom", rate.cost,
                        [=](std::uint64_t seed) { return pressesOf(sweep, unsigned(seed)); }});
      }
  return jobs;
}

}  // namespace study::stability
