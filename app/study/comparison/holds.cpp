// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/holds.h"

#include <algorithm>
#include <cmath>

#include "app/study/comparison/slack.h"

namespace comparison {
namespace {

constexpr int kMove = 30;  // ticks

/// Where a method is after some of the ticks of a hold.
struct Ending {
  double at_8 = 0.0, at_64 = 0.0;  // m to the device
  double rest = 0.0;               // m
  Pose X_end;
};

Ending held(Method& method, const Hold& hold, const haptics::PointShell& shell, int ticks) {
  Ending out;
  method.start(hold.X_start);
  for (int n = 1; n <= kMove; ++n) method.tick(between(hold.X_start, hold.X_WD, double(n) / kMove));
  const int still = std::max(ticks - 60, std::min(200, ticks / 2));
  Pose X_still;
  for (int n = 1; n <= ticks; ++n) {
    const Tick tick = method.tick(hold.X_WD);
    if (n == 8) out.at_8 = massDistance(tick.X_WP, hold.X_WD, shell);
    if (n == std::min(64, ticks)) out.at_64 = massDistance(tick.X_WP, hold.X_WD, shell);
    if (n == still) X_still = tick.X_WP;
    if (n > still) out.rest = std::max(out.rest, wayBetween(X_still, tick.X_WP, shell));
    out.X_end = tick.X_WP;
  }
  return out;
}

}  // namespace

std::vector<Hold> holdsAlong(const Track& ours, const std::vector<Course>& courses, int count) {
  std::vector<Hold> all;
  for (std::size_t c = 0; c < courses.size(); ++c) {
    if (courses[c].jerk) continue;
    for (std::size_t n = 0; n < courses[c].device.size(); ++n)
      if (ours.ticks[c][n].contacts > 0)
        all.push_back({ours.ticks[c][n].X_WP, courses[c].device[n]});
  }
  std::vector<Hold> chosen;
  Nudge nudge{11};
  for (int n = 0; n < count && !all.empty(); ++n) {
    Hold hold =
        all[all.size() * static_cast<std::size_t>(2 * n + 1) / static_cast<std::size_t>(2 * count)];
    hold.X_WD = nudge(hold.X_WD, 0.0015, 0.05);
    chosen.push_back(hold);
  }
  return chosen;
}

std::vector<HoldSummary> compareHolds(std::vector<std::unique_ptr<Method>>& methods,
                                      Method& unhurried, const std::vector<Hold>& holds,
                                      const haptics::PointShell& shell, const Judge& judge,
                                      const HoldPlan& plan) {
  struct Values {
    std::vector<double> at_8, same_start, at_64, rest, slack;
  };
  std::vector<Values> values(methods.size());
  Nudge nudge{13};
  for (const Hold& hold : holds) {
    // the least distance, by many ways
    double least = INFINITY, straight = INFINITY;
    for (int way = 0; way <= plan.detours; ++way) {
      unhurried.start(hold.X_start);
      const Pose X_by = way == 0 ? hold.X_WD : nudge(hold.X_WD, 0.002, 0.10);
      for (int n = 1; n <= kMove; ++n)
        unhurried.tick(between(hold.X_start, X_by, double(n) / kMove));
      for (int n = 1; n <= kMove; ++n) unhurried.tick(between(X_by, hold.X_WD, double(n) / kMove));
      Tick last;
      for (int n = 0; n < 64; ++n) last = unhurried.tick(hold.X_WD);
      const double distance = massDistance(last.X_WP, hold.X_WD, shell);
      if (way == 0) straight = distance;
      least = std::min(least, distance);
    }
    std::vector<Ending> ends;
    for (const auto& method : methods) {
      ends.push_back(held(*method, hold, shell, plan.ticks));
      if (judge.legal(ends.back().X_end))
        least = std::min(least, massDistance(ends.back().X_end, hold.X_WD, shell));
    }
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const Ending& end = ends[m];
      values[m].at_8.push_back(1e3 * (end.at_8 - least));
      values[m].same_start.push_back(1e3 * (end.at_8 - std::min(straight, end.at_64)));
      values[m].at_64.push_back(1e3 * (end.at_64 - least));
      values[m].rest.push_back(1e3 * end.rest);
      if (plan.slack_trials == 0) continue;
      if (const auto slack = localSlack(end.X_end, hold.X_WD, shell, judge, plan.slack_trials, 7))
        values[m].slack.push_back(1e3 * *slack);
    }
  }
  std::vector<HoldSummary> summaries;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    Values& v = values[m];
    std::sort(v.rest.begin(), v.rest.end());
    summaries.push_back({methods[m]->name(), median(v.at_8), mean(v.at_8), median(v.same_start),
                         mean(v.same_start), median(v.at_64), mean(v.at_64), quantile(v.rest, 0.99),
                         quantile(v.rest, 1.0), mean(v.slack), static_cast<int>(holds.size()),
                         static_cast<int>(v.slack.size()), v.at_8});
  }
  return summaries;
}

}  // namespace comparison
