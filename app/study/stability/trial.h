// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/study/comparison/measures.h"
#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "haptics/proxy/tick.h"

namespace study::stability {

using datasets::at;
using datasets::Random;
using haptics::Pose;
using haptics::Vec3;
using SharedScene = std::shared_ptr<const haptics::Scene>;

/// A figure over some ticks.
struct Figures {
  double most = 0.0, least = INFINITY, mean = 0.0;
};

/// A proxy in a scene, moved tick by tick. Every pose that it takes is judged, by an evaluator that
/// shares no code with the field. All work is counted, so that every run is the same.
struct Trial {
  Trial(SharedScene in, double s, const Pose& X_start)
      : scene{std::move(in)}, isovalue{s}, proxy{*scene, X_start} {}

  SharedScene scene;
  double isovalue;
  haptics::VirtualCoupling coupling{1000.0, 0.0};
  haptics::Proxy proxy;
  haptics::TickResult last = {};
  std::string name = "all trials";  ///< of the line that tells how far it was from its device
  int illegal = 0;                  ///< ticks with a shell point inside
  int contact = 0;                  ///< ticks in contact
  int non_finite = 0;               ///< ticks with a pose or wrench that is no number
  bool judged = true;
  haptics::ServoRate rate = {};
  std::int64_t allowance = haptics::kTickWork;  ///< units of work a tick may spend
  std::int64_t most_work = 0;                   ///< spent in any tick
  std::vector<float> behind = {};               ///< m, how far from the device, after each tick

  const haptics::TickResult& step(const Pose& X_WD) {
    haptics::Budget budget = haptics::Budget::counted(allowance);
    last = haptics::tick(*scene, isovalue, coupling, X_WD, proxy, budget, rate.period());
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
    for (int n = 1; n <= ticks; ++n) step(comparison::between(from, to, double(n) / ticks));
  }
  void hold(const Pose& X_WD, int ticks = 200) {
    for (int n = 0; n < ticks; ++n) step(X_WD);
  }
  /// Moves the device to device(n) in each of `ticks` ticks; what figure(n) is after it.
  template <class Device, class Figure>
  Figures follow(int ticks, Device&& device, Figure&& figure) {
    Figures figures;
    for (int n = 0; n < ticks; ++n) {
      step(device(n));
      const double value = figure(n);
      figures.most = std::max(figures.most, value);
      figures.least = std::min(figures.least, value);
      figures.mean += value / ticks;
    }
    return figures;
  }
  /// Holds the device; whether the proxy was still meanwhile, to the bit.
  bool isStill(const Pose& X_WD, int ticks) {
    const Pose before = proxy.X_WP;
    hold(X_WD, ticks);
    return isAt(before);
  }
  /// Holds the device until the proxy has arrived there to the bit; the ticks it took, or `most`.
  int ticksToReach(const Pose& X_WD, int most) {
    for (int n = 1; n <= most; ++n)
      if (step(X_WD); isAt(X_WD)) return n;
    return most;
  }
  /// Presses and drags the tool about `middle` at random, as far as `reach` [m], 40 ticks a move.
  void drag(const Vec3& middle, double reach, unsigned seed, int moves) {
    Random random{seed};
    Pose from = proxy.X_WP;
    for (int n = 0; n < moves; ++n) {
      const Pose to = at(middle + random.box(reach), random.rotation());
      carry(from, to, 40);
      from = to;
    }
  }
  bool isAt(const Pose& X_W) const { return proxy.X_WP.matrix() == X_W.matrix(); }
  bool isLegal() const {
    return evaluator::isLegal(*scene->volume, isovalue, scene->tool.shell.points, proxy.X_WP);
  }
  Vec3 place() const { return proxy.X_WP.translation(); }
  /// The least distance along n of any point of the tool [m].
  double lowest(const Vec3& n) const {
    double least = INFINITY;
    for (const Vec3& p : scene->tool.shell.points) least = std::min(least, n.dot(proxy.X_WP * p));
    return least;
  }
};

}  // namespace study::stability
