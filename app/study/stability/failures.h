// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/study/report/outcome.h"
#include "app/study/stability/trial.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"

namespace study::stability {

/// Situations in which the paper's method, or a plausible step beyond it, fails: each a case with
/// its bound. A quick study makes a tenth of the tries.
std::vector<Job> failureJobs(Depth depth);

using datasets::Random;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;

inline constexpr double h = 1e-3;  ///< m: the voxel, where nothing else is said
/// What a tick may spend beyond its allowance before it looks at the budget again.
inline constexpr double kMostWork = double(haptics::kTickWork + haptics::kTickWork / 5);

/// A group's jobs. `tries` is 1 for a quick study, 10 for a full one.
std::vector<Job> surfaces(int tries);  ///< thin, noisy, long voxels
std::vector<Job> insides(int tries);   ///< isovalues that move, plateaus, numbers that are none
std::vector<Job> motions(int tries);   ///< leaps, turns, long slides, grooves, rest
std::vector<Job> shells(int tries);    ///< very many points, very few, very large, very far

inline Pose at(const Vec3& p, const Quat& q = Quat::Identity()) { return haptics::poseOf(p, q); }
inline Pose at(double x, double y, double z) { return at(Vec3{x, y, z}); }
inline haptics::Tool toolOf(std::vector<Vec3> points) {
  return {"", {}, haptics::makeShell(std::move(points)).value()};
}
inline std::shared_ptr<const haptics::Scene> sceneOf(haptics::Volume volume, haptics::Tool tool) {
  return haptics::makeScene(std::make_shared<const haptics::Volume>(std::move(volume)),
                            std::move(tool))
      .value();
}
inline haptics::Grid cube(std::int64_t n, double spacing = h) {
  return datasets::centredGrid(n, spacing);
}
inline haptics::Tool ball(int count, double radius) {
  return toolOf(datasets::ballPoints(count, radius));
}
/// A ball of 15 mm whose surface is a ramp of six voxels, under noise: a share of the range.
std::shared_ptr<const haptics::Scene> noisySphere(double noise, unsigned seed, haptics::Tool tool);
/// A ball of 20 mm.
std::shared_ptr<const haptics::Scene> sphere(haptics::Tool tool);
/// Presses and drags a tool about `middle` at random, as far as `reach` [m], 40 ticks a move.
void drag(Trial& trial, const Vec3& middle, double reach, unsigned seed, int moves);

/// How far the proxies of some trials were from their devices, tick by tick.
class DeviceDistances {
 public:
  void add(const Trial& trial);
  /// Mean, least and greatest of all trials over time.
  Plot plot(const std::string& name) const;

 private:
  struct Tick {
    int trials = 0;
    double sum = 0.0, least = INFINITY, greatest = 0.0;  // m
  };
  std::vector<Tick> ticks_;
};

/// What goes for every trial: outside in every tick, finite, within the budget.
struct Watch {
  int illegal = 0, non_finite = 0;
  std::int64_t most_work = 0;
  DeviceDistances recorder = {};
  void add(const Trial& trial) {
    recorder.add(trial);
    illegal += trial.illegal;
    non_finite += trial.non_finite;
    most_work = std::max(most_work, trial.most_work);
  }
  /// The cases about it, named `name`/…, and what the proxies did.
  void tell(const std::string& name, Outcome& outcome) const {
    outcome.cases.push_back({name + "/ticks inside", double(illegal), 0.0, ""});
    outcome.cases.push_back({name + "/not finite", double(non_finite), 0.0, ""});
    outcome.cases.push_back({name + "/most work in a tick", double(most_work), kMostWork, "units",
                             Case::Sense::AtMost,
                             "the budget, and a fifth that may come between two looks at it"});
    outcome.plots.push_back(recorder.plot(name));
  }
};

/// Every n-th value over ticks (1 ms each), as one line of a plot.
struct Trace {
  std::string name;
  int every = 10;
  std::vector<PlotPoint> points = {};
  void add(int tick, double value) {
    if (tick % every == 0) points.push_back({1e-3 * tick, value});
  }
  Series series() const { return {name, points}; }
};

inline Plot overTime(std::string title, std::string description, std::string y) {
  return {std::move(title), std::move(description), {"time [s]"}, {std::move(y)}};
}

}  // namespace study::stability
