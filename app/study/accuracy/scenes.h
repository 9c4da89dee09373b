// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/study/report/outcome.h"

namespace study::accuracy {

/// How long and how often.
struct SceneEffort {
  unsigned hands = 20;   ///< of each of six kinds
  double seconds = 0.6;  ///< of each, after the lead-in
  int holds = 40;
  int detours = 12;
  bool every_setting = true;      ///< all budgets, fields, normals, …, or one or two of each
  std::size_t slacks = 1;         ///< of each hand in contact, and as many where frozen
  std::size_t stuck_slacks = 10;  ///< likewise where frozen, of ours alone
  int trials = 200;               ///< steps for each slack
  /// How far ours may be in the hole, over accept-inside. In a short run a single place where the
  /// peg jams decides.
  double over_inside = 1.05;
};

/// One of the paper's scenes, rebuilt: the readings of the paper, the penalty method and the static
/// god object, each swept over its own settings, and ours over budgets, all led along the same
/// hands in one process. Distance to the device and to the best pose, local slack, share truly
/// stuck, penetration and residual against time; wall passages and frozen share; a slow slide; a
/// row of Table 1. What is judged runs by counted work, so that the cases repeat; budgets of CPU
/// time are for the diagrams.
Outcome sceneStudy(const std::string& scene, const SceneEffort& effort, unsigned seed);

/// The same of ours alone, with other values of epsilon and of the sub-steps in a tick, and with
/// other fields and normals.
Outcome finenessStudy(const std::string& scene, const SceneEffort& effort, unsigned seed);

/// Ours alone at each rate of the servo, at 1000 N/m and at the stiffest rating of any device: how
/// much of the contact it is frozen, and truly stuck.
Outcome stuckStudy(const std::string& scene, const SceneEffort& effort, unsigned seed);

/// Ours with 10^3 points and more, with budgets: what a budget costs in lag.
Outcome pointStudy(bool flat, const std::vector<int>& points, const std::vector<int>& budgets_us);

}  // namespace study::accuracy
