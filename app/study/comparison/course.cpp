// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/course.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
                                                 haptics::ServoRate rate, unsigned seed) {
  std::vector<Course> courses;
  for (const auto& [name, motion] : kHands) {
    const auto hand = haptics::Hand::aimed(motion, scene, touched.isovalue, kReach, seed);
    if (!hand) return tl::unexpected(hand.error());
    Course course{name, {}, motion == HandMotion::Jerk, rate};
    const auto ticks = static_cast<int>(std::lround((kLeadIn + seconds) / rate.period()));
    const Pose X_to = touched.place ? movedTo(*touched.place, *hand) : Pose::Identity();
    for (int n = 0; n < ticks; ++n) course.device.push_back(X_to * hand->at(rate.period() * n));
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

Summary summaryOf(const Track& track, const std::vector<Course>& courses,
                  const haptics::PointShell& shell, const Judge& judge, std::size_t every) {
  Summary summary;
  summary.method = track.method;
  std::vector<double> times, work, coupling, guided;
  std::vector<reference::Record> records;
  std::vector<Pose> led;
  double cut = 0.0;
  std::size_t ticks_in_all = 0;
  for (const Course& course : courses) ticks_in_all += course.device.size();
  for (std::size_t c = 0; c < courses.size(); ++c) {
    const Course& course = courses[c];
    // a proxy that rests between two poses a quarter of a millisecond apart is not frozen yet
    const auto millisecond = static_cast<std::size_t>(course.rate.hz / 1000);
    const bool is_guided = course.hand == "tap" || course.hand == "slide" || course.hand == "hook";
    const std::size_t rows_before = records.size(), coupled_before = coupling.size();
    double part_us = 0.0, part_cut = 0.0;
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
        if (n % millisecond == 0) {
          reference::Record record;
          record.X_WP = tick.X_WP;
          record.contacts = apart.has_value();
          records.push_back(record);
          led.push_back(course.device[n]);
        }
        if (apart) {
          coupling.push_back(1e3 * *apart);
          if (is_guided) guided.push_back(coupling.back());
        }
      }
      if (n % (course.jerk ? (every + 4) / 5 : every) == 0)
        summary.penetration_mm = std::max(summary.penetration_mm, 1e3 * judge.depth(tick.X_WP));
      if (n > 0 && (n % 2 == 0 || course.jerk))
        summary.wall_passages +=
            judge.passages(track.ticks[c][n - 1].X_WP, tick.X_WP, track.sub_steps);
    }
    const double ticks = double(course.device.size());
    Part part{.hand = course.hand, .mean_us = part_us / ticks, .cut = part_cut / ticks};
    cut += part_cut;
    if (!course.jerk) {
      const std::span<const double> own = std::span{coupling}.subspan(coupled_before);
      part.coupling_mm = mean(own);
      part.frozen = reference::frozenShare(std::span{records}.subspan(rows_before),
                                           std::span{led}.subspan(rows_before), shell);
      part.contact = double(own.size()) / ticks;
    }
    summary.parts.push_back(part);
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
  summary.frozen = reference::frozenShare(records, led, shell);
  summary.cut = cut / double(times.size());
  return summary;
}

}  // namespace comparison
