// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/study/comparison/scenes.h"
#include "app/study/reference/tick.h"
#include "app/study/rivals/penalty.h"
#include "app/study/rivals/static_god_object.h"
#include "haptics/core/budget.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/rate.h"

namespace comparison {

using haptics::Pose;
using haptics::Vec3;
using haptics::Wrench;

/// What ends a tick of ours: CPU time of the thread, or counted work where results must repeat.
struct Limit {
  std::int64_t nanoseconds = 200'000;
  std::int64_t work = 0;  ///< > 0 takes this instead of the time
  haptics::ServoRate rate = {};
};

/// What one tick came to.
struct Tick {
  Pose X_WP = Pose::Identity();
  Vec3 force = Vec3::Zero();   ///< N, on the hand
  Vec3 torque = Vec3::Zero();  ///< N·m, likewise, about the tool's origin
  int contacts = 0;
  std::int64_t cpu_ns = 0;  ///< of the thread, the budget's own clock included
  haptics::Counts counts;   ///< what it did
  std::int64_t work = 0;    ///< units of work (core/budget.h); of ours only
  bool cut = false;         ///< the budget ended it
  bool lags = false;        ///< the tool has mass, and is behind in free space too
};

/// What ticks did on the mean.
struct MeanCounts {
  /// As haptics::Counts; NaN: not counted.
  double samples = 0.0, gradients = 0.0, pivots = 0.0, sub_steps = 0.0;
  double work = 0.0;  ///< 0 of rivals
  /// One of so many ticks.
  void add(const Tick& tick, std::size_t of) {
    const double share = 1.0 / double(of);
    samples += share * double(tick.counts.samples);
    gradients += share * double(tick.counts.gradients);
    pivots += share * double(tick.counts.pivots);
    sub_steps += share * double(tick.counts.sub_steps);
    work += share * double(tick.work);
  }
};

/// A proxy method at work in one scene, led by device poses. One thread.
class Method {
 public:
  virtual ~Method() = default;
  virtual const char* name() const = 0;
  virtual bool subSteps() const { return false; }  ///< whether a tick may take several motions
  /// Forgets everything and puts the proxy there, which must be legal.
  virtual void start(const Pose& X_WP) = 0;
  /// One tick, measured.
  Tick tick(const Pose& X_WD);

 protected:
  virtual void step(const Pose& X_WD, Tick& tick) = 0;
};

inline constexpr double kStiffness = 1000.0;  ///< N/m, of every method that is given no other

/// haptics::tick with this stiffness.
std::unique_ptr<Method> ours(std::shared_ptr<const haptics::Scene> scene, double isovalue,
                             Limit limit, double stiffness = kStiffness);
/// One reading of the paper's words (app/study/reference), with the same stiffness; its six steps
/// are made so many times in a tick.
std::unique_ptr<Method> rival(const Touched& scene, const haptics::PointShell& shell,
                              const reference::Choices& choices, int sub_steps = 1);
/// The penalty method (app/study/rivals).
std::unique_ptr<Method> penalty(const Touched& scene, const haptics::PointShell& shell,
                                const rivals::PenaltySettings& settings = {},
                                haptics::ServoRate rate = {}, double stiffness = kStiffness);
/// The static god object (app/study/rivals).
std::unique_ptr<Method> godObject(const Touched& scene, const haptics::PointShell& shell,
                                  const rivals::GodObjectSettings& settings = {},
                                  double stiffness = kStiffness);

/// literal, charitable, accept-inside, penalty, god object and ours, in this order, each as it is
/// best.
std::vector<std::unique_ptr<Method>> allMethods(const Touched& scene,
                                                std::shared_ptr<const haptics::Scene> built,
                                                Limit limit);

}  // namespace comparison
