// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "haptics/core/error.h"

namespace study {

using Json = nlohmann::ordered_json;

/// What makes results comparable: those of another build, depth or seed are another study.
struct Identity {
  std::string study, version, build;
  Depth depth = Depth::Quick;
  std::uint64_t seed = 1;

  bool operator==(const Identity&) const = default;
};

/// A job that was run.
struct Finished {
  std::string job, section;
  double seconds = 0.0;
  Json machine;
  Outcome outcome;
};

/// All that is known of a study: of its jobs, in their order, those that were run.
struct Results {
  Identity identity;
  std::string title;
  std::vector<std::string> introduction = {};
  Front front = {};
  std::vector<std::string> jobs = {};  ///< all of them, by name
  std::vector<Finished> finished = {};

  std::vector<std::string> missing() const;
  /// The cases of all jobs in their order.
  std::vector<Case> cases() const;
};

/// The command that repeats the whole study.
std::string commandOf(const Identity& identity);

/// One job's file: what stands between a shard and the whole.
Json jsonOf(const Identity& identity, const Finished& finished);
/// Reads one back. Refuses what is not such a file, with a sentence that names `file`.
haptics::Expected<Finished> finishedOf(const Json& json, const std::string& file);
haptics::Expected<Identity> identityOf(const Json& json, const std::string& file);

/// results.json; app/study/results.schema.json says what is in it.
Json jsonOf(const Results& results);
/// results.csv: one row for each case and each point of a plot.
std::string csvOf(const Results& results);
/// report.html.
std::string htmlOf(const Results& results);

}  // namespace study
