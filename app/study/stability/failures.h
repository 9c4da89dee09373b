// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "app/study/stability/stability.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/servo/tick.h"

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
inline haptics::Tool ball(int count, double radius) {
  return toolOf(datasets::ballPoints(count, radius));
}
inline std::shared_ptr<const haptics::Scene> sceneOf(haptics::Volume volume, haptics::Tool tool) {
  return haptics::makeScene(std::make_shared<const haptics::Volume>(std::move(volume)),
                            std::move(tool))
      .value();
}
inline haptics::Grid cube(std::int64_t n, double spacing = h) {
  return datasets::centredGrid(n, spacing);
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
/// A ball of 15 mm, as such a ramp.
std::shared_ptr<const haptics::Scene> noisySphere(double noise, unsigned seed, haptics::Tool tool);
/// A ball in `n` voxels a side, whose values ramp over `reach` voxels on either side of its
/// surface.
std::shared_ptr<const haptics::Scene> sphere(haptics::Tool tool, double radius = 0.02,
                                             double reach = 3.0, std::int64_t n = 64);

/// Whether every shell point is outside at a pose, by a judge that shares no code with the field.
using PoseCheck = bool (*)(const haptics::Volume&, double isovalue, const std::vector<Vec3>&,
                           const Pose&);
/// The check of the study: the paper's solid in `reference`, with F = s inside.
bool isOutside(const haptics::Volume& volume, double isovalue, const std::vector<Vec3>& points,
               const Pose& X_WP);

/// A proxy in a scene, moved tick by tick. Every pose that it takes is judged. All work is counted,
/// so that every run is the same.
struct Trial {
  Trial(std::shared_ptr<const haptics::Scene> in, double s, const Pose& X_start,
        PoseCheck by = isOutside)
      : scene{std::move(in)}, isovalue{s}, judge{by}, proxy{*scene, X_start} {}

  std::shared_ptr<const haptics::Scene> scene;
  double isovalue;
  PoseCheck judge;
  haptics::VirtualCoupling coupling{1000.0, 0.0};
  haptics::Proxy proxy;
  haptics::TickResult last = {};
  int illegal = 0;     ///< ticks with a shell point inside
  int contact = 0;     ///< ticks in contact
  int non_finite = 0;  ///< ticks with a pose or wrench that is no number
  bool judged = true;
  std::int64_t allowance = haptics::kTickWork;  ///< units of work a tick may spend
  std::int64_t most_work = 0;                   ///< spent in any tick
  std::vector<float> behind = {};               ///< m, how far from the device, after each tick

  const haptics::TickResult& step(const Pose& X_WD) {
    haptics::Budget budget = haptics::Budget::counted(allowance);
    last = haptics::tick(*scene, isovalue, coupling, X_WD, proxy, budget);
    most_work = std::max(most_work, budget.spent());
    contact += last.contacts > 0;
    behind.push_back(float((place() - X_WD.translation()).norm()));
    non_finite += !proxy.X_WP.matrix().allFinite() || !std::isfinite(last.wrench_W.force.norm()) ||
                  !std::isfinite(last.wrench_W.torque.norm());
    if (judged) illegal += !isLegal();
    return last;
  }
  /// Moves the device there along a line in `ticks` ticks, from where `from` says.
  void carry(const Pose& from, const Pose& to, int ticks) {
    for (int n = 1; n <= ticks; ++n) {
      const double share = double(n) / ticks;
      step(at(from.translation() + share * (to.translation() - from.translation()),
              Quat{from.linear()}.slerp(share, Quat{to.linear()})));
    }
  }
  void hold(const Pose& X_WD, int ticks = 200) {
    for (int n = 0; n < ticks; ++n) step(X_WD);
  }
  /// Holds the device until the proxy has arrived there to the bit; the ticks it took, or `most`.
  int ticksToReach(const Pose& X_WD, int most) {
    for (int n = 1; n <= most; ++n)
      if (step(X_WD); proxy.X_WP.matrix() == X_WD.matrix()) return n;
    return most;
  }
  bool isLegal() const {
    return judge(*scene->volume, isovalue, scene->tool.shell.points, proxy.X_WP);
  }
  Vec3 place() const { return proxy.X_WP.translation(); }
  /// The least distance along n of any point of the tool [m].
  double lowest(const Vec3& n) const {
    double least = INFINITY;
    for (const Vec3& p : scene->tool.shell.points) least = std::min(least, n.dot(proxy.X_WP * p));
    return least;
  }
};
/// Presses and drags a tool about `middle` at random, as far as `reach` [m], 40 ticks a move.
void drag(Trial& trial, const Vec3& middle, double reach, unsigned seed, int moves);

/// How far the proxies of some trials were from their devices [m], trial by trial and tick by tick:
/// mean, least and greatest of all trials over time.
Plot distancePlot(const std::string& name, const std::vector<std::vector<float>>& trials);

/// A figure in SI over ticks of 1 ms. Every n-th of them is a point of one line of a plot.
struct Trace {
  std::string name = {};  ///< of the line; without one there is no line
  int every = 10;
  double scale = 1e3;  ///< from SI to the plot's unit
  std::vector<PlotPoint> points = {};
  double most = 0.0, least = INFINITY, mean = 0.0;
  void add(int tick, double value) {
    most = std::max(most, value);
    least = std::min(least, value);
    if (tick % every == 0) points.push_back({1e-3 * tick, scale * value});
  }
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
  std::vector<Series> lines = {};  ///< of the next plot over time

  /// Moves the device to device(n) in each of `ticks` ticks and traces figure(n) after it.
  template <class Device, class Figure>
  Trace follow(Trial& trial, int ticks, Trace trace, Device&& device, Figure&& figure) {
    for (int n = 0; n < ticks; ++n) {
      trial.step(device(n));
      const double value = figure(n);
      trace.add(n, value);
      trace.mean += value / ticks;
    }
    draw(trace);
    return trace;
  }
  void draw(const Trace& trace) {
    if (!trace.name.empty()) lines.push_back({trace.name, trace.points});
  }
  /// A trial from a pose on. It counts in the cases that go for all of them.
  Trial& trial(std::shared_ptr<const haptics::Scene> scene, double isovalue, const Pose& from) {
    return trials_.emplace_back(std::move(scene), isovalue, from);
  }
  /// The same, its device brought from one pose to another in `ticks` ticks and held for some more.
  Trial& brought(std::shared_ptr<const haptics::Scene> scene, double isovalue, const Pose& from,
                 const Pose& to, int ticks, int held = 0);
  /// Counts a trial that was made elsewhere.
  void add(const Trial& trial) { trials_.push_back(trial); }
  /// The last trial by itself, which must have touched.
  void tellContact(const std::string& name);
  using Findings::plot;
  /// A plot of the lines over time.
  Plot& plot(const char* heading, const char* description, const char* y) {
    return plot(heading, description, {"time [s]"}, {y}, std::exchange(lines, {}));
  }
  /// All of it, with what goes for every trial: outside in every tick, finite, within the budget.
  Outcome told();

 private:
  void tellTrials();
  std::deque<Trial> trials_ = {};  ///< not yet told
  int told_ = 0;                   ///< plots of distances from the device, which come first
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
