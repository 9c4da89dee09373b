// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "app/study/arcs/one_point.h"
#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/collision/clearance.h"
#include "haptics/collision/sweep.h"
#include "haptics/tool/point_shell.h"

/// Random arcs through volumes that are hard on collision detection, and what a dense sampling of
/// the field in double says of each.
namespace study::arcs {

using haptics::Vec3;

inline constexpr double h = 1e-3;  ///< m: the voxel of these volumes

/// A volume to shoot at.
struct Target {
  std::string name;
  std::shared_ptr<const haptics::Volume> volume;
  haptics::ScalarField field;
  std::vector<double> isovalues;
  double half;      ///< m: arcs start within this much of the middle
  int samples;      ///< of the dense sampling, along an arc
  double steepest;  ///< per metre: no slope is greater

  Target(std::string called, haptics::Volume made, std::vector<double> at, double within, int dense,
         haptics::FieldKind kind = haptics::FieldKind::Trilinear)
      : name{std::move(called)},
        volume{std::make_shared<const haptics::Volume>(std::move(made))},
        field{volume, kind},
        isovalues{std::move(at)},
        half{within},
        samples{dense},
        steepest{0.0} {
    // along an axis no slope of F, of either kind, is greater than the greatest step from voxel to
    // voxel
    const auto& dims = volume->grid.dims;
    Vec3 step = Vec3::Zero();
    for (std::int64_t k = 0; k < dims[2]; ++k)
      for (std::int64_t j = 0; j < dims[1]; ++j)
        for (std::int64_t i = 0; i < dims[0]; ++i) {
          const double here = evaluator::voxelAt(*volume, {i, j, k});
          step.x() =
              std::max(step.x(), std::abs(evaluator::voxelAt(*volume, {i + 1, j, k}) - here));
          step.y() =
              std::max(step.y(), std::abs(evaluator::voxelAt(*volume, {i, j + 1, k}) - here));
          step.z() =
              std::max(step.z(), std::abs(evaluator::voxelAt(*volume, {i, j, k + 1}) - here));
        }
    steepest = step.norm() / h;
  }
  /// F, without code of haptics/field but for the spline, which its own tests hold to its
  /// definition.
  double F(const Vec3& p_W) const {
    return field.kind() == haptics::FieldKind::Trilinear ? evaluator::fieldAt(*volume, p_W)
                                                         : field.value(field.indexOf(p_W));
  }
};

/// White noise, from a third to two standard deviations.
inline Target noise(unsigned seed) {
  return {"noise",
          datasets::whiteNoise(datasets::centredGrid(40, h), seed),
          {33.0, 67.0, 100.0, 133.0, 200.0},
          18 * h,
          600};
}
/// A plate one voxel thick and slanting, seen near its peak: what is inside are flakes of it.
inline Target slantedPlate(datasets::Random& random) {
  const Vec3 n = random.direction();
  auto volume = datasets::sampledFloat(datasets::centredGrid(40, h), [&](const Vec3& p) {
    return 1000.0 * std::max(0.0, 1.0 - std::abs(n.dot(p)) / h);
  });
  const double peak = volume.greatest;
  return {"slanted plate", std::move(volume), {0.8 * peak, 0.95 * peak, 0.99 * peak}, 4 * h, 1200};
}
/// Upright plates, 0.4, 0.1 and 0.02 voxel thick at these isovalues.
inline Target uprightPlates() {
  return {"upright plates",
          datasets::filled(datasets::centredGrid(40, h), haptics::ScalarType::Int16,
                           [](auto i, auto, auto) { return i % 8 == 4 ? 1000.0 : 0.0; }),
          {800.0, 950.0, 990.0},
          15 * h,
          1200};
}
/// A gyroid of twelve voxels' period: smooth, and curved everywhere.
inline Target gyroid() {
  static constexpr double kWave = 2.0 * std::numbers::pi / (12.0 * h);
  return {"gyroid",
          datasets::sampledFloat(datasets::centredGrid(40, h),
                                 [](const Vec3& p) {
                                   const Vec3 q = kWave * p;
                                   return 1000.0 * (std::sin(q.x()) * std::cos(q.y()) +
                                                    std::sin(q.y()) * std::cos(q.z()) +
                                                    std::sin(q.z()) * std::cos(q.x()));
                                 }),
          {-500.0, 0.0, 500.0, 1200.0, 1400.0},
          18 * h,
          400};
}

struct Tally {
  long arcs = 0;
  long met = 0;
  long missed = 0;  ///< inside somewhere on the way, and not met
  /// Met more than 1e-3 voxel of path beyond the first place inside, and where F is more than
  /// 1e-4 voxel of the steepest slope above: an arc that grazes stays at the surface for long.
  long late = 0;
  long early = 0;       ///< stopped where F is below what sagitta, root and guard amount to
  double latest = 0.0;  ///< voxels of path; the greatest lateness

  Tally& operator+=(const Tally& other) {
    arcs += other.arcs;
    met += other.met;
    missed += other.missed;
    late += other.late;
    early += other.early;
    latest = std::max(latest, other.latest);
    return *this;
  }
};

/// The first time at which the dense sampling finds the path inside: between samples it climbs to
/// the top wherever a slope could reach the isovalue, and closes in on the crossing.
inline std::optional<double> firstInside(const Target& target, double s,
                                         const haptics::PointPath& path, double until = 1.0) {
  const auto F = [&](double t) { return target.F(path.at(t)); };
  const int samples = std::max(8, int(target.samples * until));
  const double dt = until / samples, rise = target.steepest * path.speed() * dt;
  const auto closeIn = [&](double outside, double inside) {
    for (int n = 0; n < 30; ++n) {
      const double middle = 0.5 * (outside + inside);
      (F(middle) >= s ? inside : outside) = middle;
    }
    return inside;
  };
  double before = -std::numeric_limits<double>::infinity(), last = F(0.0);
  if (last >= s) return 0.0;
  for (int n = 1; n <= samples; ++n) {
    const double t = n * dt, now = F(t);
    if (before <= last && last >= now && last + rise >= s) {
      // a peak between the two samples beside it
      double from = std::max(0.0, t - 2.0 * dt), to = t;
      for (int step = 0; step < 24; ++step) {
        const double a = from + (to - from) / 3.0, b = to - (to - from) / 3.0;
        if (F(a) < F(b))
          from = a;
        else
          to = b;
      }
      const double top = 0.5 * (from + to);
      if (F(top) >= s) return closeIn(std::max(0.0, t - 2.0 * dt), top);
    }
    if (now >= s) return closeIn(t - dt, t);
    before = last;
    last = now;
  }
  return {};
}

/// Where a method stopped a path, if it met the surface.
struct Stop {
  const haptics::PointPath& path;
  double time;
  bool met;
};

/// Judges a stop, given where a path of this speed [m] first is inside.
inline void judge(const Target& target, double s, const std::optional<double>& first, double speed,
                  const Stop& stop, Tally& tally) {
  if (first) {
    const double late = (stop.time - *first) * speed / h;
    tally.missed += !stop.met;
    if (stop.met) tally.latest = std::max(tally.latest, late);
    tally.late += stop.met && late > 1e-3 &&
                  target.F(stop.path.at(stop.time)) > s + 1e-4 * h * target.steepest;
  }
  if (!stop.met) return;
  ++tally.met;
  tally.early += target.F(stop.path.at(stop.time)) < s - 5e-4 * h * target.steepest;
}

/// Up to 3 mm along and 0.35 rad about.
inline haptics::Twist anyMotion(datasets::Random& random) {
  return {3e-3 * random.in(0.0, 1.0) * random.direction(),
          0.35 * random.in(0.0, 1.0) * random.direction()};
}

/// Where a method stops an arc of one point at an isovalue.
using Detect = std::function<Crossing(const Target&, double s, const Arc&)>;
/// As a tick does, for a tool of one point.
inline Crossing detected(const Target& target, double s, const Arc& arc) {
  return crossed({target.field, s}, arc, haptics::Tolerances{h});
}

/// Arcs of one point, up to 20 mm from the tool's origin.
inline Tally shootPoints(const Target& target, long count, datasets::Random& random,
                         const Detect& detect = detected) {
  Tally tally;
  while (tally.arcs < count) {
    const double s =
        target.isovalues[static_cast<std::size_t>(random.below(int(target.isovalues.size())))];
    const haptics::Isosurface solid{target.field, s};
    const Vec3 r = random.in(0.0, 0.02) * random.direction();
    const Arc path{random.box(target.half) - r, r, anyMotion(random)};
    if (target.F(path.at(0.0)) >= solid.ceiling()) continue;
    ++tally.arcs;
    const Crossing crossing = detect(target, s, path);
    judge(target, s, firstInside(target, s, path), path.speed(),
          {path, crossing.time, crossing.met}, tally);
  }
  return tally;
}

/// Arcs of a tool of 20 points within 8 mm, each with the collision detection of the whole shell.
inline Tally shootShells(const Target& target, long count, datasets::Random& random) {
  Tally tally;
  haptics::Budget unlimited = haptics::Budget::counted(std::numeric_limits<std::int64_t>::max());
  while (tally.arcs < count) {
    const double s =
        target.isovalues[static_cast<std::size_t>(random.below(int(target.isovalues.size())))];
    const haptics::Isosurface solid{target.field, s};
    // small, so that it often finds a legal place among the specks
    const double size = random.in(0.2e-3, 8e-3);
    std::vector<Vec3> points;
    for (int n = 0; n < 20; ++n) points.push_back(random.box(size));
    const haptics::PointShell shell = haptics::makeShell(std::move(points)).value();
    const haptics::Pose X = haptics::poseOf(random.box(target.half), random.rotation());
    const haptics::Twist motion = anyMotion(random);
    const double reach = motion.linear.norm() + motion.angular.norm() * shell.radius;
    const haptics::ShellTree tree{shell.points};
    haptics::Clearance clearance{tree};
    if (clearance.collect(solid, tree, X, reach, unlimited) != haptics::Clearance::Verdict::Legal)
      continue;
    ++tally.arcs;
    const haptics::Tolerances lengths{h};
    haptics::Sweep sweep{shell.points.size()};
    sweep.begin(target.field, clearance, X, motion, lengths);
    while (!sweep.advance(solid, tree, clearance, lengths, unlimited)) {
    }
    const haptics::Impact impact = sweep.impact(solid, tree, lengths, unlimited);
    // the first of the points to be inside
    std::optional<double> first;
    double speed = 0.0;
    for (const Vec3& p : shell.points) {
      const haptics::PointPath path{X.translation(), X.linear() * p, motion};
      const auto inside = firstInside(target, s, path, first.value_or(1.0));
      if (!inside || (first && *inside >= *first)) continue;
      first = inside;
      speed = path.speed();
    }
    const auto point = static_cast<std::size_t>(impact.met ? impact.contact.point : 0);
    const haptics::PointPath path{X.translation(), X.linear() * shell.points[point], motion};
    judge(target, s, first, speed, {path, impact.time, impact.met}, tally);
  }
  return tally;
}

}  // namespace study::arcs
