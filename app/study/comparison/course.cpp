// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/course.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "app/study/comparison/slack.h"
#include "app/study/reference/run.h"

namespace comparison {
namespace {

using haptics::HandMotion;

constexpr double kReach = 0.008;  // m that the hands go beyond the surface
constexpr double kLeadIn = 0.5;   // s
constexpr double kApart = 1e-6;   // m

constexpr std::pair<const char*, HandMotion> kHands[] = {
    {"tap", HandMotion::Tap}, {"slide", HandMotion::Slide}, {"wedge", HandMotion::Wedge},
    {"pry", HandMotion::Pry}, {"hook", HandMotion::Hook},   {"jerk", HandMotion::Jerk}};

}  // namespace

// where its lead-in ends a hand touches first
Pose movedTo(const Pose& X_place, const haptics::Hand& hand) {
  return X_place * hand.at(kLeadIn).inverse();
}

haptics::Expected<std::vector<Course>> coursesIn(const haptics::Scene& scene,
                                                 const Touched& touched, double seconds,
                                                 haptics::ServoRate rate, unsigned seed,
                                                 unsigned hands) {
  std::vector<Course> courses;
  const auto ticks = static_cast<int>(std::lround((kLeadIn + seconds) / rate.period()));
  for (unsigned n = 0; n < hands; ++n)
    for (const auto& [name, motion] : kHands) {
      const auto hand = haptics::Hand::aimed(motion, scene, touched.isovalue, kReach, seed + n);
      if (!hand) return tl::unexpected(hand.error());
      Course course{name, {}, motion == HandMotion::Jerk, rate, seed + n};
      const Pose X_to = touched.place ? movedTo(touched.place(seed + n), *hand) : Pose::Identity();
      for (int tick = 0; tick < ticks; ++tick)
        course.device.push_back(X_to * hand->at(rate.period() * tick));
      courses.push_back(std::move(course));
    }
  return courses;
}

std::vector<Track> follow(std::vector<std::unique_ptr<Method>>& methods,
                          const std::vector<Course>& courses) {
  std::vector<Track> tracks;
  for (const auto& method : methods) tracks.push_back({method->name(), method->subSteps(), {}});
  for (const Course& course : courses) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      methods[m]->start(course.device.front());
      tracks[m].ticks.emplace_back();
      tracks[m].ticks.back().reserve(course.device.size());
    }
    for (std::size_t n = 0; n < course.device.size(); ++n)
      for (std::size_t turn = 0; turn < methods.size(); ++turn) {
        const std::size_t m = (n + turn) % methods.size();
        tracks[m].ticks.back().push_back(methods[m]->tick(course.device[n]));
      }
  }
  return tracks;
}

std::optional<double> coupledBy(const Tick& tick, const Pose& X_WD,
                                const haptics::PointShell& shell) {
  const double apart = massDistance(tick.X_WP, X_WD, shell);
  if (tick.contacts > 0 || (apart > kApart && !tick.lags)) return apart;
  return {};
}

std::vector<double> Summary::sorted(std::vector<double> Part::*values) const {
  std::vector<double> all;
  for (const Part& part : parts)
    all.insert(all.end(), (part.*values).begin(), (part.*values).end());
  std::ranges::sort(all);
  return all;
}

namespace {

/// So many of some things, evenly spread, from a start that the seed tells.
template <class T>
std::vector<T> spread(const std::vector<T>& all, std::size_t count, std::uint32_t seed) {
  if (all.size() <= count) return all;
  std::mt19937 random{seed};
  const double start = std::uniform_real_distribution<double>{}(random);
  std::vector<T> some;
  for (std::size_t k = 0; k < count; ++k)
    some.push_back(
        all[static_cast<std::size_t>((double(k) + start) / double(count) * double(all.size()))]);
  return some;
}

}  // namespace

Summary summaryOf(const Track& track, const std::vector<Course>& courses,
                  const haptics::PointShell& shell, const Judge& judge, std::size_t every,
                  double rest_gap, const SlackPlan& plan) {
  Summary summary;
  summary.method = track.method;
  std::vector<double> times, work, coupling, guided;
  double cut = 0.0, contact_ms = 0.0, frozen_ms = 0.0, stuck_ms = 0.0;
  std::size_t ticks_in_all = 0;
  for (const Course& course : courses) ticks_in_all += course.device.size();
  for (std::size_t c = 0; c < courses.size(); ++c) {
    const Course& course = courses[c];
    // a proxy that rests between two poses a quarter of a millisecond apart is not frozen yet
    const auto millisecond = static_cast<std::size_t>(course.rate.hz / 1000);
    const bool is_guided = course.hand == "tap" || course.hand == "slide" || course.hand == "hook";
    const std::size_t coupled_before = coupling.size();
    Part part{.hand = course.hand, .seed = course.seed};
    double part_us = 0.0, part_cut = 0.0;
    std::vector<std::size_t> in_contact, frozen;  // ticks
    for (std::size_t n = 0; n < course.device.size(); ++n) {
      const Tick& tick = track.ticks[c][n];
      const double us = 1e-3 * double(tick.cpu_ns);
      times.push_back(us);
      work.push_back(double(tick.work));
      part_us += us;
      summary.counts.add(tick, ticks_in_all);
      part_cut += tick.cut;
      summary.contacts_max = std::max(summary.contacts_max, tick.contacts);

      if (!course.jerk) {
        const auto apart = coupledBy(tick, course.device[n], shell);
        if (n % millisecond == 0 && apart) {
          in_contact.push_back(n);
          if (n > 0 && reference::isFrozen(track.ticks[c][n - millisecond].X_WP, tick.X_WP,
                                           course.device[n - millisecond], course.device[n], shell))
            frozen.push_back(n);
        }
        if (apart) {
          coupling.push_back(1e3 * *apart);
          if (is_guided) guided.push_back(coupling.back());
        }
      }
      if (n % (course.jerk ? (every + 4) / 5 : every) == 0) {
        const double depth_mm = 1e3 * judge.depth(tick.X_WP);
        summary.penetration_mm = std::max(summary.penetration_mm, depth_mm);
        if (!course.jerk && coupledBy(tick, course.device[n], shell))
          part.depths_mm.push_back(depth_mm);
      }
      if (n > 0 && (n % 2 == 0 || course.jerk))
        summary.wall_passages +=
            judge.passages(track.ticks[c][n - 1].X_WP, tick.X_WP, track.sub_steps);
    }
    const double ticks = double(course.device.size());
    part.mean_us = part_us / ticks;
    part.cut = part_cut / ticks;
    cut += part_cut;
    if (!course.jerk) {
      const std::span<const double> own = std::span{coupling}.subspan(coupled_before);
      part.coupling_mm = mean(own);
      part.frozen = in_contact.empty() ? 0.0 : double(frozen.size()) / double(in_contact.size());
      part.contact = double(own.size()) / ticks;
      const auto seed = plan.seed + static_cast<std::uint32_t>(c);
      const auto measured = [&](std::size_t n, std::vector<double>& slacks) {
        const auto slack =
            localSlack(track.ticks[c][n].X_WP, course.device[n], shell, judge, plan.trials, seed);
        if (slack) slacks.push_back(1e3 * *slack);
      };
      for (const std::size_t n : spread(in_contact, plan.contact_ticks, seed))
        measured(n, part.slack_mm);
      for (const std::size_t n : spread(frozen, plan.frozen_ticks, seed))
        measured(n, part.frozen_slack_mm);
      const auto& slacks = part.frozen_slack_mm;
      const auto stuck =
          std::ranges::count_if(slacks, [&](double mm) { return mm > 1e3 * rest_gap; });
      if (!slacks.empty()) part.truly_stuck = part.frozen * double(stuck) / double(slacks.size());
      contact_ms += double(in_contact.size());
      frozen_ms += double(frozen.size());
      stuck_ms += part.truly_stuck * double(in_contact.size());
    }
    summary.parts.push_back(std::move(part));
  }
  summary.ticks = times.size();
  summary.mean_us = mean(times);
  std::sort(times.begin(), times.end());
  summary.p50_us = quantile(times, 0.5);
  summary.p99_us = quantile(times, 0.99);
  summary.p999_us = quantile(times, 0.999);
  summary.max_us = quantile(times, 1.0);
  std::sort(work.begin(), work.end());
  summary.p999_work = quantile(work, 0.999);
  summary.coupling_mm = mean(coupling);
  summary.guided_mm = mean(guided);
  if (contact_ms > 0.0) {
    summary.frozen = frozen_ms / contact_ms;
    summary.truly_stuck = stuck_ms / contact_ms;
  }
  summary.cut = cut / double(times.size());
  return summary;
}

}  // namespace comparison
