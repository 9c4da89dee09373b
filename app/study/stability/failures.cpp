// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/failures.h"

#include <random>

namespace study {
namespace failures {

std::shared_ptr<const haptics::Scene> noisySphere(double noise, unsigned seed, haptics::Tool tool) {
  std::mt19937 engine{seed};
  std::normal_distribution<double> grain{0.0, noise > 0.0 ? 600.0 * noise : 1.0};
  return made::scene(datasets::sampledFloat(cube(48),
                                            [&](const Vec3& p) {
                                              return std::clamp(1e5 * (0.015 - p.norm()), -300.0,
                                                                300.0) +
                                                     (noise > 0.0 ? grain(engine) : 0.0);
                                            }),
                     std::move(tool));
}

std::shared_ptr<const haptics::Scene> sphere(haptics::Tool tool) {
  return made::scene(datasets::solid(cube(64), [](const Vec3& p) { return p.norm() - 0.02; }),
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

}  // namespace failures

std::vector<Job> failureJobs(Depth depth) {
  const int tries = depth == Depth::Full ? 10 : 1;
  std::vector<Job> jobs;
  for (auto group : {failures::surfaces, failures::insides, failures::motions, failures::shells})
    for (Job& job : group(tries)) jobs.push_back(std::move(job));
  return jobs;
}

}  // namespace study
