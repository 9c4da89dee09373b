// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/study/report/outcome.h"

namespace study::accuracy {

/// How long and how often.
struct SceneEffort {
  double seconds = 1.5;  ///< of each of six hands, after the lead-in
  int holds = 40;
  int detours = 12;
  bool every_setting = true;  ///< all budgets, fields, normals, …, or one or two of each
  int runs = 5;               ///< of all methods along all hands, one after the other
  /// How far ours may be in the hole, over accept-inside. In a short run a single place where the
  /// peg jams decides.
  double over_inside = 1.05;
};

/// One of the paper's scenes, rebuilt: the readings of the paper, the penalty method and the static
/// god object, each swept over its own settings, and ours over budgets, all led along the same
/// hands in one process. Coupling distance and residual against time; penetration, wall passages
/// and frozen share; a row of Table 1. What is judged runs by counted work, so that the cases
/// repeat; budgets of CPU time are for the diagrams.
Outcome sceneStudy(const std::string& scene, const SceneEffort& effort);

/// The same of ours alone, with other values of epsilon and of the sub-steps in a tick, and with
/// other fields and normals.
Outcome finenessStudy(const std::string& scene, const SceneEffort& effort);

/// Ours with 10^3 points and more, with budgets: what a budget costs in lag.
Outcome pointStudy(bool flat, const std::vector<int>& points, const std::vector<int>& budgets_us);

}  // namespace study::accuracy
