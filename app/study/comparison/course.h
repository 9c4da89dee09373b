// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/comparison/measures.h"
#include "app/study/comparison/methods.h"
#include "haptics/simulation/hand.h"

namespace comparison {

/// What one hand did: the device's poses, one a tick, from free space on.
struct Course {
  std::string hand;
  std::vector<Pose> device;
  bool jerk = false;  ///< counts for time and walls, not for coupling and freezing
  haptics::ServoRate rate = {};
  unsigned seed = 1;  ///< which of the hands of its kind
};

/// tap, slide, wedge, pry, hook and jerk, each for so many seconds after a lead-in of half a
/// second. The device is the hand itself, so that every method is led along the same path. So many
/// hands of each kind, one of each after the other; another seed, others.
haptics::Expected<std::vector<Course>> coursesIn(const haptics::Scene& scene,
                                                 const Touched& touched, double seconds,
                                                 haptics::ServoRate rate = {}, unsigned seed = 1,
                                                 unsigned hands = 1);

/// What moves an aimed hand so that it does at X_place, a scene's own place for the tool, what it
/// does where it aimed.
Pose movedTo(const Pose& X_place, const haptics::Hand& hand);

/// What a method did on the courses: one row a tick, course after course.
struct Track {
  std::string method;
  bool sub_steps = false;  ///< a tick is not one motion but several
  std::vector<std::vector<Tick>> ticks;
};

/// Leads all methods along all courses, tick by tick in turn; who is first changes every tick.
std::vector<Track> follow(std::vector<std::unique_ptr<Method>>& methods,
                          const std::vector<Course>& courses);

/// One hand's part of it.
struct Part {
  std::string hand;
  unsigned seed = 1;
  double mean_us = 0.0, coupling_mm = 0.0;
  double frozen = 0.0, contact = 0.0, cut = 0.0;  ///< shares of ticks
  /// The share of milliseconds in contact that are frozen with a local slack over one rest gap: the
  /// frozen share times what the ticks tell at which the slack was measured.
  double truly_stuck = 0.0;
  std::vector<double> slack_mm = {};         ///< local slack in contact, frozen or not
  std::vector<double> frozen_slack_mm = {};  ///< where frozen
  std::vector<double> depths_mm = {};        ///< of the judged poses in contact
};

/// Where the local slack is measured: at so many of each course's milliseconds in contact, and of
/// the frozen ones among them, spread over the course by the seed.
struct SlackPlan {
  std::size_t contact_ticks = 20, frozen_ticks = 20;
  int trials = 200;
  std::uint32_t seed = 1;
};

/// A track in numbers. Times are thread CPU.
struct Summary {
  std::string method;
  double mean_us = 0.0, p50_us = 0.0, p99_us = 0.0, p999_us = 0.0, max_us = 0.0;
  double coupling_mm = 0.0;  ///< mean distance in the mass metric over contact ticks, jerk left out
  double guided_mm = 0.0;    ///< the same over tap, slide and hook
  double frozen = 0.0;       ///< share of milliseconds in contact, jerk left out
  double truly_stuck = 0.0;  ///< as Part::truly_stuck
  MeanCounts counts;         ///< of a tick
  double p999_work = 0.0;    ///< units of a tick
  int contacts_max = 0;
  double cut = 0.0;             ///< share of ticks that the budget ended
  double penetration_mm = 0.0;  ///< deepest of the judged poses
  int wall_passages = 0;        ///< points, over the judged ticks
  std::size_t ticks = 0;
  std::vector<Part> parts;  ///< hand by hand

  /// Such values of all hands, in order of size.
  std::vector<double> sorted(std::vector<double> Part::*values) const;
};

/// Metres that a tick's proxy is from its device in the mass metric, where the tool is in contact:
/// whoever is kept from the device is, whatever a cut tick knows of it; of a tool with mass, where
/// its points touch. None in free space.
std::optional<double> coupledBy(const Tick& tick, const Pose& X_WD,
                                const haptics::PointShell& shell);

/// Judges every `every`-th pose for its depth, in jerks five times as many, and every other tick
/// for passages, in jerks all. A rest gap is what a contact keeps between point and surface [m].
Summary summaryOf(const Track& track, const std::vector<Course>& courses,
                  const haptics::PointShell& shell, const Judge& judge, std::size_t every,
                  double rest_gap, const SlackPlan& plan = {});

}  // namespace comparison
