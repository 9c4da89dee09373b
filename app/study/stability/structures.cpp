// SPDX-License-Identifier: BSD-3-Clause
// Structures that are felt otherwise than the scan has them: a press on one, and a slide across it.
#include "app/study/stability/failures.h"
#include "app/study/stability/loops.h"
#include "datasets/edits/walls.h"
#include "datasets/phantoms/sampled_distances.h"
#include "haptics/scene/watch.h"

namespace study::stability {
namespace {

using haptics::Feel;

constexpr double kVoxel = 5e-4, kTool = 2e-3, kBall = 4e-3;  // m
constexpr double kIsovalue = 300.0;
constexpr double kPress = 1.5;     // N
constexpr double kHeight = 12e-3;  // m, from where it comes

/// A way to feel a ball in the surface of bone, and the place of its middle over that surface [m].
struct FeltBall {
  const char* name;
  Feel feel;
  double middle;

  /// m, over the bone: where the tool rests on its top, or in its pit.
  double rest() const {
    switch (feel.kind) {
      case Feel::Kind::Solid:
        return middle + kBall + kTool;
      case Feel::Kind::NotThere:
        return middle - kBall + kTool;
      default:
        return kTool;
    }
  }
};
constexpr double kDeep = -1e-3, kHigh = 1e-3;  // m
const FeltBall kBalls[] = {
    {"as the scan has it", {}, kDeep},
    {"softer", {.kind = Feel::Kind::Softer, .stiffness = 300.0}, kDeep},
    {"guarded", {.kind = Feel::Kind::Guarded, .margin = 2e-3, .most = 1.5}, kDeep},
    {"solid", {.kind = Feel::Kind::Solid}, kHigh},
    {"not there", {.kind = Feel::Kind::NotThere}, kDeep}};

struct Touched {
  std::shared_ptr<const haptics::Scene> scene;
  std::shared_ptr<const haptics::Watch> watch;
};

Touched touchedAs(const FeltBall& ball, unsigned seed) {
  const haptics::Grid grid = datasets::centredGrid(64, 64, 72, kVoxel);
  auto grain = datasets::grains(seed);
  auto scan = std::make_shared<const haptics::Volume>(
      datasets::filled(grid, haptics::ScalarType::Int16, [&](auto, auto, std::int64_t k) {
        // bone rises over three voxels, as a scanner draws it
        const double z = grid.origin.z() + double(k) * kVoxel;
        const double share = std::clamp(0.5 - z / (3.0 * kVoxel), 0.0, 1.0);
        return -1000.0 + 2600.0 * share + 40.0 * grain();
      }));
  auto watch = std::make_shared<haptics::Watch>();
  const Vec3 middle{0.0, 0.0, ball.middle};
  watch->structures.push_back(
      {0, datasets::distanceMap(grid, [&](const Vec3& p) { return (p - middle).norm() - kBall; }),
       ball.feel});
  std::vector<datasets::StructureWall> walls;
  if (ball.feel.isWall())
    walls.push_back({0, ball.feel.kind == Feel::Kind::Solid, watch->structures.front().distances});
  const auto volume = datasets::walled(scan, walls, kIsovalue).value();
  return {haptics::makeScene(volume, toolOf(datasets::ballPoints(100, kTool))).value(), watch};
}

Outcome feltAs(const FeltBall& ball, std::uint64_t seed) {
  Findings found;
  const Touched touched = touchedAs(ball, unsigned(601 + seed));
  // the device of the highest rating
  haptics::DeviceModel device = haptics::deviceModels().front();
  for (const haptics::DeviceModel& one : haptics::deviceModels())
    if (one.rating.stiffness > device.rating.stiffness) device = one;
  const Wall wall = asShipped(device);
  const double rated = allowedFor(wall, *touched.scene);
  const double force = std::min(kPress, 0.5 * device.rating.force);
  for (const double K : {1000.0, rated}) {
    const double deep = force * (1.0 / K + 1.0 / wall.hand.stiffness);
    const Vec3 up{0.0, 0.0, kHeight}, down{0.0, 0.0, ball.rest() - deep}, aside{8e-3, 1e-3, 0.0};
    const Vec3 low{0.0, 0.0, kTool - deep};
    const std::pair<const char*, std::vector<Vec3>> ways[] = {
        {"press", {up, down, down, up}},
        {"slide", {up - aside, low - aside, low + aside, low - aside, up - aside}}};
    for (const auto& [way, corners] : ways) {
      haptics::ClosedLoop loop = loopOf({wall, K, true}, touched.scene, kIsovalue);
      loop.watch = touched.watch;
      const double wait = loop.limits.ramp_time;
      const LoopResult r = runLoop(loop, along(corners, wait),
                                   std::lround(timeAlong(corners, wait) / wall.period), wait);
      found.row("A structure that is felt",
                {{"felt", ball.name},
                 {"hand", way},
                 {"device", device.name},
                 {"K [N/m]", shortly(K)},
                 {"energy given in all [mJ]", shortly(1e3 * r.energy)},
                 {"most, beyond what damping takes [mJ]", shortly(1e3 * r.balance.most_left)},
                 {"largest force [N]", shortly(r.force)},
                 {"force step [N]", shortly(r.force_step)},
                 {"contact", std::to_string(r.contact)}});
      found.subject = std::string{"structure "} + ball.name + "/" + way + "/" + shortly(K) + " N/m";
      found.atMost("energy given", 1e3 * r.energy, 1.0, "mJ");
      found.atMost("energy given beyond what damping takes, most", 1e3 * r.balance.most_left, 1.0,
                   "mJ");
      // a guard turns round where another point of the tool becomes the nearest
      const bool guarded = ball.feel.kind == Feel::Kind::Guarded;
      found.atMost("force step", r.non_finite > 0 ? NAN : r.force_step,
                   1.5 + (guarded ? 2.0 * ball.feel.most : 0.0), "N", "in a tick");
      found.none("not finite", r.non_finite);
      found.none("looks that found it inside", r.inside);
      found.atLeast("milliseconds in contact",
                    std::min(kContactEnough, 1e3 * wall.period * r.contact), 100.0, "",
                    "counted up to 200, so that there is something to be judged");
    }
  }
  return std::move(found.outcome);
}

}  // namespace

std::vector<Job> structureJobs() {
  std::vector<Job> jobs;
  for (const FeltBall& ball : kBalls)
    jobs.push_back({std::string{"structures/"} + ball.name, "Structures that are felt", 1.0,
                    [&ball](std::uint64_t seed) { return feltAs(ball, seed); }});
  return jobs;
}

}  // namespace study::stability
