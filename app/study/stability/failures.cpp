// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/failures.h"

#include "app/study/reference/solid.h"

namespace study::stability {
bool isOutside(const haptics::Volume& volume, double isovalue, const std::vector<Vec3>& points,
               const Pose& X_WP) {
  const reference::Solid solid{volume, isovalue,
                               reference::choicesFor(volume.grid, reference::Variant::Literal)};
  return std::none_of(points.begin(), points.end(),
                      [&](const Vec3& p) { return solid.inside(X_WP * p); });
}

std::shared_ptr<const haptics::Scene> sphere(haptics::Tool tool, double radius, double reach,
                                             std::int64_t n) {
  return sceneOf(datasets::solid(
                     cube(n), [=](const Vec3& p) { return p.norm() - radius; }, reach),
                 std::move(tool));
}

std::shared_ptr<const haptics::Scene> noisySphere(double noise, unsigned seed, haptics::Tool tool) {
  return sceneOf(ramp(noise, seed, [](const Vec3& p) { return p.norm() - 0.015; }),
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

Plot distancePlot(const std::string& name, const std::vector<std::vector<float>>& trials) {
  constexpr std::size_t kPoints = 60;
  std::size_t ticks = 0;
  for (const auto& trial : trials) ticks = std::max(ticks, trial.size());
  const std::size_t every = std::max<std::size_t>(1, (ticks + kPoints - 1) / kPoints);
  Series series{"all trials", {}};
  for (std::size_t first = 0; first < ticks; first += every) {
    int count = 0;
    double sum = 0.0, least = INFINITY, greatest = 0.0;
    for (std::size_t n = first; n < std::min(first + every, ticks); ++n) {
      double of_tick = 0.0;
      for (const auto& trial : trials) {
        if (n >= trial.size()) continue;
        const double behind = trial[n];
        ++count;
        of_tick += behind;
        least = std::min(least, behind);
        greatest = std::max(greatest, behind);
      }
      sum += of_tick;
    }
    series.points.push_back({1e-3 * double(first), 1e3 * sum / count, 1e3 * least, 1e3 * greatest});
  }
  return {name + ": proxy from device",
          "How far the proxy is from the device over the time of a trial: mean, least and greatest "
          "of all trials, between one point and the next",
          {"time [s]"},
          {"from device [mm]", Scale::Log},
          {series}};
}

Trial& Trials::brought(std::shared_ptr<const haptics::Scene> scene, double isovalue,
                       const Pose& from, const Pose& to, int ticks, int held) {
  Trial& made = trial(std::move(scene), isovalue, from);
  made.carry(from, to, ticks);
  made.hold(to, held);
  return made;
}

void Trials::tellContact(const std::string& name) {
  subject = name;
  atLeast("ticks in contact", trials_.back().contact, 1.0);
  tellTrials();
}

void Trials::tellTrials() {
  // what a tick may spend beyond its allowance before it looks at the budget again
  constexpr double kMostWork = double(haptics::kTickWork + haptics::kTickWork / 5);
  int illegal = 0, non_finite = 0;
  std::int64_t most_work = 0;
  std::vector<std::vector<float>> distances;
  for (const Trial& each : trials_) {
    illegal += each.illegal;
    non_finite += each.non_finite;
    most_work = std::max(most_work, each.most_work);
    distances.push_back(each.behind);
  }
  none("ticks inside", illegal);
  none("not finite", non_finite);
  atMost("most work in a tick", double(most_work), kMostWork, "units",
         "the budget, and a fifth that may come between two looks at it");
  outcome.plots.insert(outcome.plots.begin() + told_++, distancePlot(subject, distances));
  trials_.clear();
}

Outcome Trials::told() {
  subject = title;
  if (!trials_.empty()) tellTrials();
  return std::move(outcome);
}

std::vector<Job> failureJobs(Depth depth) {
  const int tries = depth == Depth::Full ? 10 : 1;
  std::vector<Job> jobs;
  for (const FailureGroup& group : {surfaces(), insides(), motions(), shells()})
    for (const Failure& each : group.failures)
      jobs.push_back({std::string{"failures/"} + each.job, group.section,
                      each.cost + each.cost_per_try * tries, [=](std::uint64_t seed) {
                        Trials found{each.title, tries, seed};
                        each.run(found);
                        return found.told();
                      }});
  return jobs;
}

}  // namespace study::stability
