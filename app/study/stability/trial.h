// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "haptics/servo/tick.h"

namespace study::stability {

/// Whether every shell point is outside at a pose, by somebody who shares no code with the field.
using PoseCheck = bool (*)(const haptics::Volume&, double isovalue,
                           const std::vector<haptics::Vec3>&, const haptics::Pose&);
/// The check of the study: the paper's solid in `reference`, with F = s inside.
bool isOutside(const haptics::Volume& volume, double isovalue,
               const std::vector<haptics::Vec3>& points, const haptics::Pose& X_WP);

/// A proxy in a scene, moved tick by tick by whoever holds the device; every pose it takes is
/// judged. All work is counted, so that every run is the same.
struct Trial {
  Trial(std::shared_ptr<const haptics::Scene> in, double s, const haptics::Pose& X_start,
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

  const haptics::TickResult& step(const haptics::Pose& X_WD) {
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
    return judge(*scene->volume, isovalue, scene->tool.shell.points, proxy.X_WP);
  }
  haptics::Vec3 place() const { return proxy.X_WP.translation(); }
  /// The point of the tool that lies least far along n [m].
  double lowest(const haptics::Vec3& n) const {
    double least = INFINITY;
    for (const haptics::Vec3& p : scene->tool.shell.points)
      least = std::min(least, n.dot(proxy.X_WP * p));
    return least;
  }
};

}  // namespace study::stability
