// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include "app/study/stability/failures.h"
#include "datasets/phantoms/shapes.h"

namespace study::stability {
namespace {

Outcome leaps(int tries, std::uint64_t seed) {
  Outcome outcome;
  Watch watch;
  Plot plot = overTime("A device that leaps a metre",
                       "Distance from the device after the leap, by how far beside a sphere of 20 "
                       "mm it went: past the volume, past the sphere, through it",
                       "behind [mm]");
  for (const int count : {500, 2000}) {
    const auto scene = sphere(ball(count, 3e-3));
    struct Row {
      double aside;  // m
      double bound;  // ticks
    };
    // what the sphere held on the way is let go slowly
    const double released = 1e3 * haptics::kMostReleased / 1000.0 / haptics::releaseSpeed(1000.0);
    for (const auto& [aside, bound] :
         {Row{0.1, 1}, Row{0.028, 15}, Row{0.005, 1.1 * released + 30}}) {
      const Pose from = at(-0.5, aside, 0.0), to = at(0.5, aside, 0.0);
      Trial trial{scene, datasets::kSolidIso, from};
      trial.hold(from, 5);
      Trace trace{shortly(1e3 * aside) + " mm aside", 1};
      int ticks = 0;
      do {
        trial.step(to);
        trace.add(ticks, 1e3 * (trial.place() - to.translation()).norm());
      } while (++ticks < 400 && trial.proxy.X_WP.matrix() != to.matrix());
      outcome.cases.push_back({"F6a a leap of 1 m, " + shortly(1e3 * aside) + " mm aside, " +
                                   shortly(count) + " points/ticks to catch up",
                               double(ticks), bound, ""});
      watch.add(trial);
      if (count == 500) plot.series.push_back(trace.series());
    }
  }
  // to and fro in every tick, as of a tracker that has lost itself
  const auto scene = sphere(ball(500, 3e-3));
  Random random{unsigned(231 + seed)};
  Trial trial{scene, datasets::kSolidIso, at(-0.5, 0, 0)};
  for (int n = 0; n < 100 * tries; ++n) trial.step(at(random.box(0.5), random.rotation()));
  watch.add(trial);
  watch.tell("F6a leaps", outcome);
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

Outcome longTool(int, std::uint64_t) {
  Outcome outcome;
  const auto scene = sphere(toolOf(datasets::rodPoints(2000, 0.3, 3e-3)));
  Trial trial{scene, datasets::kSolidIso, at(0, 0, 0.04)};
  trial.carry(at(0, 0, 0.04), at(0, 0, 0.020), 60);
  double worst = 0.0;
  int pressed = 0;
  Trace trace{"along the rod", 15};
  const int ticks = 1500;
  for (int n = 0; n < ticks; ++n) {
    // along itself and a little about z, 3 mm into the sphere
    const double x = 0.08 * std::sin(2e-3 * n);
    trial.step(
        at({x, 0, 0.020}, Quat{Eigen::AngleAxisd{0.02 * std::sin(3e-3 * n), Vec3::UnitZ()}}));
    worst = std::max(worst, std::abs(trial.place().x() - x));
    pressed += trial.last.wrench_W.force.z() > 0.5;  // N
    trace.add(n, 1e3 * std::abs(trial.place().x() - x));
  }
  const std::string name = "F6b tool five times as long as the volume";
  outcome.cases.push_back({name + "/behind, most", 1e3 * worst, 1.0, "mm"});
  outcome.cases.push_back(
      {name + "/ticks pressed", double(pressed), 1400.0, "", Case::Sense::AtLeast});
  Watch watch;
  watch.add(trial);
  watch.tell(name, outcome);
  Plot plot = overTime("A rod of 300 mm over a volume of 64 mm",
                       "How far the proxy is behind along the rod", "behind [mm]");
  plot.series.push_back(trace.series());
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

// a bar in a slot, turned about the slot's axis: whatever the device does, the torque grows or
// stays, and never turns over from one tick to the next
Outcome halfTurn(int, std::uint64_t seed) {
  Outcome outcome;
  Watch watch;
  Random random{unsigned(207 + seed)};
  std::vector<Vec3> bar;
  for (int i = -20; i <= 20; ++i)
    for (const double y : {-1e-3, 1e-3}) bar.push_back({y, 0.5e-3 * i, 0.0});
  double largest_step = 0.0, least_most = INFINITY;
  int flipped = 0;
  Trace trace{"torque", 5};
  for (int k = 0; k < 4; ++k) {
    const Quat q = random.rotation();
    const Vec3 across = q * Vec3::UnitX(), axis = q * Vec3::UnitZ();
    const auto scene = sceneOf(
        datasets::solid(cube(60), [&](const Vec3& p) { return 2.5e-3 - std::abs(across.dot(p)); }),
        toolOf(bar));
    Trial trial{scene, datasets::kSolidIso, at(Vec3::Zero(), q)};
    trial.coupling.angular_stiffness = 1.0;  // N·m/rad
    double torque = 0.0, largest = 0.0;
    for (int n = 0; n <= 800; ++n) {
      const double angle = 0.01 * (n <= 400 ? n : 800 - n);  // rad: to 229 degrees and back
      trial.step(at(Vec3::Zero(), Quat{Eigen::AngleAxisd{angle, axis}} * q));
      const double now = -trial.last.wrench_W.torque.dot(axis);
      if (n > 0) largest_step = std::max(largest_step, std::abs(now - torque));
      largest = std::max(largest, now);
      torque = now;
      flipped += angle > 0.5 && torque <= 0.0;
      if (k == 0) trace.add(n, torque);
    }
    least_most = std::min(least_most, largest);
    watch.add(trial);
  }
  const std::string name = "F8 rotation through pi";
  outcome.cases.push_back({name + "/ticks with a torque turned over", double(flipped), 0.0, ""});
  outcome.cases.push_back(
      {name + "/largest torque", least_most, 1.5, "N m", Case::Sense::AtLeast, "it is felt"});
  outcome.cases.push_back({name + "/step of torque in a tick", largest_step, 0.05, "N m",
                           Case::Sense::AtMost, "0.01 rad, and what the proxy turns in its slot"});
  watch.tell(name, outcome);
  Plot plot = overTime("A bar in a slot, turned by 229 degrees and back",
                       "Torque on the hand: it grows, saturates and comes back the same way",
                       "torque [N m]");
  plot.series.push_back(trace.series());
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

Outcome longSlide(int tries, std::uint64_t) {
  Outcome outcome;
  Watch watch;
  for (const bool bumpy : {false, true}) {
    const auto scene = sceneOf(datasets::sampledFloat(cube(60),
                                                      [&](const Vec3& p) {
                                                        const double height =
                                                            bumpy ? 1e-3 * std::sin(700 * p.x()) *
                                                                        std::sin(900 * p.y())
                                                                  : 0.0;
                                                        return 1000.0 - 4e6 * (p.z() - height);
                                                      }),
                               ball(100, 3e-3));
    const auto device = [](int n) {
      return at(0.015 * std::sin(3e-3 * n), 0.015 * std::cos(1.7e-3 * n), 1e-3);
    };
    Trial trial{scene, 1000.0, at(0, 0.015, 0.01)};
    trial.carry(at(0, 0.015, 0.01), device(0), 40);
    double deepest = INFINITY, highest = 0.0;
    for (int n = 0; n < 2000 * tries; ++n) {
      trial.step(device(n));
      deepest = std::min(deepest, trial.lowest(Vec3::UnitZ()));
      highest = std::max(highest, trial.lowest(Vec3::UnitZ()));
    }
    watch.add(trial);
    if (bumpy) continue;
    const double rest = scene->lengths.rest_gap;
    outcome.cases.push_back({"F9 drift in a long slide/least gap", 1e3 * deepest, 0.5e3 * rest,
                             "mm", Case::Sense::AtLeast, "half of the rest gap"});
    outcome.cases.push_back({"F9 drift in a long slide/greatest gap", 1e3 * highest, 2e3 * rest,
                             "mm", Case::Sense::AtMost, "twice the rest gap"});
  }
  watch.tell("F9 drift in a long slide", outcome);
  return outcome;
}

Outcome groove(int tries, std::uint64_t seed) {
  Outcome outcome;
  Watch watch;
  const double size = 3e-3;
  for (const double degrees : {15.0, 40.0}) {
    datasets::shapes::Wedge wedge;
    wedge.half_angle = degrees * std::numbers::pi / 180.0;
    wedge.bottom = -0.012;
    const auto scene = sceneOf(datasets::solid(
                                   cube(64), [&](const Vec3& p) { return wedge.distance(p); }, 8.0),
                               ball(1000, size));
    const double ideal =
        wedge.bottom + (size + scene->lengths.rest_gap) / std::sin(wedge.half_angle);
    Random random{unsigned(208 + seed)};
    double worst = 0.0;
    int moved = 0;
    for (int n = 0; n < 3 + tries; ++n) {
      const Pose start = at({0, random.in(-5e-3, 5e-3), ideal + 4e-3}, random.rotation());
      const Pose D =
          at({random.in(-5e-4, 5e-4), start.translation().y(), ideal - 4e-3}, Quat{start.linear()});
      Trial trial{scene, datasets::kSolidIso, start};
      trial.carry(start, D, 60);
      trial.hold(D, 200);
      const Pose held = trial.proxy.X_WP;
      trial.hold(D, 50);
      moved += trial.proxy.X_WP.matrix() != held.matrix();
      worst = std::max(worst, std::abs(trial.place().z() - ideal));
      watch.add(trial);
    }
    const std::string name = "F10 groove of " + shortly(degrees) + " degrees";
    outcome.cases.push_back({name + "/from the closed form", 1e3 * worst,
                             100.0 * h / std::sin(wedge.half_angle), "mm", Case::Sense::AtMost,
                             "a tenth of a voxel at the walls"});
    outcome.cases.push_back({name + "/holds that are not still", double(moved), 0.0, ""});
  }
  watch.tell("F10 grooves", outcome);
  return outcome;
}

// taking every pose that is solved for shakes by up to a millimetre
Outcome rest(int tries, std::uint64_t seed) {
  Outcome outcome;
  Watch watch;
  Random random{unsigned(209 + seed)};
  const auto scene =
      noisySphere(0.05, unsigned(210 + seed), toolOf(datasets::rodPoints(300, 0.02, 1.5e-3)));
  int held = 0, still = 0;
  std::vector<double> wander;
  const int holds = 4 + 8 * tries;
  for (int n = 0; n < holds; ++n) {
    const Vec3 out = random.direction();
    const Pose start = at(0.035 * out, random.rotation());
    const Pose D = at(0.014 * out, Quat{start.linear()});
    Trial trial{scene, 0.0, start};
    trial.carry(start, D, 60);
    trial.hold(D, 200);
    if (trial.last.contacts == 0) {
      watch.add(trial);
      continue;
    }
    ++held;
    const Pose at_rest = trial.proxy.X_WP;
    trial.hold(D, 100);
    still += trial.proxy.X_WP.matrix() == at_rest.matrix();
    // about where it has got to under the tremor
    Vec3 sum = Vec3::Zero();
    double squares = 0.0;
    for (int t = 0; t < 200; ++t) {
      trial.step(at(D.translation() + random.box(10e-6), Quat{D.linear()}));
      if (t < 100) continue;
      const Vec3 off = trial.place() - at_rest.translation();
      sum += off;
      squares += off.squaredNorm();
    }
    wander.push_back(std::sqrt(std::max(0.0, squares / 100 - (sum / 100).squaredNorm())));
    watch.add(trial);
  }
  const std::string name = "F11 at rest on noise";
  std::sort(wander.begin(), wander.end());
  outcome.cases.push_back(
      {name + "/holds in contact", double(held), 0.75 * holds, "", Case::Sense::AtLeast});
  outcome.cases.push_back(
      {name + "/holds that are not still to the bit", double(held - still), 0.0, ""});
  outcome.cases.push_back({name + "/wander under a tremor of 10 um, nine in ten",
                           wander.empty() ? NAN : 1e6 * wander[wander.size() * 9 / 10], 30.0,
                           "um"});
  watch.tell(name, outcome);
  return outcome;
}

// motion that the filter took back was motion too: whatever the proxy remembers, the next tick goes
// where it would go for one that has proven nothing yet
Outcome takenBack(int tries, std::uint64_t seed) {
  Outcome outcome;
  Random random{unsigned(211 + seed)};
  const auto scene = sceneOf(datasets::whiteNoise(cube(48), unsigned(212 + seed)),
                             toolOf(datasets::rodPoints(120, 0.016, 1e-3)));
  DeviceDistances recorder;
  int ticks = 0, differing = 0, contact = 0, illegal = 0;
  for (int n = 0; n < 2 * tries; ++n) {
    const Pose start = at(random.box(0.01) + Vec3{0, 0, 0.04}, random.rotation());
    Trial trial{scene, 150.0, start};
    trial.allowance = 1'000'000;
    Pose D = start, target = start;
    for (int t = 0; t < 300; ++t) {
      if (t % 30 == 0) target = at(random.box(0.014), random.rotation());
      D = at(D.translation() + 0.1 * (target.translation() - D.translation()),
             Quat{D.linear()}.slerp(0.1, Quat{target.linear()}));
      trial.step(D);
      const Pose there = at(trial.place() + random.in(0.0, 4e-3) * random.direction(),
                            Quat{Eigen::AngleAxisd{random.in(0.0, 0.2), random.direction()}} *
                                Quat{trial.proxy.X_WP.linear()});
      Trial knowing{trial}, forgetful{trial};
      forgetful.judged = false;
      forgetful.proxy.clearance.forget();
      forgetful.step(there);
      knowing.step(there);
      ++ticks;
      differing += forgetful.proxy.X_WP.matrix() != knowing.proxy.X_WP.matrix();
      illegal += knowing.illegal > trial.illegal;
    }
    illegal += trial.illegal;
    contact += trial.contact;
    recorder.add(trial);
  }
  const std::string name = "F13 motion that is taken back";
  outcome.cases.push_back({name + "/ticks inside", double(illegal), 0.0, ""});
  outcome.cases.push_back(
      {name + "/ticks in contact", double(contact), ticks / 8.0, "", Case::Sense::AtLeast});
  outcome.cases.push_back({name + "/leaps that differ from those of one that knows nothing",
                           1e3 * differing / ticks, 1.0, "per thousand", Case::Sense::AtMost,
                           "what an older, larger bound leaves out may, rarely, still count to "
                           "first order"});
  outcome.plots.push_back(recorder.plot(name));
  return outcome;
}

}  // namespace

std::vector<Job> motions(int tries) {
  const auto job = [&](std::string name, double cost, Outcome (*run)(int, std::uint64_t)) {
    return Job{"failures/" + std::move(name), "Leaps, turns, slides and rest", cost,
               [=](std::uint64_t seed) { return run(tries, seed); }};
  };
  return {job("leaps", 1.0, leaps),
          job("long tool", 2.0, longTool),
          job("half turn", 1.0, halfTurn),
          job("long slide", 0.5 * tries, longSlide),
          job("groove", 1.0 + 0.3 * tries, groove),
          job("rest", 0.5 + tries, rest),
          job("taken back", 0.7 * tries, takenBack)};
}

}  // namespace study::stability
