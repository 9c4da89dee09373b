// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/failures.h"

#include "app/study/reference/solid.h"
#include "app/study/stability/stability.h"

namespace study::stability {
namespace {

/// What a tick may spend beyond its allowance before it looks at the budget again.
constexpr double kMostWork = double(haptics::kTickWork + haptics::kTickWork / 5);

}  // namespace

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

void DeviceDistances::Tick::add(const Tick& other) {
  trials += other.trials;
  sum += other.sum;
  least = std::min(least, other.least);
  greatest = std::max(greatest, other.greatest);
}

void DeviceDistances::add(const Trial& trial) {
  if (ticks_.size() < trial.behind.size()) ticks_.resize(trial.behind.size());
  for (std::size_t n = 0; n < trial.behind.size(); ++n) {
    const double behind = trial.behind[n];
    ticks_[n].add({1, behind, behind, behind});
  }
}

Plot DeviceDistances::plot(const std::string& name) const {
  constexpr std::size_t kPoints = 60;
  const std::size_t every = std::max<std::size_t>(1, (ticks_.size() + kPoints - 1) / kPoints);
  Series series{"all trials", {}};
  for (std::size_t first = 0; first < ticks_.size(); first += every) {
    Tick all;
    for (std::size_t n = first; n < std::min(first + every, ticks_.size()); ++n) all.add(ticks_[n]);
    series.points.push_back(
        {1e-3 * double(first), 1e3 * all.sum / all.trials, 1e3 * all.least, 1e3 * all.greatest});
  }
  return {name + ": proxy from device",
          "How far the proxy is from the device over the time of a trial: mean, least and greatest "
          "of all trials, between one point and the next",
          {"time [s]"},
          {"from device [mm]", Scale::Log},
          {series}};
}

void Trials::add(const Trial& trial) {
  ++sum_.trials;
  sum_.illegal += trial.illegal;
  sum_.non_finite += trial.non_finite;
  sum_.most_work = std::max(sum_.most_work, trial.most_work);
  sum_.distances.add(trial);
}

void Trials::tellContact(const std::string& name, const Trial& trial) {
  subject = name;
  atLeast("ticks in contact", trial.contact, 1.0);
  add(trial);
  tellSum();
}

Plot& Trials::plot(const char* heading, const char* description, const char* y,
                   std::vector<Series> lines) {
  return plots.emplace_back(Plot{heading, description, {"time [s]"}, {y}, std::move(lines)});
}

void Trials::tellSum() {
  none("ticks inside", sum_.illegal);
  none("not finite", sum_.non_finite);
  atMost("most work in a tick", double(sum_.most_work), kMostWork, "units",
         "the budget, and a fifth that may come between two looks at it");
  outcome.plots.push_back(sum_.distances.plot(subject));
  sum_ = {};
}

Outcome Trials::told() {
  subject = title;
  if (sum_.trials > 0) tellSum();
  outcome.plots.insert(outcome.plots.end(), plots.begin(), plots.end());
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
