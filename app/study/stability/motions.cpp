// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include "app/study/stability/failures.h"

namespace study::stability {
namespace {

void leaps(Trials& found) {
  // what the sphere held on the way is let go slowly
  const double released =
      1e3 * haptics::TouchConstants::kMostReleased / 1000.0 / haptics::releaseSpeed(1000.0);
  struct Row {
    double aside, bound;  // m; ticks
  };
  for (const int count : {500, 2000})
    for (const auto& [aside, bound] :
         {Row{0.1, 1}, Row{0.028, 15}, Row{0.005, 1.1 * released + 30}}) {
      const Pose from = at(-0.5, aside, 0.0), to = at(0.5, aside, 0.0);
      Trial& trial = found.trial(sphere(ballTool(count, 3e-3)), kSolidIso, from);
      trial.name = shortly(1e3 * aside) + " mm aside";
      trial.hold(from, 5);
      found.subject = "F6a a leap of 1 m, " + trial.name + ", " + shortly(count) + " points";
      found.atMost("ticks to catch up", trial.ticksToReach(to, 400), bound);
    }
  // to and fro in every tick, as of a tracker that has lost itself
  Random random{found.seed + 231};
  Trial& trial = found.trial(sphere(ballTool(500, 3e-3)), kSolidIso, at(-0.5, 0, 0));
  trial.name = "to and fro";
  for (int n = 0; n < 100 * found.tries; ++n) trial.step(at(random.box(0.5), random.rotation()));
}

void longTool(Trials& found) {
  Trial& trial = found.brought(sphere(toolOf(datasets::rodPoints(2000, 0.3, 3e-3))), kSolidIso,
                               at(0, 0, 0.04), at(0, 0, 0.020), 60);
  // along itself and a little about z, 3 mm into the sphere
  const auto along = [](int n) { return 0.08 * std::sin(2e-3 * n); };
  const auto device = [&](int n) {
    return at({along(n), 0, 0.020}, turn(0.02 * std::sin(3e-3 * n), Vec3::UnitZ()));
  };
  int pressed = 0;
  const Figures behind = trial.follow(1500, device, [&](int n) {
    pressed += trial.last.wrench_W.force.z() > 0.5;  // N
    return std::abs(trial.place().x() - along(n));
  });
  found.atMost("behind, most", 1e3 * behind.most, 1.0, "mm");
  found.atLeast("ticks pressed", pressed, 1400.0);
}

// a bar in a slot, turned about the slot's axis: whatever the device does, the torque grows or
// stays, and never turns over from one tick to the next
void halfTurn(Trials& found) {
  Random random{found.seed + 207};
  std::vector<Vec3> bar;
  for (int i = -20; i <= 20; ++i)
    for (const double y : {-1e-3, 1e-3}) bar.push_back({y, 0.5e-3 * i, 0.0});
  double largest_step = 0.0, least_most = INFINITY;
  int flipped = 0;
  Series felt{"torque", {}};
  for (int k = 0; k < 4; ++k) {
    const Quat q = random.rotation();
    const Vec3 across = q * Vec3::UnitX(), axis = q * Vec3::UnitZ();
    auto slot =
        datasets::solid(cube(60), [&](const Vec3& p) { return 2.5e-3 - std::abs(across.dot(p)); });
    Trial& trial =
        found.trial(sceneOf(std::move(slot), toolOf(bar)), kSolidIso, at(Vec3::Zero(), q));
    trial.coupling.angular_stiffness = 1.0;  // N·m/rad
    double before = 0.0;
    // rad: to 229 degrees and back
    const auto angle = [](int n) { return 0.01 * (n <= 400 ? n : 800 - n); };
    const auto device = [&](int n) { return at(Vec3::Zero(), turn(angle(n), axis) * q); };
    const Figures torque = trial.follow(801, device, [&](int n) {
      const double now = -trial.last.wrench_W.torque.dot(axis);
      if (n > 0) largest_step = std::max(largest_step, std::abs(now - before));
      flipped += angle(n) > 0.5 && now <= 0.0;
      if (k == 0 && n % 5 == 0) felt.points.push_back({1e-3 * n, now});
      return before = now;
    });
    least_most = std::min(least_most, torque.most);
  }
  found.none("ticks with a torque turned over", flipped);
  found.atLeast("largest torque", least_most, 1.5, "N m", "it is felt");
  found.atMost("step of torque in a tick", largest_step, 0.05, "N m",
               "0.01 rad, and what the proxy turns in its slot");
  found.plot("A bar in a slot, turned by 229 degrees and back",
             "Torque on the hand: it grows, saturates and comes back the same way", {"time [s]"},
             {"torque [N m]"}, {felt});
}

void longSlide(Trials& found) {
  const auto device = [](int n) {
    return at(0.015 * std::sin(3e-3 * n), 0.015 * std::cos(1.7e-3 * n), 1e-3);
  };
  for (const bool bumpy : {false, true}) {
    auto ground = datasets::sampledFloat(cube(60), [&](const Vec3& p) {
      const double bump = 1e-3 * std::sin(700 * p.x()) * std::sin(900 * p.y());
      return 1000.0 - 4e6 * (p.z() - (bumpy ? bump : 0.0));
    });
    const auto scene = sceneOf(std::move(ground), ballTool(100, 3e-3));
    Trial& trial = found.brought(scene, 1000.0, at(0, 0.015, 0.01), device(0), 40);
    const Figures gaps =
        trial.follow(2000 * found.tries, device, [&](int) { return trial.lowest(Vec3::UnitZ()); });
    if (bumpy) continue;
    const double rest = scene->lengths.rest_gap;
    found.atLeast("least gap", 1e3 * gaps.least, 0.5e3 * rest, "mm", "half of the rest gap");
    found.atMost("greatest gap", 1e3 * gaps.most, 2e3 * rest, "mm", "twice the rest gap");
  }
}

void groove(Trials& found) {
  const double size = 3e-3;
  for (const double degrees : {15.0, 40.0}) {
    const datasets::shapes::Wedge wedge{degrees * std::numbers::pi / 180.0, -0.012};
    const double slope = std::sin(wedge.half_angle);
    const auto distance = [&](const Vec3& p) { return wedge.distance(p); };
    const auto scene = sceneOf(datasets::solid(cube(64), distance, 8.0), ballTool(1000, size));
    const double ideal = wedge.bottom + (size + scene->lengths.rest_gap) / slope;
    Random random{found.seed + 208};
    double worst = 0.0;
    int moved = 0;
    for (int n = 0; n < 3 + found.tries; ++n) {
      const Pose start = at({0, random.in(-5e-3, 5e-3), ideal + 4e-3}, random.rotation());
      const Pose D =
          at({random.in(-5e-4, 5e-4), start.translation().y(), ideal - 4e-3}, Quat{start.linear()});
      Trial& trial = found.brought(scene, kSolidIso, start, D, 60, 200);
      moved += !trial.isStill(D, 50);
      worst = std::max(worst, std::abs(trial.place().z() - ideal));
    }
    found.subject = "F10 groove of " + shortly(degrees) + " degrees";
    found.atMost("from the closed form", 1e3 * worst, 100.0 * h / slope, "mm",
                 "a tenth of a voxel at the walls");
    found.none("holds that are not still", moved);
  }
}

// taking every pose that is solved for shakes by up to a millimetre
void rest(Trials& found) {
  Random random{found.seed + 209};
  const auto scene = sceneOf(ramp(0.05, found.seed + 210, datasets::shapes::Sphere{0.015}),
                             toolOf(datasets::rodPoints(300, 0.02, 1.5e-3)));
  int held = 0, still = 0;
  std::vector<double> wander;
  const int holds = 4 + 8 * found.tries;
  for (int n = 0; n < holds; ++n) {
    const Vec3 out = random.direction();
    const Pose start = at(0.035 * out, random.rotation());
    const Pose D = at(0.014 * out, Quat{start.linear()});
    Trial& trial = found.brought(scene, 0.0, start, D, 60, 200);
    if (trial.last.contacts > 0) {
      ++held;
      const Vec3 at_rest = trial.place();
      still += trial.isStill(D, 100);
      // about where it has got to under the tremor
      Vec3 sum = Vec3::Zero();
      double squares = 0.0;
      for (int t = 0; t < 200; ++t) {
        trial.step(at(D.translation() + random.box(10e-6), Quat{D.linear()}));
        if (t < 100) continue;
        const Vec3 off = trial.place() - at_rest;
        sum += off;
        squares += off.squaredNorm();
      }
      wander.push_back(std::sqrt(std::max(0.0, squares / 100 - (sum / 100).squaredNorm())));
    }
  }
  std::sort(wander.begin(), wander.end());
  found.atLeast("holds in contact", held, 0.75 * holds);
  found.none("holds that are not still to the bit", held - still);
  found.atMost("wander under a tremor of 10 um, nine in ten",
               wander.empty() ? NAN : 1e6 * wander[wander.size() * 9 / 10], 30.0, "um");
}

// motion that the filter took back was motion too: whatever the proxy remembers, the next tick goes
// where it would go for one that has proven nothing yet
void takenBack(Trials& found) {
  Random random{found.seed + 211};
  const auto scene = sceneOf(datasets::whiteNoise(cube(48), found.seed + 212),
                             toolOf(datasets::rodPoints(120, 0.016, 1e-3)));
  std::deque<Trial> trials;  // with more work than a tick has
  int ticks = 0, differing = 0, contact = 0, illegal = 0;
  for (int n = 0; n < 2 * found.tries; ++n) {
    const Pose start = at(random.box(0.01) + Vec3{0, 0, 0.04}, random.rotation());
    Trial& trial = trials.emplace_back(scene, 150.0, start);
    trial.allowance = 1'000'000;
    Pose D = start, target = start;
    for (int t = 0; t < 300; ++t) {
      if (t % 30 == 0) target = at(random.box(0.014), random.rotation());
      D = comparison::between(D, target, 0.1);
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
      differing += !forgetful.isAt(knowing.proxy.X_WP);
      illegal += knowing.illegal > trial.illegal;
    }
    illegal += trial.illegal;
    contact += trial.contact;
  }
  found.none("ticks inside", illegal);
  found.atLeast("ticks in contact", contact, ticks / 8.0);
  found.atMost("leaps that differ from those of one that knows nothing", 1e3 * differing / ticks,
               1.0, "per thousand",
               "what an older, larger bound leaves out may, rarely, still count to first order");
  found.outcome.plots.push_back(distancePlot(found.subject, trials));
}

}  // namespace

FailureGroup motions() {
  return {"Leaps, turns, slides and rest",
          {{"leaps", "F6a leaps", 1.0, 0.0, leaps},
           {"long tool", "F6b tool five times as long as the volume", 2.0, 0.0, longTool},
           {"half turn", "F8 rotation through pi", 1.0, 0.0, halfTurn},
           {"long slide", "F9 drift in a long slide", 0.0, 0.5, longSlide},
           {"groove", "F10 grooves", 1.0, 0.3, groove},
           {"rest", "F11 at rest on noise", 0.5, 1.0, rest},
           {"taken back", "F13 motion that is taken back", 0.0, 0.7, takenBack}}};
}

}  // namespace study::stability
