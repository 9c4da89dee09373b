// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/failures.h"
#include "haptics/simulation/penetration.h"

namespace study::stability {
namespace {

using haptics::ScalarType;

/// How long a proxy may take to get out when a new isovalue leaves it inside.
constexpr double kTicksToLeave = 20.0;

/// m, of the deepest point.
double depthOf(const Trial& trial) {
  return haptics::penetration(*trial.scene, trial.isovalue, trial.proxy.X_WP);
}

/// Steps until the proxy is outside; the ticks it took, 50 at most.
int ticksToLeave(Trial& trial, const Pose& D) {
  int ticks = 0;
  trial.judged = false;
  do trial.step(D);
  while (!trial.isLegal() && ++ticks < 50);
  trial.judged = true;
  return ticks;
}

void twoMillimetresInside(Trials& found) {
  const Pose D = at(0, 0, 0.0175);
  Trial& trial =
      found.brought(sphere(ballTool(200, 3e-3), 0.015, 10.0), kSolidIso, at(0, 0, 0.03), D, 40, 20);
  // the surface grows by 2 mm past the proxy
  trial.isovalue = kSolidIso - 8000.0;
  found.atLeast("depth at first", 1e3 * depthOf(trial), 1.9, "mm",
                "that there is something to leave");
  found.atMost("ticks until outside", ticksToLeave(trial, D), kTicksToLeave);
  found.atMost("from the nearest legal place", 1e3 * std::abs(trial.place().z() - 0.020), 0.2,
               "mm");
  found.atMost("ticks to follow 20 mm away", trial.ticksToReach(at(0, 0, 0.040), 9), 4.0);
}

/// A block of one value, z < 0, in a medium of another.
SharedScene plateaus() {
  const auto value = [](auto i, auto, auto k) { return k < 24 ? 1000.0 : i < 8 ? 0.0 : 500.0; };
  return sceneOf(datasets::filled(cube(48), ScalarType::Int16, value), ballTool(100, 2e-3));
}

void plateauBuries(Trials& found) {
  int most = 0, follows = 0;
  // all of a sudden the medium is solid: below its value, and at it
  for (const double isovalue : {400.0, 499.0, 500.0}) {
    const Pose D = at(0.010, 0.0, 0.010);
    Trial& trial = found.trial(plateaus(), 900.0, D);
    trial.hold(D, 5);
    trial.isovalue = isovalue;
    most = std::max(most, ticksToLeave(trial, D));
    // and follows where there is nothing
    const Pose free = at(trial.place() + 0.1 * trial.place().normalized());
    follows = std::max(follows, trial.ticksToReach(free, 20));
  }
  found.atMost("ticks until outside", most, kTicksToLeave);
  found.atMost("ticks to follow 100 mm", follows, 9.0);
}

void plateauAtTheIsovalue(Trials& found) {
  Trial& trial = found.trial(plateaus(), 1000.0, at(0.004, 0, 0.010));
  trial.carry(trial.proxy.X_WP, at(0.004, 0, -0.006), 60);
  trial.hold(at(0.004, 0, -0.006), 50);
  // the topmost layer of 1000 is half a voxel below the origin
  found.atMost("from its face", 1e3 * std::abs(trial.lowest(Vec3::UnitZ()) + 0.5 * h), 0.1, "mm");
}

void voxelsThatAreNoNumbers(Trials& found) {
  const auto begun = [&](bool sick) -> Trial& {
    Random random{found.seed + 203};
    auto volume = datasets::filled(cube(48), ScalarType::Float32, [&](auto, auto, auto k) {
      const double value = std::clamp(4000.0 * (24.0 - double(k)), -9e3, 9e3);
      const int draw = random.below(60);
      if (draw > 2) return value;
      return !sick ? -9e3 : draw == 0 ? NAN : draw == 1 ? INFINITY : -INFINITY;
    });
    return found.brought(sceneOf(std::move(volume), ballTool(200, 3e-3)), 0.0, at(0, 0, 0.01),
                         at(0, 0, 1e-3), 40);
  };
  Trial &well = begun(false), &sick = begun(true);
  int differing = 0;
  for (int n = 0; n < 600; ++n) {
    const Pose D = at(0.012 * std::sin(0.01 * n), 0.01 * std::cos(0.013 * n), 1e-3);
    well.step(D);
    sick.step(D);
    differing += well.place() != sick.place();
  }
  found.atLeast("replaced", double(sick.scene->volume->replaced), 1000.0);
  found.atLeast("ticks in contact", well.contact + sick.contact, 1000.0);
  found.none("ticks unlike those of background there", differing);
}

// the volume full of specks, where nothing can be left out
void endsOfTheData(Trials& found) {
  Random random{found.seed + 205};
  auto volume = datasets::sampledFloat(cube(48), [&](const Vec3& p) {
    return p.norm() < 0.012 ? random.in(1999.0, 2040.0) : random.in(-1000.0, -950.0);
  });
  const double least = volume.least, greatest = volume.greatest;
  const auto scene = sceneOf(std::move(volume), ballTool(300, 2e-3));
  for (const double isovalue : {least, least + 0.01, -999.0, -950.0, 1999.0, 2039.0, greatest}) {
    Trial& trial = found.trial(scene, isovalue, at(0, 0, 0.04));
    trial.judged = isovalue > least;  // at the background's own value all the world is inside
    trial.drag(Vec3::Zero(), 0.014, found.seed + 206, 12);
  }
}

// the slider moved in every tick: a ball that breathes, faster than the tool is brought out of it
void sweptIsovalue(Trials& found) {
  const Pose D = at(0, 0, 0.0175);
  Trial& trial =
      found.brought(sphere(ballTool(200, 3e-3), 0.015, 10.0), kSolidIso, at(0, 0, 0.03), D, 40);
  trial.judged = false;
  int inside = 0, longest = 0, run = 0;
  const int ticks = 1000 * found.tries;
  for (int n = 0; n < ticks; ++n) {
    // 2 mm in and out, at most 0.05 mm in a tick
    trial.isovalue = kSolidIso + 8000.0 * std::sin(0.025 * n);
    trial.step(D);
    run = depthOf(trial) > 0.0 ? run + 1 : 0;
    inside += run > 0;
    longest = std::max(longest, run);
  }
  // when the slider rests, it is over
  trial.isovalue = kSolidIso;
  const int settles = ticksToLeave(trial, D);
  trial.hold(D, 20);
  found.atMost("longest time inside", longest, kTicksToLeave, "ticks",
               "of " + std::to_string(inside) + " ticks inside in " + std::to_string(ticks) +
                   "; what one change of the isovalue may take");
  found.atMost("ticks until outside at rest", settles, kTicksToLeave);
}

/// A volume of one value but for its first voxel.
SharedScene evenVolume(double first, double others) {
  const auto value = [=](auto i, auto j, auto k) { return i + j + k == 0 ? first : others; };
  return sceneOf(datasets::filled(cube(24), ScalarType::Int16, value), ballTool(100, 2e-3));
}

void emptyAndAllInside(Trials& found) {
  const Pose above = at(0, 0, 0.03);
  // no voxel reaches the isovalue: there is nothing, and nothing to feel
  Trial& empty = found.trial(evenVolume(7.0, 7.0), 500.0, above);
  int felt = 0;
  Random random{found.seed + 223};
  for (int n = 0; n < 200 * found.tries; ++n) {
    const Pose D = at(random.box(0.02), random.rotation());
    empty.hold(D, 13);
    felt += !empty.isAt(D) || !empty.last.wrench_W.force.isZero(0.0);
  }
  found.subject = "empty volume";
  found.none("ticks with a force", felt);

  // but for one voxel, so that there is a background
  Trial& dragged = found.trial(evenVolume(0.0, 1000.0), 500.0, above);
  dragged.drag(Vec3::Zero(), 0.02, found.seed + 124, 30 * found.tries);
  found.subject = "all-inside volume";
  found.atLeast("ticks in contact", dragged.contact, 1.0);
  // pressed on like any block: its face is half a voxel beyond the outermost
  const Trial& pressed =
      found.brought(dragged.scene, dragged.isovalue, above, at(0, 0, 0.008), 40, 200);
  found.atMost("from its face", 1e3 * std::abs(pressed.lowest(Vec3::UnitZ()) - 12.0 * h), 0.1,
               "mm");
}

}  // namespace

FailureGroup insides() {
  return {
      "Isovalues, plateaus and numbers that are none",
      {{"2 mm inside", "F4 isovalue moved, 2 mm inside", 0.5, 0.0, twoMillimetresInside},
       {"buried in a plateau", "F4b buried in a plateau", 0.5, 0.0, plateauBuries},
       {"plateau at the isovalue", "F4b plateau at the isovalue", 0.2, 0.0, plateauAtTheIsovalue},
       {"voxels that are no numbers", "F5 voxels that are no numbers", 0.5, 0.0,
        voxelsThatAreNoNumbers},
       {"ends of the data", "F6e isovalue at either end of the data", 2.0, 0.0, endsOfTheData},
       {"swept isovalue", "isovalue swept at 1 kHz", 0.0, 0.5, sweptIsovalue},
       {"empty and all inside", "empty and all-inside volumes", 0.0, 0.5, emptyAndAllInside}}};
}

}  // namespace study::stability
