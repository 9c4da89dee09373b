// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/failures.h"

#include <map>

namespace study::stability {

Plot distancePlot(const std::string& title, const std::deque<Trial>& trials) {
  Plot plot{title + ": proxy from device",
            "How far the proxy is from the device over the time of a trial: mean, least and "
            "greatest of all trials, between one point and the next",
            {"time [s]"},
            {"from device [mm]", Scale::Log}};
  std::size_t ticks = 0;
  std::map<std::string, std::vector<const Trial*>> lines;
  for (const Trial& each : trials) {
    ticks = std::max(ticks, each.behind.size());
    lines[each.name].push_back(&each);
  }
  const std::size_t every = (ticks + 59) / 60;  // at most 60 points
  for (const auto& [name, of] : lines) {
    Series& series = plot.series.emplace_back(Series{name, {}});
    for (std::size_t first = 0; first < ticks; first += every) {
      double count = 0.0, sum = 0.0, least = INFINITY, greatest = 0.0;
      for (const Trial* trial : of)
        for (std::size_t n = first; n < std::min(first + every, trial->behind.size()); ++n) {
          const double behind = 1e3 * trial->behind[n];
          ++count;
          sum += behind;
          least = std::min(least, behind);
          greatest = std::max(greatest, behind);
        }
      if (count > 0.0)
        series.points.push_back({1e-3 * double(first), sum / count, least, greatest});
    }
  }
  return plot;
}

void Trials::tell() {
  // what a tick may spend beyond its allowance before it looks at the budget again
  constexpr double kMostWork = double(haptics::kTickWork + haptics::kTickWork / 5);
  int illegal = 0, non_finite = 0;
  std::int64_t most_work = 0;
  for (const Trial& each : trials) {
    illegal += each.illegal;
    non_finite += each.non_finite;
    most_work = std::max(most_work, each.most_work);
  }
  none("ticks inside", illegal);
  none("not finite", non_finite);
  atMost("most work in a tick", double(most_work), kMostWork, "units",
         "the budget, and a fifth that may come between two looks at it");
  outcome.plots.push_back(distancePlot(subject, trials));
  trials.clear();
}

std::vector<Job> failureJobs(Depth depth) {
  const int tries = depth == Depth::Full ? 10 : 1;
  std::vector<Job> jobs;
  for (const FailureGroup& group : {surfaces(), insides(), motions(), shells()})
    for (const Failure& each : group.failures)
      jobs.push_back({std::string{"failures/"} + each.job, group.section,
                      each.cost + each.cost_per_try * tries, [=](std::uint64_t seed) {
                        Trials found{{each.title}, tries, unsigned(seed)};
                        each.run(found);
                        found.subject = each.title;
                        if (!found.trials.empty()) found.tell();
                        return std::move(found.outcome);
                      }});
  return jobs;
}

}  // namespace study::stability
