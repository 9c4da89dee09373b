// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/study/report/outcome.h"

namespace study::stability {

/// The study: stiff and extreme input. Its jobs are those of the parts below.
Study stabilityStudy(Depth depth);

/// Situations in which the paper's method, or a plausible step beyond it, fails: each a case with
/// its bound. A quick study makes a tenth of the tries.
std::vector<Job> failureJobs(Depth depth);
/// The limits of stiffness of every rated device, on a wall and through the tick.
std::vector<Job> limitJobs(Depth depth);
/// Presses through the tick: every device, stage, stiffness, delay and noise.
std::vector<Job> pressJobs(Depth depth);
/// Hands that wedge, pry and hook, and a handle that is turned while a long lever touches.
std::vector<Job> handJobs(Depth depth);

/// A press on a structure and a slide across it, for each way in which it can be felt.
std::vector<Job> structureJobs();

/// A burr that cuts plates, edges and thin walls, pressed and slid, with the isovalue still or
/// moved.
std::vector<Job> cutJobs(Depth depth);

/// Every device at every rate that its link carries, through hands that tap, wedge, pry and hook:
/// twenty minutes a device in full.
std::vector<Job> rateJobs(Depth depth);

/// What a job finds, as it comes up. A case is named "subject/what".
struct Findings {
  std::string subject = {};
  Outcome outcome = {};

  void atMost(const std::string& what, double value, double bound, const std::string& unit = "",
              const std::string& note = "", Case::Sense sense = Case::Sense::AtMost) {
    outcome.cases.push_back({subject + "/" + what, value, bound, unit, sense, note});
  }
  void atLeast(const std::string& what, double value, double bound, const std::string& unit = "",
               const std::string& note = "") {
    atMost(what, value, bound, unit, note, Case::Sense::AtLeast);
  }
  void none(const std::string& what, int count) { atMost(what, count, 0.0); }
  Plot& plot(const std::string& title, const std::string& description, const Axis& x, const Axis& y,
             std::vector<Series> series = {}) {
    return outcome.plots.emplace_back(Plot{title, description, x, y, std::move(series)});
  }
  /// Adds a row to the table with this caption. Each cell brings the head of its column.
  void row(const std::string& caption,
           const std::vector<std::pair<const char*, std::string>>& cells) {
    auto table = std::ranges::find(outcome.tables, caption, &Table::caption);
    const bool first = table == outcome.tables.end();
    if (first) table = outcome.tables.insert(table, {caption, {}, {}});
    auto& row = table->rows.emplace_back();
    for (const auto& [head, text] : cells) {
      if (first) table->head.push_back(head);
      row.push_back(text);
    }
  }
};

}  // namespace study::stability
