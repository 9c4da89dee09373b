// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/plan/plan.h"

#include <functional>
#include <limits>
#include <utility>

#include "app/study/plan/courses.h"
#include "resources/messages/messages.h"

namespace study::plan {

Study planStudy(Depth depth) {
  const bool quick = depth == Depth::Quick;
  const int most = quick ? 3 : 5, ticks = quick ? 900 : 1200;
  Study study{"plan", "What each scene leaves out"};
  study.introduction = {
      "A scene is planned when it is built: what its ticks leave out, each with its reason. Here "
      "every omission is switched off against on, on the same course of the hand, tick by tick in "
      "turn in one process, each side in a closed loop of its own. Switched off, the work is done "
      "beside the rest, and what it finds counts: a point that is inside, or that would enter, "
      "stops the tool. So poses and forces must be the same to the bit, and the bound is zero.",
      "Time is thread CPU time of a tick, the cost of reading the clock taken off; the median of " +
          std::to_string(most) +
          " runs (3 of very many points), and between which the middle eight tenths of them lie. "
          "What is saved is the work that is not done; the books that are kept to know this are in "
          "both. Work is what the "
          "budget counts, and repeats exactly. No budget cuts a tick here.",
      "A scene that is not cut is compared in the same way with itself under a tool that could "
      "cut, "
      "whose burr is not held: what removes bone costs nothing where no bone is removed.",
      "Free space rests on the bounds and on the room that is left, and is off with either "
      "of them: what those two save contains it."};
  const auto add = [&](const Planned& planned, std::string name, const char* section, double cost,
                       std::function<Outcome(const Course&)> judged) {
    study.jobs.push_back({std::move(name), section, cost, [=](std::uint64_t seed) {
                            const auto course = made(planned, ticks, seed);
                            if (course) return judged(*course);
                            Outcome refused;
                            refused.cases.push_back({planned.name + ": made",
                                                     std::numeric_limits<double>::quiet_NaN(), 0.0,
                                                     "", Case::Sense::AtMost,
                                                     resources::sentence(course.error())});
                            return refused;
                          }});
  };
  for (const Planned& planned : courses(depth)) {
    const int runs = planned.brief ? 3 : most;
    add(planned, planned.name, "What is left out", quick ? 5.0 : 15.0,
        [runs](const Course& course) { return examined(course, runs); });
    // those whose tool ends in a ball, or nearly
    if (planned.tool == "drill" || planned.tool == "sphere" || planned.tool == "probe")
      add(planned, planned.name + ", not cut", "What is not cut", quick ? 0.5 : 2.0,
          [runs](const Course& course) { return uncut(course, runs); });
  }
  study.front = {{{"What is left out changes no pose: {worst} in {count} comparisons.", ": pose"},
                  {"It changes no force: {worst} in {count} comparisons.", ": force"},
                  {"It changes no torque: {worst} in {count} comparisons.", ": torque"},
                  {"A burr that is not held does no work: {worst} more in {count} courses.",
                   ": work of a tick, more"}},
                 {"Mean tick by points of the tool"}};
  return study;
}

}  // namespace study::plan
