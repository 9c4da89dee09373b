// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/study/comparison/course.h"
#include "app/study/comparison/feel.h"
#include "app/study/comparison/holds.h"
#include "app/study/comparison/sweep.h"

namespace bench {

using namespace comparison;  // its words are what is reported here

using Json = nlohmann::ordered_json;

/// Everything measured in one scene, literal first and ours last.
struct SceneReport {
  std::string scene, tool;
  int points = 0;
  double voxel_mm = 0.0;                            ///< smallest side
  double rest_gap_mm = 0.0;                         ///< what ours keeps to the surface
  double build_ms = 0.0;                            ///< of haptics::Scene
  std::vector<haptics::Structure> structures = {};  ///< of that Scene
  std::optional<double> literal_us = {};
  std::vector<Summary> summaries = {};
  std::vector<Summary> rates = {};      ///< ours alone at each rate of the servo; may be empty
  std::vector<HoldSummary> holds = {};  ///< empty: not measured
  std::vector<FeelSummary> feel = {};   ///< empty: not measured
};

/// Why the literal baseline cannot be compared with; empty if it can: it takes 1.3 to 2 samples a
/// point, and its mean tick is within a factor of 2 of what is known of it.
std::string whyNotHonest(const SceneReport& report);

/// `results`, `ratios`, and what stands behind them.
Json jsonOf(const std::vector<SceneReport>& reports, const std::vector<SweepRow>& sweep);
/// The figures to reach, and what was reached, as Markdown.
std::string tableOf(const std::vector<SceneReport>& reports, const std::vector<SweepRow>& sweep);

}  // namespace bench
