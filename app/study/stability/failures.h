// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "app/study/stability/findings.h"
#include "app/study/stability/trial.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"

namespace study::stability {

using datasets::Random;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;

inline constexpr double h = 1e-3;  ///< m: the voxel, where nothing else is said

inline Pose at(const Vec3& p, const Quat& q = Quat::Identity()) { return haptics::poseOf(p, q); }
inline Pose at(double x, double y, double z) { return at(Vec3{x, y, z}); }
inline Quat turn(double angle, const Vec3& axis) { return Quat{Eigen::AngleAxisd{angle, axis}}; }
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
/// Voxels of 16 bits from f(i, j, k), `n` a side.
template <class F>
haptics::Volume voxels(std::int64_t n, F&& f) {
  return datasets::filled(cube(n), haptics::ScalarType::Int16, f);
}
inline haptics::Tool ball(int count, double radius) {
  return toolOf(datasets::ballPoints(count, radius));
}
/// A solid whose values ramp over six voxels, from -300 outside to 300 inside, under noise: a share
/// of that range. `distance(p_W)` [m] is positive outside.
template <class Distance>
haptics::Volume ramp(double noise, unsigned seed, Distance&& distance) {
  std::mt19937 engine{seed};
  std::normal_distribution<double> grain{0.0, 1.0};
  return datasets::sampledFloat(cube(48), [&](const Vec3& p) {
    return std::clamp(-1e5 * distance(p), -300.0, 300.0) +
           (noise > 0.0 ? 600.0 * noise * grain(engine) : 0.0);
  });
}
/// A ball in `n` voxels a side, whose values ramp over `reach` voxels on either side of its
/// surface.
std::shared_ptr<const haptics::Scene> sphere(haptics::Tool tool, double radius = 0.02,
                                             double reach = 3.0, std::int64_t n = 64);
/// A ball of 15 mm, as a ramp under noise.
std::shared_ptr<const haptics::Scene> noisySphere(double noise, unsigned seed, haptics::Tool tool);
/// A trial whose device went from `from` to `to` in `ticks` ticks and was held there for some more.
inline Trial brought(std::shared_ptr<const haptics::Scene> scene, double isovalue, const Pose& from,
                     const Pose& to, int ticks, int held = 0) {
  Trial trial{std::move(scene), isovalue, from};
  trial.carry(from, to, ticks);
  trial.hold(to, held);
  return trial;
}
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
    void add(const Tick& other);
  };
  std::vector<Tick> ticks_;
};

/// A value over ticks (1 ms each), every n-th of them as a point of one line of a plot.
struct Trace {
  std::string name;
  int every = 10;
  std::vector<PlotPoint> points = {};
  double most = 0.0;
  void add(int tick, double value) {
    most = std::max(most, value);
    if (tick % every == 0) points.push_back({1e-3 * tick, value});
  }
  Series series() const { return {name, points}; }
};

/// What the trials of one failure come to.
class Trials : public Findings {
 public:
  /// `tries` is 1 for a quick study, 10 for a full one.
  Trials(const char* called, int n, std::uint64_t of)
      : Findings{called, {}}, title{called}, tries{n}, seed{unsigned(of)} {}
  std::string title;
  const int tries;
  const unsigned seed;
  std::vector<Plot> plots = {};  ///< shown after those of the distances from the device

  /// Counts a trial in the cases that go for all of them.
  void add(const Trial& trial);
  /// The trial by itself, which must have touched.
  void tellContact(const std::string& name, const Trial& trial);
  /// A plot over time.
  Plot& plot(const char* heading, const char* description, const char* y,
             std::vector<Series> lines);
  /// All of it, with what goes for every trial: outside in every tick, finite, within the budget.
  Outcome told();

 private:
  struct Sum {
    int trials = 0, illegal = 0, non_finite = 0;
    std::int64_t most_work = 0;
    DeviceDistances distances = {};
  };
  void tellSum();
  Sum sum_ = {};
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
