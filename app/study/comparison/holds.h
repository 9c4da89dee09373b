// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/study/comparison/course.h"

namespace comparison {

/// A device that is brought somewhere in 30 ms and then held still.
struct Hold {
  Pose X_start;  ///< of proxy and device, legal
  Pose X_WD;     ///< where the device is held
};

/// Places for holds: poses that ours took in contact, spread over its courses, each with the
/// device's pose then, moved at random by some millimetres and tenths of a radian.
std::vector<Hold> holdsAlong(const Track& ours, const std::vector<Course>& courses, int count);

/// What the methods do with a device at rest. Residuals are distances to the device in the mass
/// metric beyond the least that any start reached [mm].
struct HoldSummary {
  std::string method;
  double residual_median_mm = 0.0, residual_mean_mm = 0.0;  ///< after 8 ticks
  /// After 8 ticks, beyond the least that ours, unhurried, or the method itself after 64 ticks
  /// reaches from the same start: what is left of converging. The rest of the residual is that the
  /// other starts end at another minimum.
  double same_start_median_mm = 0.0, same_start_mean_mm = 0.0;
  double settled_median_mm = 0.0, settled_mean_mm = 0.0;  ///< after 64 ticks
  double rest_p99_mm = 0.0, rest_max_mm = 0.0;  ///< way of a point in the last ticks, all held
  /// How much nearer a legal pose within 0.5 mm of the last one is, at least: mean over the holds
  /// that end legal.
  double slack_mm = 0.0;
  int holds = 0, legal = 0;
  std::vector<double> residuals_mm = {};  ///< hold by hold, after 8 ticks
};

/// How thorough the comparison is.
struct HoldPlan {
  int count = 40;          ///< holds
  int ticks = 260;         ///< held; movement at rest is that from 200 on, or the last 60
  int detours = 12;        ///< other ways to the same hold, for the least distance
  int slack_trials = 400;  ///< poses tried about the last one
};

/// Runs every hold with every method; the least distance is what ours reaches with a budget that
/// does not bind, straight and by the detours, or what any method reaches at a legal pose.
std::vector<HoldSummary> compareHolds(std::vector<std::unique_ptr<Method>>& methods,
                                      Method& unhurried, const std::vector<Hold>& holds,
                                      const haptics::PointShell& shell, const Judge& judge,
                                      const HoldPlan& plan);

}  // namespace comparison
