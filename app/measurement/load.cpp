// SPDX-License-Identifier: BSD-3-Clause
#include "app/measurement/load.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/measurement/quantile.h"
#include "haptics/proxy/proxy.h"
#include "haptics/proxy/tick.h"
#include "haptics/solver/unconstrained_motion.h"

namespace measurement {
namespace {

using haptics::Budget;

constexpr std::size_t kAskEvery = 20, kSampleEvery = 50;  // ticks
constexpr std::int64_t kAmple = 50;                       // budgets: enough to arrive

double distance(const haptics::Scene& scene, const haptics::Proxy& proxy,
                const haptics::Pose& X_WD) {
  haptics::Vec3 turn = proxy.turn;
  const haptics::Twist left = haptics::unconstrainedMotion(proxy.X_WP, X_WD, turn);
  return scene.metric.whitened(left, proxy.X_WP.linear()).norm();
}

}  // namespace

std::optional<Load> loadOf(const haptics::Scene& scene, double isovalue,
                           const haptics::VirtualCoupling& coupling, const std::vector<Path>& paths,
                           const Allowance& allowance, const std::function<bool()>& goOn) {
  const auto budget = [&](std::int64_t times) {
    return allowance.work > 0 ? Budget::counted(times * allowance.work)
                              : Budget::timed(times * allowance.nanoseconds);
  };
  const double period = allowance.rate.period();
  Load load;
  std::vector<double> times;  // s
  double lag = 0.0, samples = 0.0;
  for (const Path& path : paths) {
    haptics::Proxy proxy{scene, path.poses.front()};
    bool sampled = false;  // just before
    for (std::size_t n = 0; n < path.poses.size(); ++n) {
      if (n % kAskEvery == 0 && !goOn()) return {};
      const haptics::Pose& X_WD = path.poses[n];
      const std::int64_t begun = Budget::threadTime();
      Budget hurried = budget(1);
      const bool cut = haptics::tick(scene, isovalue, coupling, X_WD, proxy, hurried, period).cut;
      const std::int64_t ended = Budget::threadTime();
      // a copy of the proxy has driven the scene out of the caches, which is not the tick's fault
      const bool counts = n >= path.lead_in && !std::exchange(sampled, false);
      if (!counts) continue;
      times.push_back(1e-9 * double(ended - begun));
      load.cut += cut;
      if (n % kSampleEvery != 0) continue;
      ++samples;
      if (!cut) continue;
      sampled = true;
      haptics::Proxy unhurried = proxy;
      Budget ample = budget(kAmple);
      haptics::tick(scene, isovalue, coupling, X_WD, unhurried, ample, period);
      // where that is not enough to tell, all of the distance may be lag
      const double least = ample.cut() ? 0.0 : distance(scene, unhurried, X_WD);
      lag += std::max(0.0, distance(scene, proxy, X_WD) - least);
    }
  }
  load.points = static_cast<int>(scene.tool.shell.points.size());
  load.ticks = std::ssize(times);
  load.missed = std::count_if(times.begin(), times.end(),
                              [&](double time) { return time > allowance.period; });
  std::sort(times.begin(), times.end());
  load.median = quantile(times, 0.5);
  load.p99 = quantile(times, 0.99);
  load.longest = times.back();
  load.lag = lag / std::max(1.0, samples);
  load.carried = double(load.missed) <= kMostMissed * double(load.ticks) &&
                 load.lag <= kMostLag * scene.lengths.voxel;
  return load;
}

}  // namespace measurement
