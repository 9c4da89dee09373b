// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/led.h"

#include <algorithm>
#include <utility>

#include "app/study/comparison/measures.h"

namespace study::accuracy {

std::size_t Led::indexOf(const std::string& method, const std::string& setting) const {
  const auto found = std::ranges::find_if(field.names, [&](const Contenders::Name& name) {
    return name.method == method && name.setting == setting;
  });
  return static_cast<std::size_t>(found - field.names.begin());
}

Led led(Contenders field, const std::vector<comparison::Course>& courses, int runs) {
  Led led{std::move(field), {}, {}, {}};
  led.tick_us.resize(led.field.methods.size());
  led.run_us.resize(led.field.methods.size());
  for (int run = 0; run < runs; ++run) {
    std::vector<comparison::Track> tracks = comparison::follow(led.field.methods, courses);
    for (std::size_t m = 0; m < tracks.size(); ++m) {
      std::vector<double> times;
      for (const auto& course : tracks[m].ticks)
        for (const comparison::Tick& tick : course) times.push_back(1e-3 * double(tick.cpu_ns));
      led.run_us[m].push_back(comparison::mean(times));
      led.tick_us[m].insert(led.tick_us[m].end(), times.begin(), times.end());
    }
    if (run == 0) led.tracks = std::move(tracks);
  }
  return led;
}

WorkPrecision couplingOf(const Led& led, const std::string& title,
                         const std::vector<comparison::Summary>& summaries,
                         const std::vector<comparison::Course>& courses,
                         const haptics::PointShell& shell, const comparison::Judge& judge) {
  std::vector<std::vector<bool>> inside;
  for (const comparison::Course& course : courses) {
    inside.emplace_back();
    for (const haptics::Pose& X_WD : course.device)
      inside.back().push_back(!course.jerk && !judge.legal(X_WD));
  }
  WorkPrecision coupling{
      title,
      "Distance of proxy and device in the mass metric in the ticks in which the "
      "device itself is inside, the same for all methods, jerk left out, "
      "against time. A frozen proxy is cheap and far; one that is inside is "
      "near and wrong.",
      "mean CPU of a tick [us]", "coupling distance [mm]"};
  for (std::size_t m = 0; m < led.tracks.size(); ++m) {
    const Contenders::Name& who = led.field.names[m];
    WorkPoint point{who.method, who.setting,         led.tick_us[m],
                    {},         summaries[m].counts, led.run_us[m]};
    for (std::size_t c = 0; c < courses.size(); ++c)
      for (std::size_t n = 0; n < courses[c].device.size(); ++n)
        if (inside[c][n])
          point.error.push_back(1e3 * comparison::massDistance(led.tracks[m].ticks[c][n].X_WP,
                                                               courses[c].device[n], shell));
    coupling.points.push_back(std::move(point));
  }
  return coupling;
}

Table factsOf(const Led& led, const std::string& caption,
              const std::vector<comparison::Summary>& summaries) {
  Table facts{caption,
              {"method", "setting", "deepest [mm]", "points through walls", "frozen [%]", "cut [%]",
               "most contacts"},
              {}};
  for (std::size_t m = 0; m < summaries.size(); ++m) {
    const comparison::Summary& s = summaries[m];
    facts.rows.push_back({led.field.names[m].method, led.field.names[m].setting,
                          shortly(s.penetration_mm), std::to_string(s.wall_passages),
                          shortly(100.0 * s.frozen), shortly(100.0 * s.cut),
                          std::to_string(s.contacts_max)});
  }
  return facts;
}

void addLegal(Outcome& outcome, const std::string& what, const comparison::Summary& summary) {
  outcome.cases.push_back({what + ": penetration", summary.penetration_mm, 0.0, "mm"});
  outcome.cases.push_back(
      {what + ": points through walls", double(summary.wall_passages), 0.0, "points"});
}

}  // namespace study::accuracy
