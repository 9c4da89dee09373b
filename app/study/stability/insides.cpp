// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/failures.h"
#include "haptics/simulation/penetration.h"

namespace study::stability {
namespace {

using haptics::ScalarType;

/// How long a proxy may take to get out when a new isovalue leaves it inside.
constexpr double kTicksToLeave = 20.0;

/// Steps until the proxy is outside; the ticks it took, 50 at most.
int ticksToLeave(Trial& trial, const Pose& D, Trace* trace = nullptr) {
  int ticks = 0;
  trial.judged = false;
  do {
    trial.step(D);
    if (trace)
      trace->add(ticks, 1e3 * haptics::penetration(*trial.scene, trial.isovalue, trial.proxy.X_WP));
  } while (!trial.isLegal() && ++ticks < 50);
  trial.judged = true;
  return ticks;
}

Outcome twoMillimetresInside(int, std::uint64_t) {
  Outcome outcome;
  const auto scene = sceneOf(datasets::solid(
                                 cube(64), [](const Vec3& p) { return p.norm() - 0.015; }, 10.0),
                             ball(200, 3e-3));
  const Pose D = at(0, 0, 0.0175), away = at(0, 0, 0.040);
  Trial trial{scene, datasets::kSolidIso, at(0, 0, 0.03)};
  trial.carry(at(0, 0, 0.03), D, 40);
  trial.hold(D, 20);
  // the surface grows by 2 mm past the proxy
  trial.isovalue = datasets::kSolidIso - 8000.0;
  const double buried = haptics::penetration(*scene, trial.isovalue, trial.proxy.X_WP);
  Trace trace{"deepest point", 1};
  trace.points.push_back({0.0, 1e3 * buried});
  const int ticks = ticksToLeave(trial, D, &trace);
  const double off = std::abs(trial.place().z() - 0.020);
  const int follows = trial.ticksToReach(away, 9);
  const std::string name = "F4 isovalue moved, 2 mm inside";
  outcome.cases.push_back({name + "/depth at first", 1e3 * buried, 1.9, "mm", Case::Sense::AtLeast,
                           "that there is something to leave"});
  outcome.cases.push_back({name + "/ticks until outside", double(ticks), kTicksToLeave, ""});
  outcome.cases.push_back({name + "/from the nearest legal place", 1e3 * off, 0.2, "mm"});
  outcome.cases.push_back({name + "/ticks to follow 20 mm away", double(follows), 4.0, ""});
  Watch watch;
  watch.add(trial);
  watch.tell(name, outcome);
  Plot plot = overTime("Left 2 mm inside by a moved isovalue",
                       "Depth of the deepest point: nothing goes deeper, and it is out at once",
                       "depth [mm]");
  plot.series.push_back(trace.series());
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

/// A block of one value, z < 0, in a medium of another.
std::shared_ptr<const haptics::Scene> plateaus() {
  return sceneOf(datasets::filled(cube(48), ScalarType::Int16,
                                  [](auto i, auto, auto k) {
                                    return k < 24 ? 1000.0 : i < 8 ? 0.0 : 500.0;
                                  }),
                 ball(100, 2e-3));
}

Outcome plateauBuries(int, std::uint64_t) {
  Outcome outcome;
  Watch watch;
  int most = 0, follows = 0;
  // all of a sudden the medium is solid: below its value, and at it
  for (const double isovalue : {400.0, 499.0, 500.0}) {
    const Pose D = at(0.010, 0.0, 0.010);
    Trial trial{plateaus(), 900.0, D};
    trial.hold(D, 5);
    trial.isovalue = isovalue;
    most = std::max(most, ticksToLeave(trial, D));
    // and follows where there is nothing
    const Pose free = at(trial.place() + 0.1 * trial.place().normalized());
    follows = std::max(follows, trial.ticksToReach(free, 20));
    watch.add(trial);
  }
  const std::string name = "F4b buried in a plateau";
  outcome.cases.push_back({name + "/ticks until outside", double(most), kTicksToLeave, ""});
  outcome.cases.push_back({name + "/ticks to follow 100 mm", double(follows), 9.0, ""});
  watch.tell(name, outcome);
  return outcome;
}

Outcome plateauAtTheIsovalue(int, std::uint64_t) {
  Outcome outcome;
  Trial trial{plateaus(), 1000.0, at(0.004, 0, 0.010)};
  trial.carry(trial.proxy.X_WP, at(0.004, 0, -0.006), 60);
  trial.hold(at(0.004, 0, -0.006), 50);
  const std::string name = "F4b plateau at the isovalue";
  // the topmost layer of 1000 is half a voxel below the origin
  outcome.cases.push_back(
      {name + "/from its face", 1e3 * std::abs(trial.lowest(Vec3::UnitZ()) + 0.5 * h), 0.1, "mm"});
  Watch watch;
  watch.add(trial);
  watch.tell(name, outcome);
  return outcome;
}

Outcome voxelsThatAreNoNumbers(int, std::uint64_t seed) {
  Outcome outcome;
  Watch watch;
  std::vector<Vec3> places[2];
  int contact = 0;
  double replaced = 0.0;
  for (const bool sick : {false, true}) {
    Random random{unsigned(203 + seed)};
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    const auto scene = sceneOf(
        datasets::filled(cube(48), ScalarType::Float32,
                         [&](auto, auto, auto k) {
                           const double value = std::clamp(4000.0 * (24.0 - double(k)), -9e3, 9e3);
                           const int draw = random.below(60);
                           if (draw > 2) return value;
                           return !sick ? -9e3 : draw == 0 ? nan : draw == 1 ? inf : -inf;
                         }),
        ball(200, 3e-3));
    if (sick) replaced = double(scene->volume->replaced);
    Trial trial{scene, 0.0, at(0, 0, 0.01)};
    trial.carry(at(0, 0, 0.01), at(0, 0, 1e-3), 40);
    for (int n = 0; n < 600; ++n) {
      trial.step(at(0.012 * std::sin(0.01 * n), 0.01 * std::cos(0.013 * n), 1e-3));
      places[sick].push_back(trial.place());
    }
    contact += trial.contact;
    watch.add(trial);
  }
  const std::string name = "F5 voxels that are no numbers";
  int differing = 0;
  for (std::size_t n = 0; n < places[0].size(); ++n) differing += places[0][n] != places[1][n];
  outcome.cases.push_back({name + "/replaced", replaced, 1000.0, "", Case::Sense::AtLeast});
  outcome.cases.push_back(
      {name + "/ticks in contact", double(contact), 1000.0, "", Case::Sense::AtLeast});
  outcome.cases.push_back(
      {name + "/ticks unlike those of background there", double(differing), 0.0, ""});
  watch.tell(name, outcome);
  return outcome;
}

// the volume full of specks, where nothing can be left out
Outcome endsOfTheData(int, std::uint64_t seed) {
  Outcome outcome;
  Random random{unsigned(205 + seed)};
  auto volume = datasets::sampledFloat(cube(48), [&](const Vec3& p) {
    return p.norm() < 0.012 ? random.in(1999.0, 2040.0) : random.in(-1000.0, -950.0);
  });
  const double least = volume.least, greatest = volume.greatest;
  const auto scene = sceneOf(std::move(volume), ball(300, 2e-3));
  Watch watch;
  for (const double isovalue : {least, least + 0.01, -999.0, -950.0, 1999.0, 2039.0, greatest}) {
    Random hand{unsigned(206 + seed)};
    Pose from = at(0, 0, 0.04);
    Trial trial{scene, isovalue, from};
    trial.judged = isovalue > least;  // at the background's own value all the world is inside
    for (int n = 0; n < 12; ++n) {
      const Pose to = at(hand.box(0.014), hand.rotation());
      trial.carry(from, to, 40);
      from = to;
    }
    watch.add(trial);
  }
  watch.tell("F6e isovalue at either end of the data", outcome);
  return outcome;
}

// the slider moved in every tick: a ball that breathes, faster than the tool is brought out of it
Outcome sweptIsovalue(int tries, std::uint64_t) {
  Outcome outcome;
  const auto scene = sceneOf(datasets::solid(
                                 cube(64), [](const Vec3& p) { return p.norm() - 0.015; }, 10.0),
                             ball(200, 3e-3));
  const Pose D = at(0, 0, 0.0175);
  Trial trial{scene, datasets::kSolidIso, at(0, 0, 0.03)};
  trial.carry(at(0, 0, 0.03), D, 40);
  trial.judged = false;
  Trace trace{"1 s", 5};
  int inside = 0, longest = 0, run = 0;
  const int ticks = 1000 * tries;
  for (int n = 0; n < ticks; ++n) {
    // 2 mm in and out, at most 0.05 mm in a tick
    trial.isovalue = datasets::kSolidIso + 8000.0 * std::sin(0.025 * n);
    trial.step(D);
    const double depth = haptics::penetration(*scene, trial.isovalue, trial.proxy.X_WP);
    inside += depth > 0.0;
    run = depth > 0.0 ? run + 1 : 0;
    longest = std::max(longest, run);
    if (n < 1000) trace.add(n, 1e3 * (trial.place().z()));
  }
  // when the slider rests, it is over
  trial.isovalue = datasets::kSolidIso;
  const int settles = ticksToLeave(trial, D);
  trial.hold(D, 20);
  const std::string name = "isovalue swept at 1 kHz";
  outcome.cases.push_back(
      {name + "/longest time inside", double(longest), kTicksToLeave, "ticks", Case::Sense::AtMost,
       "of " + std::to_string(inside) + " ticks inside in " + std::to_string(ticks) +
           "; what one change of the isovalue may take"});
  outcome.cases.push_back(
      {name + "/ticks until outside at rest", double(settles), kTicksToLeave, ""});
  Watch watch;
  watch.add(trial);
  watch.tell(name, outcome);
  Plot plot = overTime("An isovalue that moves in every tick",
                       "Height of the proxy over a ball that breathes by 2 mm: it rides on it",
                       "height [mm]");
  plot.series.push_back(trace.series());
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

Outcome emptyAndAllInside(int tries, std::uint64_t seed) {
  Outcome outcome;
  Watch watch;
  // no voxel reaches the isovalue: there is nothing, and nothing to feel
  {
    auto volume =
        datasets::filled(cube(24), ScalarType::Int16, [](auto, auto, auto) { return 7.0; });
    Trial trial{sceneOf(std::move(volume), ball(100, 2e-3)), 500.0, at(0, 0, 0.03)};
    int felt = 0;
    Random random{unsigned(223 + seed)};
    for (int n = 0; n < 200 * tries; ++n) {
      const Pose D = at(random.box(0.02), random.rotation());
      trial.hold(D, 12);
      trial.step(D);
      felt += trial.proxy.X_WP.matrix() != D.matrix() || !trial.last.wrench_W.force.isZero(0.0);
    }
    outcome.cases.push_back({"empty volume/ticks with a force", double(felt), 0.0, ""});
    watch.add(trial);
  }
  {
    auto volume = datasets::filled(cube(24), ScalarType::Int16, [](auto i, auto j, auto k) {
      return i + j + k == 0 ? 0.0 : 1000.0;  // but for one voxel, so that there is a background
    });
    Trial trial{sceneOf(std::move(volume), ball(100, 2e-3)), 500.0, at(0, 0, 0.03)};
    drag(trial, Vec3::Zero(), 0.02, unsigned(124 + seed), 30 * tries);
    outcome.cases.push_back({"all-inside volume/ticks in contact", double(trial.contact), 1.0, "",
                             Case::Sense::AtLeast});
    // pressed on like any block: its face is half a voxel beyond the outermost
    const Pose above = at(0, 0, 0.03), D = at(0, 0, 0.008);
    Trial pressed{trial.scene, trial.isovalue, above};
    pressed.carry(above, D, 40);
    pressed.hold(D);
    outcome.cases.push_back({"all-inside volume/from its face",
                             1e3 * std::abs(pressed.lowest(Vec3::UnitZ()) - 12.0 * h), 0.1, "mm"});
    watch.add(trial);
    watch.add(pressed);
  }
  watch.tell("empty and all-inside volumes", outcome);
  return outcome;
}

}  // namespace

std::vector<Job> insides(int tries) {
  const auto job = [&](std::string name, double cost, Outcome (*run)(int, std::uint64_t)) {
    return Job{"failures/" + std::move(name), "Isovalues, plateaus and numbers that are none", cost,
               [=](std::uint64_t seed) { return run(tries, seed); }};
  };
  return {job("2 mm inside", 0.5, twoMillimetresInside),
          job("buried in a plateau", 0.5, plateauBuries),
          job("plateau at the isovalue", 0.2, plateauAtTheIsovalue),
          job("voxels that are no numbers", 0.5, voxelsThatAreNoNumbers),
          job("ends of the data", 2.0, endsOfTheData),
          job("swept isovalue", 0.5 * tries, sweptIsovalue),
          job("empty and all inside", 0.5 * tries, emptyAndAllInside)};
}

}  // namespace study::stability
