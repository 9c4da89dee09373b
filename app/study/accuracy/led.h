// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/study/accuracy/contenders.h"
#include "app/study/accuracy/work_precision.h"
#include "app/study/comparison/course.h"

namespace study::accuracy {

/// Contenders that were all led along the same hands, several times. What they did is of the first
/// run, what it cost is of all.
struct Led {
  Contenders field;
  std::vector<comparison::Track> tracks;
  std::vector<std::vector<double>> tick_us;  ///< of each contender, of all runs
  std::vector<std::vector<double>> run_us;   ///< of each contender: the mean of each run

  std::size_t indexOf(const std::string& method, const std::string& setting) const;
};
Led led(Contenders field, const std::vector<comparison::Course>& courses, int runs);

/// Coupling distance against time, in the ticks in which the device itself is inside: the same for
/// all, whatever a method calls a contact.
WorkPrecision couplingOf(const Led& led, const std::string& title,
                         const std::vector<comparison::Summary>& summaries,
                         const std::vector<comparison::Course>& courses,
                         const haptics::PointShell& shell, const comparison::Judge& judge);

/// What no diagram shows of them, a row for each.
Table factsOf(const Led& led, const std::string& caption,
              const std::vector<comparison::Summary>& summaries);

/// Adds that a contender enters nothing and goes through nothing.
void addLegal(Outcome& outcome, const std::string& what, const comparison::Summary& summary);

}  // namespace study::accuracy
