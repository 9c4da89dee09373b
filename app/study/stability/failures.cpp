// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/failures.h"

#include <random>

namespace study::stability {
std::shared_ptr<const haptics::Scene> noisySphere(double noise, unsigned seed, haptics::Tool tool) {
  std::mt19937 engine{seed};
  std::normal_distribution<double> grain{0.0, noise > 0.0 ? 600.0 * noise : 1.0};
  return sceneOf(datasets::sampledFloat(cube(48),
                                        [&](const Vec3& p) {
                                          return std::clamp(1e5 * (0.015 - p.norm()), -300.0,
                                                            300.0) +
                                                 (noise > 0.0 ? grain(engine) : 0.0);
                                        }),
                 std::move(tool));
}

std::shared_ptr<const haptics::Scene> sphere(haptics::Tool tool) {
  return sceneOf(datasets::solid(cube(64), [](const Vec3& p) { return p.norm() - 0.02; }),
                 std::move(tool));
}

void drag(Trial& trial, const Vec3& middle, double reach, unsigned seed, int moves) {
  Random random{seed};
  Pose from = trial.proxy.X_WP;
  for (int n = 0; n < moves; ++n) {
    const Pose to = at(middle + random.box(reach), random.rotation());
    trial.carry(from, to, 40);
    from = to;
  }
}

void DeviceDistances::add(const Trial& trial) {
  if (ticks_.size() < trial.behind.size()) ticks_.resize(trial.behind.size());
  for (std::size_t n = 0; n < trial.behind.size(); ++n) {
    Tick& tick = ticks_[n];
    ++tick.trials;
    tick.sum += double(trial.behind[n]);
    tick.least = std::min(tick.least, double(trial.behind[n]));
    tick.greatest = std::max(tick.greatest, double(trial.behind[n]));
  }
}

Plot DeviceDistances::plot(const std::string& name) const {
  constexpr std::size_t kPoints = 60;
  const std::size_t every = std::max<std::size_t>(1, (ticks_.size() + kPoints - 1) / kPoints);
  Series series{"all trials", {}};
  for (std::size_t first = 0; first < ticks_.size(); first += every) {
    Tick all;
    for (std::size_t n = first; n < std::min(first + every, ticks_.size()); ++n) {
      all.trials += ticks_[n].trials;
      all.sum += ticks_[n].sum;
      all.least = std::min(all.least, ticks_[n].least);
      all.greatest = std::max(all.greatest, ticks_[n].greatest);
    }
    series.points.push_back(
        {1e-3 * double(first), 1e3 * all.sum / all.trials, 1e3 * all.least, 1e3 * all.greatest});
  }
  Plot plot = overTime(name + ": proxy from device",
                       "How far the proxy is from the device over the time of a trial: mean, least "
                       "and greatest of all trials, between one point and the next",
                       "from device [mm]");
  plot.y.scale = Scale::Log;
  plot.series.push_back(std::move(series));
  return plot;
}

std::vector<Job> failureJobs(Depth depth) {
  const int tries = depth == Depth::Full ? 10 : 1;
  std::vector<Job> jobs;
  for (auto group : {surfaces, insides, motions, shells})
    for (Job& job : group(tries)) jobs.push_back(std::move(job));
  return jobs;
}

}  // namespace study::stability
