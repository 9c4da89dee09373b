// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/scene/scene.h"
#include "haptics/simulation/hand.h"

namespace study::plan {

/// What is done to a scene: a hand holds the tool, at 1 kHz.
struct Course {
  std::string name;  ///< "gyroid and drill, wedge"
  std::shared_ptr<const haptics::Scene> scene;
  double isovalue = 0.0;
  haptics::VirtualCoupling coupling;
  haptics::Hand hand;
  int ticks = 0;
  double begin = 0.0;   ///< s of the hand's time
  bool touches = true;  ///< the hand is meant to meet the surface
};

/// Two scenes on one course, tick by tick in turn, each with a proxy and a grip of its own.
struct Comparison {
  // the largest differences in any tick
  double pose = 0.0;    ///< m, of the tool's farthest point
  double force = 0.0;   ///< N
  double torque = 0.0;  ///< N·m
  int ticks = 0, contact_ticks = 0;
  // of each run: mean of a tick
  std::vector<double> first_us, second_us;     ///< thread CPU time
  double first_work = 0.0, second_work = 0.0;  ///< units of core/budget.h
};

/// A burr at the tip of the tool: there is none, or it could cut, or it turns.
enum class Burr { None, Ready, Held };

/// Runs them `runs` times, the second with a burr. No budget cuts a tick. A start without a legal
/// pose leaves `ticks` at 0.
Comparison compared(const Course& course, const haptics::Scene& first, const haptics::Scene& second,
                    int runs, Burr burr = Burr::None);

/// The units of work of a course in its own scene; none if the start has no legal pose. `begin` is
/// called before the first tick.
std::optional<std::int64_t> workOf(const Course& course, Burr burr,
                                   const std::function<void()>& begin);

/// The scene with one of its omissions switched off, or with all of them.
std::shared_ptr<const haptics::Scene> without(const haptics::Scene& scene,
                                              bool haptics::Plan::*omission);
std::shared_ptr<const haptics::Scene> withEverything(const haptics::Scene& scene);

/// Every omission of the course's scene, off against on.
Outcome examined(const Course& course, int runs);

/// The course's scene by itself against the same with a burr that is not held, in pose, force,
/// torque and work.
Outcome uncut(const Course& course, int runs, Burr burr = Burr::Ready);

}  // namespace study::plan
