// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/study/accuracy/contenders.h"
#include "app/study/accuracy/work_precision.h"
#include "app/study/comparison/course.h"

namespace study::accuracy {

/// Contenders that were all led along the same hands: what they did, and what it cost.
struct Led {
  Contenders field;
  std::vector<comparison::Track> tracks;
  /// Of each contender: ticks in contact, no jerks, and those of free space.
  std::vector<std::vector<double>> tick_us, free_us;
  std::vector<std::vector<double>> run_us;  ///< of each contender: the mean of each hand

  std::size_t indexOf(const std::string& method, const std::string& setting) const;
};
Led led(Contenders field, const std::vector<comparison::Course>& courses,
        const haptics::PointShell& shell);

/// What an error against time needs beside its errors.
struct Labels {
  std::string title, description, error;
};
/// An error against time: those of a contender on a course, if it has any there.
WorkPrecision errorsOf(const Led& led, const Labels& labels,
                       const std::vector<comparison::Summary>& summaries,
                       const std::vector<comparison::Course>& courses,
                       const std::function<std::vector<double>(std::size_t, std::size_t)>& errors);

/// In which ticks the device itself is inside, no jerks: the same for all, whatever a method calls
/// a contact.
std::vector<std::vector<bool>> deviceInside(const std::vector<comparison::Course>& courses,
                                            const comparison::Judge& judge);

/// The least distance of each course's device, where it is inside, that is known [m], every so many
/// ticks: that of our own tick with nothing to hurry it, or of any contender's legal pose if that
/// is nearer. The other ticks have no number.
std::vector<std::vector<double>> leastDistances(const Led& led, comparison::Method& unhurried,
                                                const std::vector<comparison::Course>& courses,
                                                const std::vector<std::vector<bool>>& inside,
                                                const haptics::PointShell& shell,
                                                const comparison::Judge& judge, std::size_t every);

/// Coupling distances [mm] of a contender on a course, where the device is inside; with `least` how
/// much they are over it, and 0 where a pose inside is nearer.
std::vector<double> distancesOf(const std::vector<comparison::Tick>& ticks,
                                const comparison::Course& course, const std::vector<bool>& inside,
                                const haptics::PointShell& shell,
                                const std::vector<double>* least = nullptr);

/// The coupling distance against time, where the device is inside.
WorkPrecision couplingOf(const Led& led, const std::string& title,
                         const std::vector<comparison::Summary>& summaries,
                         const std::vector<comparison::Course>& courses,
                         const std::vector<std::vector<bool>>& inside,
                         const haptics::PointShell& shell);

/// What no diagram shows of them, a row for each.
Table factsOf(const Led& led, const std::string& caption,
              const std::vector<comparison::Summary>& summaries);

/// Adds that a contender is about as near to the device as it can be: its local slack in contact.
void addSlack(Outcome& outcome, const std::string& what, const comparison::Summary& summary,
              double voxel);

/// Adds that a contender enters nothing and goes through nothing.
void addLegal(Outcome& outcome, const std::string& what, const comparison::Summary& summary);

}  // namespace study::accuracy
