// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/study/made/made.h"
#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/phantoms.h"
#include "haptics/servo/tick.h"
#include "resources/named_tools.h"

/// A proxy in a scene, moved tick by tick by whoever holds the device; every pose it takes is
/// judged by the evaluator, which knows nothing of the field's code.
struct Trial {
  Trial(std::shared_ptr<const haptics::Scene> in, double s, const haptics::Pose& X_start)
      : scene{std::move(in)}, isovalue{s}, proxy{*scene, X_start} {}

  std::shared_ptr<const haptics::Scene> scene;
  double isovalue;
  haptics::VirtualCoupling coupling{1000.0, 0.0};
  haptics::Proxy proxy;
  haptics::TickResult last = {};
  int illegal = 0;  ///< ticks with a shell point inside
  int contact = 0;  ///< ticks in contact
  bool judged = true;
  std::int64_t allowance = haptics::kTickWork;  ///< units of work a tick may spend
  std::int64_t most_work = 0;                   ///< spent in any tick

  const haptics::TickResult& step(const haptics::Pose& X_WD) {
    haptics::Budget budget = haptics::Budget::counted(allowance);
    last = haptics::tick(*scene, isovalue, coupling, X_WD, proxy, budget);
    most_work = std::max(most_work, budget.spent());
    contact += last.contacts > 0;
    if (judged) illegal += !isLegal();
    return last;
  }
  /// Moves the device there along a line in `ticks` ticks, from where `from` says.
  void carry(const haptics::Pose& from, const haptics::Pose& to, int ticks) {
    for (int n = 1; n <= ticks; ++n) {
      const double share = double(n) / ticks;
      step(haptics::poseOf(from.translation() + share * (to.translation() - from.translation()),
                           haptics::Quat{from.linear()}.slerp(share, haptics::Quat{to.linear()})));
    }
  }
  void hold(const haptics::Pose& X_WD, int ticks = 200) {
    for (int n = 0; n < ticks; ++n) step(X_WD);
  }
  /// Holds the device until the proxy has arrived there to the bit; the ticks it took, or `most`.
  int ticksToReach(const haptics::Pose& X_WD, int most) {
    for (int n = 1; n <= most; ++n) {
      step(X_WD);
      if (proxy.X_WP.matrix() == X_WD.matrix()) return n;
    }
    return most;
  }
  bool isLegal() const {
    return evaluator::isLegal(*scene->volume, isovalue, scene->tool.shell.points, proxy.X_WP);
  }
  double penetration_mm() const {
    return evaluator::penetration_mm(*scene->volume, isovalue, scene->tool.shell.points,
                                     proxy.X_WP);
  }
  const haptics::Vec3 place() const { return proxy.X_WP.translation(); }
};

/// A phantom as a scene, with the named tool or the made one.
struct Stage {
  std::shared_ptr<const haptics::Scene> scene;
  double isovalue = 0.0;
};
inline haptics::Tool namedTool(const std::string& name) {
  return haptics::makeTool(name, resources::namedToolMesh(name).value()).value();
}
inline Stage stageOf(const std::string& phantom, haptics::Tool tool) {
  datasets::Phantom made = datasets::makePhantom(phantom).value();
  return {haptics::makeScene(made::shared(std::move(made.volume)), std::move(tool)).value(),
          made.isovalue};
}
inline haptics::Tool ballTool(int count, double radius) {
  return made::tool(made::ballPoints(count, radius));
}
