// SPDX-License-Identifier: BSD-3-Clause
// A burr that cuts plates, edges and thin walls, also while the isovalue moves.
#include "app/study/stability/cuts.h"

#include <cstring>
#include <numbers>
#include <set>

#include "app/study/stability/failures.h"
#include "datasets/phantoms/sampling.h"

namespace study::stability {
namespace {

constexpr double kCutVoxel = 5e-4, kBurrRadius = 2e-3;  // m
constexpr double kCutIsovalue = 300.0;
constexpr double kCutPress = 2.0;        // N
constexpr double kDeepestCut = 5e-3;     // m of the hand beyond the surface
constexpr double kAbove = 6e-3;          // m, from where it comes
constexpr double kLongestInside = 20.0;  // ms, as of F4
constexpr double kThin = 1.5e-3;         // m

/// m to the surface, positive outside; all surfaces have their top at z = 0.
double distanceTo(const std::string& stage, const Vec3& p) {
  if (stage == "edge") return (std::abs(p.x()) + p.z()) * std::numbers::sqrt2 / 2.0;
  if (stage == "thin wall") return std::abs(p.z() + 0.5 * kThin) - 0.5 * kThin;
  if (stage == "upright wall") return std::max(std::abs(p.x()) - 0.5 * kThin, p.z());
  return p.z();
}

SharedScene sceneWith(const std::string& stage, unsigned seed) {
  const haptics::Grid grid = datasets::centredGrid(56, 48, 48, kCutVoxel);
  auto grain = datasets::grains(seed);
  // bone rises over three voxels, as a scanner draws it
  return sceneOf(datasets::filled(grid, haptics::ScalarType::Int16,
                                  [&](auto i, auto j, auto k) {
                                    const Vec3 p = grid.worldOf({double(i), double(j), double(k)});
                                    const double d = distanceTo(stage, p) / (3.0 * kCutVoxel);
                                    return -1000.0 + 2600.0 * std::clamp(0.5 - d, 0.0, 1.0) +
                                           40.0 * grain();
                                  }),
                 toolOf(datasets::ballPoints(300, kBurrRadius)));
}

/// Set 60 times a second, as by a slider; rises by 200 in two seconds, or goes 300 to either side
/// once a second.
double isovalueAt(IsovalueWay way, double time) {
  const double t = std::floor(60.0 * std::max(0.0, time)) / 60.0;
  switch (way) {
    case IsovalueWay::Rising:
      return kCutIsovalue + std::min(200.0, 100.0 * t);
    case IsovalueWay::ToAndFro:
      return kCutIsovalue + 300.0 * std::sin(2.0 * std::numbers::pi * t);
    default:
      return kCutIsovalue;
  }
}

const char* nameOf(IsovalueWay way) {
  return way == IsovalueWay::Still ? "still" : way == IsovalueWay::Rising ? "rising" : "to and fro";
}

/// The voxels of a volume, to be changed.
struct OwnVoxels {
  explicit OwnVoxels(const haptics::Volume& of)
      : bytes{std::size_t(of.grid.voxelCount()) * haptics::sizeOf(of.type)},
        voxels{haptics::allocateVoxels(of.grid.voxelCount(), of.type).value()},
        volume{of} {
    std::memcpy(voxels.get(), of.voxels.get(), bytes);
    volume.voxels = voxels;
  }
  /// Takes the voxels of a box over from another volume of the same grid.
  void take(const haptics::Volume& from, const haptics::VoxelBox& box) {
    const std::size_t size = haptics::sizeOf(volume.type);
    const auto& dims = volume.grid.dims;
    for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) {
        const std::size_t at = size * std::size_t((k * dims[1] + j) * dims[0] + box.first[0]);
        std::memcpy(static_cast<std::byte*>(voxels.get()) + at,
                    static_cast<const std::byte*>(from.voxels.get()) + at,
                    size * std::size_t(box.end[0] - box.first[0]));
      }
  }
  std::vector<std::byte> copied() const {
    const auto* first = static_cast<const std::byte*>(voxels.get());
    return {first, first + bytes};
  }
  std::size_t bytes;
  std::shared_ptr<void> voxels;
  haptics::Volume volume;
};

void append(std::vector<double>& trace, const haptics::TraceRow& row) {
  const auto add = [&](const auto& matrix) {
    trace.insert(trace.end(), matrix.data(), matrix.data() + matrix.size());
  };
  add(row.X_WD.matrix());
  add(row.X_WP.matrix());
  add(row.sent_W.force);
  add(row.sent_W.torque);
}

Outcome cutsOf(const std::string& job, const std::string& stage, const Wall& wall,
               const std::vector<double>& stiffnesses, const std::vector<IsovalueWay>& isovalues,
               unsigned seed) {
  Findings found;
  const double allowed = allowedFor(wall, *sceneWith(stage, seed));
  std::vector<double> all = stiffnesses;
  all.push_back(allowed);
  std::ranges::sort(all);
  for (const IsovalueWay isovalue : isovalues)
    for (const bool slides : {false, true}) {
      found.subject = job + "/isovalue " + nameOf(isovalue) + "/" + (slides ? "slide" : "press");
      int inside = 0, entered = 0, longest = 0, non_finite = 0, unlike = 0, unlike_anew = 0;
      double given = -INFINITY, left = -INFINITY, removed = INFINITY;
      for (const double K : all) {
        const CutWay way{stage, wall, K, seed, slides, isovalue};
        const CutResult cut = runCut(way, softBone()), again = runCut(way, softBone(), false);
        const LoopResult& r = cut.loop;
        found.row("A burr that cuts",
                  {{"stage", stage},
                   {"hand", slides ? "slide" : "press"},
                   {"isovalue", nameOf(isovalue)},
                   {"device", wall.device.name},
                   {"rate", rateOf(wall.period)},
                   {"K [N/m]", shortly(K)},
                   {"of what is allowed", shortly(K / allowed)},
                   {"removed [mm3]", shortly(1e9 * cut.removed)},
                   {"energy given in all [mJ]", shortly(1e3 * r.energy)},
                   {"most, beyond what damping takes [mJ]", shortly(1e3 * r.balance.most_left)},
                   {"largest force [N]", shortly(r.force)},
                   {"force step [N]", shortly(r.force_step)},
                   {"ticks inside", std::to_string(cut.inside)},
                   {"longest inside", std::to_string(cut.longest_inside)},
                   {"contact", std::to_string(r.contact)},
                   {"left by the guard", shortly(r.share)}});
        // of these nothing is forgiven, however stiff
        inside += cut.inside;
        entered += cut.entered;
        longest = std::max(longest, cut.longest_inside);
        non_finite += r.non_finite;
        unlike += cut.trace != again.trace || cut.left != again.left;
        unlike_anew += cut.left != cut.carved_anew;
        if (K > allowed) continue;
        given = worse(given, 1e3 * r.energy);
        left = worse(left, 1e3 * r.balance.most_left);
        removed = std::min(removed, 1e9 * cut.removed);
      }
      const std::string range = "up to " + shortly(allowed) + " N/m, which is allowed";
      found.atMost("energy given", given, 1.0, "mJ", range);
      found.atMost("energy given beyond what damping takes, most", left, 1.0, "mJ", range);
      if (isovalue != IsovalueWay::ToAndFro) {
        found.none("ticks inside what is left", inside);
      } else {
        // a solid that grows may grow over the tool, which is then brought out
        found.none("times inside what is left though the isovalue had not fallen", entered);
        found.atMost("longest inside after the isovalue fell", 1e3 * wall.period * longest,
                     kLongestInside, "ms", "of " + std::to_string(inside) + " ticks in all");
      }
      found.none("not finite", non_finite);
      found.none("runs unlike their repetition", unlike);
      found.none("runs whose voxels are not those of their cuts", unlike_anew);
      found.atLeast("removed", removed, 0.5, "mm3", "so that there is something to be judged");
    }
  return std::move(found.outcome);
}

}  // namespace

const std::vector<std::string>& cutStages() {
  static const std::vector<std::string> kStages{"plate", "edge", "thin wall", "upright wall"};
  return kStages;
}

haptics::CutLaw softBone() {
  haptics::CutLaw law;
  law.burr = {Vec3::Zero(), kBurrRadius};
  // J/m3: a fifth of the program's own, so that a press breaks through a thin wall
  law.material.bands[0].energy = 0.2e9;
  return law;
}

CutResult runCut(const CutWay& way, const haptics::CutLaw& law, bool judged) {
  const SharedScene scene = sceneWith(way.stage, way.seed);
  haptics::ClosedLoop loop = loopOf({way.wall, way.stiffness, true}, scene, kCutIsovalue);
  loop.cut = law;
  const double force = std::min(kCutPress, 0.5 * way.wall.device.rating.force);
  const double deep =
      std::min(force * (1.0 / way.stiffness + 1.0 / way.wall.hand.stiffness), kDeepestCut);
  // a corner lies deeper than the ball that rests on it
  const double rest = way.stage == "edge" ? kBurrRadius * std::numbers::sqrt2 : kBurrRadius;
  const Vec3 up{0.0, 0.0, kAbove}, down{0.0, 0.0, rest - deep}, aside{6e-3, 1e-3, 0.0};
  const std::vector<Vec3> corners =
      way.slides
          ? std::vector<Vec3>{up - aside, down - aside, down + aside, down - aside, up - aside}
          : std::vector<Vec3>{up, down, down, down, up};
  const double wait = loop.limits.ramp_time;

  CutResult result;
  OwnVoxels seen{*scene->volume}, anew{*scene->volume};
  haptics::VoxelBox under_way;
  int in_a_row = 0;
  double isovalue_before = kCutIsovalue;
  std::shared_ptr<const haptics::Scene> cut_scene;
  const auto each = [&](const haptics::TraceRow& row) {
    append(result.trace, row);
    // in what there was before this tick cut: that is where its pose was found
    if (judged && !evaluator::isLegal(seen.volume, loop.settings.isovalue, scene->tool.shell.points,
                                      row.X_WP)) {
      ++result.inside;
      result.entered += in_a_row++ == 0 && loop.settings.isovalue >= isovalue_before;
      result.longest_inside = std::max(result.longest_inside, in_a_row);
    } else {
      in_a_row = 0;
    }
    isovalue_before = loop.settings.isovalue;
    cut_scene = row.cutting->scene();
    if (const auto& begun = row.cutting->begun()) {
      result.cuts.push_back(*begun);
      under_way = haptics::BurrCarving{*scene->volume, *begun}.box();
    }
    if (!isEmpty(under_way)) seen.take(*cut_scene->volume, under_way);
    result.removed = row.cutting->removed().volume;
    loop.settings.isovalue = isovalueAt(way.isovalue, row.time - wait);
  };
  result.loop =
      runLoop(loop, along(corners, wait), std::lround(timeAlong(corners, wait) / way.wall.period),
              wait, INFINITY, each);
  if (cut_scene) result.left = OwnVoxels{*cut_scene->volume}.copied();
  for (const haptics::BurrCut& cut : result.cuts)
    haptics::BurrCarving{*scene->volume, cut}.lowerAll(anew.voxels.get(),
                                                       scene->volume->voxels.get());
  result.carved_anew = anew.copied();
  return result;
}

std::vector<Job> cutJobs(Depth depth) {
  const bool full = depth == Depth::Full;
  // a coarse encoder, torque motors, the stiffest, the weakest
  const std::set<std::string> devices =
      full ? std::set<std::string>{"falcon", "sigma.7", "lambda.7", "touch"}
           : std::set<std::string>{"falcon"};
  const std::vector<double> stiffnesses =
      full ? std::vector{50.0, 200.0, 1000.0, 5000.0, 20000.0} : std::vector{50.0, 20000.0};
  std::vector<IsovalueWay> isovalues{IsovalueWay::Still, IsovalueWay::ToAndFro};
  if (full) isovalues.push_back(IsovalueWay::Rising);
  std::vector<Job> jobs;
  for (const haptics::DeviceModel& device : haptics::deviceModels()) {
    if (!devices.contains(device.name)) continue;
    for (const std::string& stage : cutStages()) {
      const std::string name = "cuts/" + device.name + "/" + stage;
      if (!full && stage == "upright wall") continue;
      jobs.push_back({name, "A burr that cuts", full ? 60.0 : 3.0, [=](std::uint64_t seed) {
                        return cutsOf(name, stage, asShipped(device), stiffnesses, isovalues,
                                      unsigned(701 + seed));
                      }});
    }
  }
  return jobs;
}

}  // namespace study::stability
