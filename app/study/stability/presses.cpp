// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>
#include <set>

#include "app/study/comparison/course.h"
#include "app/study/stability/failures.h"
#include "app/study/stability/loops.h"
#include "haptics/coupling/passivity.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/simulation/allowed_stiffness.h"

namespace study::stability {
namespace {

constexpr double kPress = 2.0;      // N
constexpr double kSpeed = 0.06;     // m/s, of the hand at its fastest
constexpr double kRest = 0.2;       // s
constexpr double kSlow = 0.03;      // m/s, of a hand that goes along corners, at its fastest
constexpr double kFollowing = 0.3;  // s, for the device to follow it
constexpr double kSettle = 0.8;     // s: a handle on noise finds its place, ringing at some 7 Hz

/// s, from one corner of a way to the next.
double timeOf(const Vec3& step) { return std::max(0.3, 1.5 * step.norm() / kSlow); }

/// What a device presses with on a stage.
struct Sweep {
  Depth depth;
  double period, cost;              ///< s
  std::vector<double> stiffnesses;  ///< beside the default and what is allowed
  std::vector<double> delays;       ///< periods; beside the device's own, at its own rate
  std::vector<double> noises;       ///< the first is none
};

/// All that are tried with one delay, the softest first; in `other_loops` also without the guard
/// and with what is not shipped.
std::vector<Way> waysWith(const Sweep& sweep, const Wall& wall, double allowed, bool other_loops) {
  std::vector<double> stiffnesses = sweep.stiffnesses;
  stiffnesses.push_back(allowed);
  const double begun = 0.5 * wall.device.rating.stiffness;  // what the program begins with
  if (begun < allowed) stiffnesses.push_back(begun);
  std::ranges::sort(stiffnesses);
  std::vector<Way> all;
  for (const double K : stiffnesses) all.push_back({wall, K, true, "as shipped"});
  if (!other_loops) return all;
  for (const double share : {1.0, 1.6, 4.0})
    for (const Loop& loop : kLoops)
      all.push_back({withLoop(wall, loop), share * allowed, false, loop.unguarded});
  return all;
}

Outcome pressesOf(const std::string& job, const std::string& stage, Wall wall, const Sweep& sweep,
                  bool other_loops, unsigned seed) {
  Findings found;
  Plot& plot = found.plot(
      job + ": energy given in a press",
      "Worst over the noise, for each delay, also beyond what is allowed; in the lane of zero: the "
      "loop took energy. It announces the limit before the amplitude at rest does",
      {"stiffness [N/m]", Scale::Log}, {"energy given in a press [mJ]", Scale::Log});
  plot.bound = 1.0;
  plot.bound_name = "asked up to what is allowed";
  std::vector<Stage> stages;
  for (const double noise : sweep.noises) stages.push_back(makeStage(stage, noise, 301 + seed));
  const Wall shipped = asShipped(wall.device);
  std::set<double> delays{sweep.delays.begin(), sweep.delays.end()};
  if (wall.period == shipped.period) delays.insert(shipped.device.linkage.delay);
  for (const double delay : delays) {
    wall.device.linkage.delay = delay;
    const bool own = wall.period == shipped.period && delay == shipped.device.linkage.delay;
    wall.lead = own ? shipped.lead : 0.0;
    const double allowed = allowedFor(wall, *stages.front().scene);
    // the worst of each figure up to what is allowed, as it comes
    found.subject = job + "/delay " + shortly(delay);
    const std::string range = "up to " + shortly(allowed) + " N/m, which is allowed";
    const std::size_t first = found.outcome.cases.size();
    found.atMost("amplitude at rest", -INFINITY, 3e6 * wall.device.linkage.encoder, "um",
                 range + "; three steps of the encoder");
    found.atMost("energy given", -INFINITY, 1.0, "mJ", range);
    found.atMost("energy given more than without noise", -INFINITY, 1.0, "mJ",
                 range + "; the proxy's detours are of noise alone");
    found.atMost("proxy's farthest rise", -INFINITY, 1e6 * stages.front().scene->lengths.epsilon,
                 "um",
                 range +
                     "; a move against the spring within a tick, its energy over the force: "
                     "the filter takes no pose that rises by more than the contact tolerance");
    std::string where[4];
    std::vector<PlotPoint>& given =
        plot.series.emplace_back(Series{"delay " + shortly(delay), {}}).points;
    int non_finite = 0, inside = 0, untouched = 0;
    double clean = 0.0;  // J given without noise
    for (const Way& way : waysWith(sweep, wall, allowed, other_loops))
      for (std::size_t n = 0; n < (way.shipped ? stages.size() : 1); ++n) {
        const double K = way.stiffness, noise = sweep.noises[n];
        const bool judged = way.shipped && K <= allowed;
        const LoopResult r = press(way, stages[n]);
        found.row(judged ? "Presses, as shipped" : "Beyond what is allowed, and without the guard",
                  {{"device", wall.device.name},
                   {"scene", stage},
                   {"rate", rateOf(wall.period)},
                   {"loop", way.name},
                   {"delay", shortly(delay)},
                   {"its own", own ? "yes" : ""},
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
          given.push_back({K, 0.0});
        }
        given.back().y = std::max(given.back().y, 1e3 * r.energy);
        const double figures[] = {1e6 * r.amplitude, 1e3 * r.energy, 1e3 * (r.energy - clean),
                                  1e6 * r.rise};
        for (std::size_t c = 0; judged && c < std::size(figures); ++c) {
          double& worst = found.outcome.cases[first + c].value;
          if (worse(worst, figures[c]) <= worst) continue;
          worst = worse(worst, figures[c]);
          where[c] = "; worst at " + shortly(K) + " N/m, noise of " + shortly(100.0 * noise) + " %";
        }
      }
    for (std::size_t c = 0; c < std::size(where); ++c)
      found.outcome.cases[first + c].note += where[c];
    found.none("not finite", non_finite);
    found.none("looks that found it inside", inside);
    found.none("presses that missed", untouched);
  }
  return std::move(found.outcome);
}

}  // namespace

haptics::ClosedLoop loopOf(const Way& way, std::shared_ptr<const haptics::Scene> scene,
                           double isovalue) {
  const Wall& wall = way.wall;
  const haptics::DeviceModel& device = wall.device;
  haptics::ClosedLoop loop;
  loop.settings.isovalue = isovalue;
  loop.settings.stiffness = way.stiffness;
  loop.limits = way.shipped ? haptics::limitsOf(device.rating)
                            : haptics::ForceLimits{device.rating.force, device.rating.torque};
  loop.grip = device.heldBy(wall.hand, std::sqrt(scene->tool.shell.inertia.trace() / 3.0));
  loop.linkage = device.linkage;
  loop.lead = wall.lead;
  loop.rate = wall.rate();
  const double angular = device.rating.angular_stiffness;
  if (way.shipped && device.rating.torque > 0.0 &&
      way.stiffness * haptics::largestInertia(scene->tool.shell.inertia) > angular)
    loop.settings.angular_stiffness = angular;
  loop.damping = wall.damping;
  loop.passivity_damping = wall.controller;
  loop.scene = std::move(scene);
  return loop;
}

double allowedFor(const Wall& wall, const haptics::Scene& scene) {
  const haptics::Linkage& linkage = wall.device.linkage;
  return haptics::allowedStiffness(wall.device.rating, scene.tool.shell,
                                   {wall.period, linkage.delay * wall.period}, linkage.arm.norm());
}

haptics::Hand waiting(const haptics::Hand& hand, const std::optional<Pose>& place, double wait,
                      double seconds, double period, bool turns) {
  const Pose X_to = place ? comparison::movedTo(*place, hand) : Pose::Identity();
  std::vector<double> times{0.0};
  std::vector<Pose> poses{X_to * hand.at(0.0)};
  for (std::int64_t n = 0; double(n) * period <= seconds; ++n) {
    const double t = double(n) * period;
    times.push_back(wait + period + t);
    poses.push_back(X_to * hand.at(t));
    if (!turns) poses.back().linear() = poses.front().linear();
  }
  return haptics::Hand::along(std::move(times), std::move(poses)).value();
}

haptics::Hand along(const std::vector<Vec3>& corners, double wait) {
  std::vector<double> times{0.0};
  std::vector<Pose> poses{at(corners.front())};
  double begin = wait;
  for (std::size_t n = 0; n + 1 < corners.size(); ++n) {
    const Vec3 step = corners[n + 1] - corners[n];
    const double takes = timeOf(step);
    for (int part = 0; part <= 100; ++part) {
      const double u = 0.01 * part, share = u * u * (3.0 - 2.0 * u);
      times.push_back(begin + u * takes + 1e-6);
      poses.push_back(at(corners[n] + share * step));
    }
    begin += takes + 2e-6;
  }
  return haptics::Hand::along(std::move(times), std::move(poses)).value();
}

double timeAlong(const std::vector<Vec3>& corners, double wait) {
  double takes = wait + kFollowing;
  for (std::size_t n = 0; n + 1 < corners.size(); ++n) takes += timeOf(corners[n + 1] - corners[n]);
  return takes;
}

LoopResult runLoop(haptics::ClosedLoop& loop, const haptics::Hand& hand, std::int64_t ticks,
                   double from, double until,
                   const std::function<void(const haptics::TraceRow&)>& each) {
  const haptics::Scene& scene = *loop.scene;
  const double K = loop.settings.stiffness;
  const double lateness = loop.linkage.delay - loop.lead / loop.rate.period();
  LoopResult result{.balance = {K, loop.grip, loop.rate.period(), std::max(0.0, lateness)}};
  haptics::PassivityObserver program, lost;
  Vec3 lowest = Vec3::Constant(INFINITY), highest = -lowest;
  const auto stretch = [&](const Pose& X_WP, const Pose& X_WD) {
    const haptics::Twist apart = haptics::motionBetween(X_WP, X_WD);
    haptics::Vector6 stretched = scene.metric.whitened(apart, X_WP.linear());
    // of a spring that turns as softly as is rated
    const double angular = loop.settings.angular_stiffness;
    if (angular > 0.0) stretched.tail<3>() = std::sqrt(angular / K) * apart.angular;
    return stretched;
  };
  std::optional<haptics::TraceRow> before;
  haptics::Linkage link;
  link.delay = loop.linkage.delay;
  std::int64_t tick = 0;
  const auto done = loop.run(hand, ticks, [&](const haptics::TraceRow& row) {
    result.energy = row.energy;
    result.share = row.stiffness_share;
    result.contact += row.contacts > 0;
    result.cut += row.cut_at > 0;
    result.non_finite += !row.X_WP.matrix().allFinite() || !row.X_WH.matrix().allFinite() ||
                         !std::isfinite(row.coupling_W.force.norm()) ||
                         !std::isfinite(row.coupling_W.torque.norm());
    result.force = worse(result.force, row.sent_W.force.norm());
    if (tick++ % 10 == 0) {
      ++result.looks;
      const haptics::Scene& touched = row.cutting != nullptr ? *row.cutting->scene() : scene;
      result.inside += !evaluator::isLegal(*touched.volume, loop.settings.isovalue,
                                           scene.tool.shell.points, row.X_WP);
      result.given.push_back({row.time, 1e3 * row.energy});
    }
    if (const std::optional<haptics::TraceRow> last = std::exchange(before, row)) {
      const haptics::Wrench held = link.late(last->sent_W);
      const haptics::Twist motion = haptics::motionBetween(last->X_WH, row.X_WH);
      const haptics::Vector6 stretched = stretch(row.X_WP, row.X_WD);
      program.add(held, haptics::motionBetween(last->X_WD, row.X_WD));
      result.balance.add(row.energy, held, motion, stretched);
      const Vec3 arm = last->X_WD.translation() - last->X_WH.translation();
      if (!loop.linkage.torque) lost.add({Vec3::Zero(), arm.cross(held.force)}, motion);

      const double pulled = 0.5 * K * stretch(last->X_WP, row.X_WD).squaredNorm();
      const double rise = 0.5 * K * stretched.squaredNorm() - pulled;
      result.risen += std::max(0.0, rise);
      const double pull = std::sqrt(2.0 * K * pulled);
      if (pull > 0.1) result.rise = std::max(result.rise, rise / pull);

      if (row.time >= from && row.time < until) {
        lowest = lowest.cwiseMin(row.X_WH.translation());
        highest = highest.cwiseMax(row.X_WH.translation());
        result.force_step =
            std::max(result.force_step, (row.sent_W.force - last->sent_W.force).norm());
      }
    }
    if (each) each(row);
    return true;
  });
  result.program = program.energy();
  result.lost = lost.energy();
  result.amplitude = 0.5 * (highest - lowest).norm();
  if (done) return result;
  result.non_finite = int(ticks);
  result.refused = done.error();
  return result;
}

Stage makeStage(const std::string& name, double noise, unsigned seed) {
  const auto stage = [&](const auto& shape, std::vector<Vec3> points, const Pose& X_touch,
                         double deepest = INFINITY) {
    return Stage{sceneOf(ramp(noise, seed, shape), toolOf(std::move(points))), X_touch, deepest};
  };
  const datasets::shapes::Wedge wedge{.bottom = -0.008};
  if (name == "plane")
    return stage(datasets::shapes::HalfSpace{}, datasets::platePoints(6, 0.02), at(0, 0, 0));
  if (name == "groove")
    return stage(wedge, datasets::rodPoints(100, 0.016, 2e-3),
                 at({0, 0, wedge.bottom + 2e-3 / std::sin(wedge.half_angle)},
                    turn(0.5 * std::numbers::pi, Vec3::UnitZ())));
  // half of the way to the middle of the ball
  return stage(datasets::shapes::Sphere{0.015}, datasets::ballPoints(100, 3e-3), at(0, 0, 0.018),
               0.009);
}

LoopResult press(const Way& way, const Stage& stage) {
  const Wall& wall = way.wall;
  haptics::ClosedLoop loop = loopOf(way, stage.scene, 0.0);

  // so deep that coupling and grip, springs in series, press with what is asked
  const double deep =
      std::min(stage.deepest, std::min(kPress, 0.5 * wall.device.rating.force) *
                                  (1.0 / way.stiffness + 1.0 / wall.hand.stiffness));
  Pose X_from = stage.X_touch;  // in the air
  X_from.translation().z() += 6e-3;
  const double depth = X_from.translation().z() - (stage.X_touch.translation().z() - deep);
  const double begin = loop.limits.ramp_time;  // s: armed
  const double down = begin + 1.5 * depth / kSpeed;
  // until what the arrival set off has died, to 1 %; beyond the limit it does not
  const double left = 1.0 - way.stiffness / wall.theory();
  const double decay = 0.5 * loop.grip.damping / loop.grip.mass * left;
  const double up = down + kRest + kSettle + (decay > 0.0 ? std::min(4.6 / decay, 4.0) : 0.0);
  std::vector<double> times;
  std::vector<Pose> poses;
  for (int n = 0; n <= 201; ++n) {
    const double u = 0.01 * (n <= 100 ? n : 201 - n), share = u * u * (3.0 - 2.0 * u);
    times.push_back((n <= 100 ? begin : up) + 0.01 * (n % 101) * (down - begin));
    poses.push_back(X_from);
    poses.back().translation().z() -= share * depth;
  }
  const haptics::Hand hand = haptics::Hand::along(std::move(times), std::move(poses)).value();
  // a little longer than the hand takes, for the device to follow it
  const auto ticks = std::lround((up + (down - begin) + 0.15) / wall.period);
  return runLoop(loop, hand, ticks, up - kRest, up);
}

std::vector<Job> pressJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  const std::vector<double> few{0.0, 0.02, 0.1}, all{0.0, 0.005, 0.02, 0.05, 0.1};
  const std::vector<double> fine{50, 200, 500, 1000, 2000, 3500, 5000, 7000, 10000, 14000, 20000};
  const Sweep sweeps[] = {{Depth::Quick, 1e-3, 1.0, {50, 1000, 20000}, {0, 1, 4}, few},
                          {Depth::Quick, 0.25e-3, 4.0, {1000}, {0, 1}, few},
                          {Depth::Full, 1e-3, 10.0, fine, {0, 1, 2, 4}, all},
                          {Depth::Full, 0.25e-3, 4.0, {50, 1000, 5000, 20000}, {0, 1, 2, 4}, all}};
  // one of each kind of mass, encoder and motors; full has all
  const std::set<std::string> quick{"falcon", "delta.3", "sigma.7", "touch", "omni-arm-200"};
  // run in other loops as well: a coarse encoder, torque motors, the stiffest, the weakest
  const std::set<std::string> varied =
      full ? std::set<std::string>{"falcon", "sigma.7", "lambda.7", "touch"}
           : std::set<std::string>{"sigma.7"};
  std::vector<Job> jobs;
  for (const haptics::DeviceModel& device : haptics::deviceModels())
    for (const std::string stage : {"plane", "groove", "ball"})
      for (const Sweep& sweep : sweeps) {
        const bool other_loops = varied.contains(device.name) && (full || stage == "ball");
        if (sweep.depth != depth) continue;
        // at 4 kHz on one stage in the quick form, what runs at it
        const bool own = sweep.period == asShipped(device).period && stage == "ball";
        if (!full && !(quick.contains(device.name) && (sweep.period == 1e-3 || own))) continue;
        const std::string name = "press/" + device.name + "/" + stage +
                                 (sweep.period < 1e-3 ? "/" + rateOf(sweep.period) : "");
        jobs.push_back(
            {name, "Presses in six degrees of freedom", sweep.cost, [=](std::uint64_t seed) {
               return pressesOf(name, stage, {device, {}, sweep.period}, sweep, other_loops,
                                unsigned(seed));
             }});
      }
  return jobs;
}

}  // namespace study::stability
