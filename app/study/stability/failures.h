// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/study/comparison/scenes.h"
#include "app/study/stability/stability.h"
#include "app/study/stability/trial.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "datasets/phantoms/shapes.h"

namespace study::stability {

using comparison::ballTool;
using comparison::toolOf;
using datasets::at;
using datasets::kSolidIso;
using datasets::Random;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;

inline constexpr double h = 1e-3;  ///< m: the voxel, where nothing else is said

inline Quat turn(double angle, const Vec3& axis) { return Quat{Eigen::AngleAxisd{angle, axis}}; }
inline SharedScene sceneOf(haptics::Volume volume, haptics::Tool tool) {
  return haptics::makeScene(std::make_shared<const haptics::Volume>(std::move(volume)),
                            std::move(tool))
      .value();
}
inline haptics::Grid cube(std::int64_t n, double spacing = h) {
  return datasets::centredGrid(n, spacing);
}
/// One of the `shapes`, whose values ramp over six voxels, from -300 outside to 300 inside, under
/// noise: a share of that range.
template <class Shape>
haptics::Volume ramp(double noise, unsigned seed, const Shape& shape) {
  auto grain = datasets::grains(seed);
  return datasets::sampledFloat(cube(48), [&](const Vec3& p) {
    return std::clamp(-1e5 * shape.distance(p), -300.0, 300.0) +
           (noise > 0.0 ? 600.0 * noise * grain() : 0.0);
  });
}
/// A ball in `n` voxels a side, whose values ramp over `reach` voxels on either side of its
/// surface.
inline SharedScene sphere(haptics::Tool tool, double radius = 0.02, double reach = 3.0,
                          std::int64_t n = 64) {
  const auto distance = [&](const Vec3& p) { return p.norm() - radius; };
  return sceneOf(datasets::solid(cube(n), distance, reach), std::move(tool));
}

/// How far proxies were from their devices [m], with a line for the trials of each name: mean,
/// least and greatest of them over time.
Plot distancePlot(const std::string& title, const std::deque<Trial>& trials);

/// What the trials of one failure come to.
struct Trials : Findings {
  int tries;  ///< 1 for a quick study, 10 for a full one
  unsigned seed;
  std::deque<Trial> trials = {};  ///< not yet told

  /// A trial from a pose on. It counts in the cases that go for all of them.
  Trial& trial(SharedScene scene, double isovalue, const Pose& from) {
    return trials.emplace_back(std::move(scene), isovalue, from);
  }
  /// The same, its device brought from one pose to another in `ticks` ticks and held for some more.
  Trial& brought(SharedScene scene, double isovalue, const Pose& from, const Pose& to, int ticks,
                 int held = 0) {
    Trial& made = trial(std::move(scene), isovalue, from);
    made.carry(from, to, ticks);
    made.hold(to, held);
    return made;
  }
  /// What goes for every trial since the last time: outside in every tick, finite, within the
  /// budget. A plot tells how far they were from their devices.
  void tell();
  /// The same for the last trial by itself, which must have touched.
  void tellContact(const std::string& name) {
    subject = name;
    atLeast("ticks in contact", trials.back().contact, 1.0);
    tell();
  }
};

/// A row of the tables of failures.
struct Failure {
  const char *job, *title;
  double cost, cost_per_try;  ///< s, about
  void (*run)(Trials& found);
};
struct FailureGroup {
  const char* section;
  std::vector<Failure> failures;
};
FailureGroup surfaces();  ///< thin, noisy, long voxels
FailureGroup insides();   ///< isovalues that move, plateaus, numbers that are none
FailureGroup motions();   ///< leaps, turns, long slides, grooves, rest
FailureGroup shells();    ///< very many points, very few, very large, very far

}  // namespace study::stability
