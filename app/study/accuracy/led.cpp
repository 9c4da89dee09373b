// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/led.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/study/comparison/measures.h"

namespace study::accuracy {

std::size_t Led::indexOf(const std::string& method, const std::string& setting) const {
  const auto found = std::ranges::find_if(field.names, [&](const Contenders::Name& name) {
    return name.method == method && name.setting == setting;
  });
  return static_cast<std::size_t>(found - field.names.begin());
}

Led led(Contenders field, const std::vector<comparison::Course>& courses,
        const haptics::PointShell& shell) {
  Led led{std::move(field), {}, {}, {}, {}};
  led.tick_us.resize(led.field.methods.size());
  led.free_us.resize(led.field.methods.size());
  led.run_us.resize(led.field.methods.size());
  led.tracks = comparison::follow(led.field.methods, courses);
  for (std::size_t m = 0; m < led.tracks.size(); ++m) {
    std::map<unsigned, std::vector<double>> times;  // of each hand
    for (std::size_t c = 0; c < courses.size(); ++c)
      for (std::size_t n = 0; n < courses[c].device.size() && !courses[c].jerk; ++n) {
        const comparison::Tick& tick = led.tracks[m].ticks[c][n];
        const bool contact = comparison::coupledBy(tick, courses[c].device[n], shell).has_value();
        (contact ? times[courses[c].seed] : led.free_us[m]).push_back(1e-3 * double(tick.cpu_ns));
      }
    for (const auto& [hand, us] : times) {
      led.run_us[m].push_back(comparison::mean(us));
      led.tick_us[m].insert(led.tick_us[m].end(), us.begin(), us.end());
    }
  }
  return led;
}

WorkPrecision errorsOf(const Led& led, const Labels& labels,
                       const std::vector<comparison::Summary>& summaries,
                       const std::vector<comparison::Course>& courses,
                       const std::function<std::vector<double>(std::size_t, std::size_t)>& errors) {
  WorkPrecision work{labels.title, labels.description, "mean CPU of a tick in contact [us]",
                     labels.error};
  for (std::size_t m = 0; m < led.tracks.size(); ++m) {
    const Contenders::Name& who = led.field.names[m];
    WorkPoint point{who.method, who.setting,         led.tick_us[m],
                    {},         summaries[m].counts, led.run_us[m]};
    std::map<unsigned, std::vector<double>> hands;
    for (std::size_t c = 0; c < courses.size(); ++c) {
      const std::vector<double> here = errors(m, c);
      point.error.insert(point.error.end(), here.begin(), here.end());
      auto& hand = hands[courses[c].seed];
      hand.insert(hand.end(), here.begin(), here.end());
    }
    for (const auto& [hand, of_it] : hands)
      if (hands.size() > 1 && !of_it.empty()) point.hands.push_back(comparison::mean(of_it));
    work.points.push_back(std::move(point));
  }
  return work;
}

std::vector<std::vector<bool>> deviceInside(const std::vector<comparison::Course>& courses,
                                            const comparison::Judge& judge) {
  std::vector<std::vector<bool>> inside;
  for (const comparison::Course& course : courses) {
    inside.emplace_back();
    for (const haptics::Pose& X_WD : course.device)
      inside.back().push_back(!course.jerk && !judge.legal(X_WD));
  }
  return inside;
}

std::vector<std::vector<double>> leastDistances(const Led& led, comparison::Method& unhurried,
                                                const std::vector<comparison::Course>& courses,
                                                const std::vector<std::vector<bool>>& inside,
                                                const haptics::PointShell& shell,
                                                const comparison::Judge& judge, std::size_t every) {
  std::vector<std::vector<double>> least;
  for (std::size_t c = 0; c < courses.size(); ++c) {
    const std::vector<haptics::Pose>& device = courses[c].device;
    auto& course = least.emplace_back(device.size(), NAN);
    if (courses[c].jerk) continue;
    unhurried.start(device.front());
    for (std::size_t n = 0; n < device.size(); ++n) {
      const haptics::Pose X_best = unhurried.tick(device[n]).X_WP;
      if (n % every > 0 || !inside[c][n]) continue;
      course[n] = comparison::massDistance(X_best, device[n], shell);
      for (const comparison::Track& track : led.tracks) {
        const haptics::Pose& X_WP = track.ticks[c][n].X_WP;
        const double apart = comparison::massDistance(X_WP, device[n], shell);
        if (apart < course[n] && judge.legal(X_WP)) course[n] = apart;
      }
    }
  }
  return least;
}

std::vector<double> distancesOf(const std::vector<comparison::Tick>& ticks,
                                const comparison::Course& course, const std::vector<bool>& inside,
                                const haptics::PointShell& shell,
                                const std::vector<double>* least) {
  std::vector<double> distances;
  for (std::size_t n = 0; n < course.device.size(); ++n) {
    if (!inside[n] || (least && std::isnan((*least)[n]))) continue;
    const double apart = comparison::massDistance(ticks[n].X_WP, course.device[n], shell);
    distances.push_back(1e3 * std::max(0.0, apart - (least ? (*least)[n] : 0.0)));
  }
  return distances;
}

WorkPrecision couplingOf(const Led& led, const std::string& title,
                         const std::vector<comparison::Summary>& summaries,
                         const std::vector<comparison::Course>& courses,
                         const std::vector<std::vector<bool>>& inside,
                         const haptics::PointShell& shell) {
  return errorsOf(
      led,
      {title,
       "Distance of proxy and device in the mass metric in the ticks in which the device itself is "
       "inside, the same for all methods, jerk left out, against time. A frozen proxy is cheap and "
       "far; one that is inside is near and wrong.",
       "coupling distance [mm]"},
      summaries, courses, [&](std::size_t m, std::size_t c) {
        return distancesOf(led.tracks[m].ticks[c], courses[c], inside[c], shell);
      });
}

Table factsOf(const Led& led, const std::string& caption,
              const std::vector<comparison::Summary>& summaries) {
  Table facts{caption,
              {"method", "setting", "deepest [mm]", "points through walls", "frozen [%]",
               "truly stuck [%]", "slack in contact [mm]: 50, 90, 99 %", "cut [%]", "most contacts",
               "mean CPU of a free tick [us]"},
              {}};
  for (std::size_t m = 0; m < summaries.size(); ++m) {
    const comparison::Summary& s = summaries[m];
    const std::vector<double> slack = s.sorted(&comparison::Part::slack_mm);
    facts.rows.push_back({led.field.names[m].method, led.field.names[m].setting,
                          shortly(s.penetration_mm), std::to_string(s.wall_passages),
                          shortly(100.0 * s.frozen), shortly(100.0 * s.truly_stuck),
                          shortly(comparison::quantile(slack, 0.5)) + ", " +
                              shortly(comparison::quantile(slack, 0.9)) + ", " +
                              shortly(comparison::quantile(slack, 0.99)),
                          shortly(100.0 * s.cut), std::to_string(s.contacts_max),
                          shortly(comparison::mean(led.free_us[m]))});
  }
  return facts;
}

void addSlack(Outcome& outcome, const std::string& what, const comparison::Summary& summary,
              double voxel) {
  const std::vector<double> slack = summary.sorted(&comparison::Part::slack_mm);
  outcome.cases.push_back({what + ": local slack in contact, median",
                           slack.empty() ? NAN : comparison::quantile(slack, 0.5), 100.0 * voxel,
                           "mm", Case::Sense::AtMost,
                           "A tenth of a voxel, as of a tool that is held in the closed forms."});
}

void addLegal(Outcome& outcome, const std::string& what, const comparison::Summary& summary) {
  outcome.cases.push_back({what + ": penetration", summary.penetration_mm, 0.0, "mm"});
  outcome.cases.push_back(
      {what + ": points through walls", double(summary.wall_passages), 0.0, "points"});
}

}  // namespace study::accuracy
