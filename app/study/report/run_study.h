// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/study/report/results.h"

namespace study {

/// Which of n equal shares of the jobs: 1 to n.
struct Shard {
  int index = 1, count = 1;
};
/// "2/8": the second of eight; none for all else.
std::optional<Shard> shardOf(const std::string& text);

struct RunOptions {
  Depth depth = Depth::Full;
  std::uint64_t seed = 1;
  Shard shard = {};
  std::filesystem::path out;  ///< a folder; made where there is none
  /// Asked between jobs; true ends the run, and what is done stays.
  std::function<bool()> stop = [] { return false; };
  /// A line on how far it is.
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// Runs the jobs of a shard that have not been run yet, each into a file of its own under `out`.
/// So a run that was stopped goes on, shards may share a folder, and to run one again changes
/// nothing. Returns all that is there. Refuses a folder with jobs of another study, build, depth or
/// seed.
haptics::Expected<Results> runJobs(const Study& study, const RunOptions& options);

/// Puts the jobs of several folders together into `out`, as if they had been run there. The same
/// job from two folders is taken from the first. Refuses a mix as runJobs does.
haptics::Expected<Results> mergeJobs(
    const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out,
    const std::function<std::optional<Study>(const Identity&)>& studyOf);

/// runJobs, and then results.json, results.csv and report.html of all that is there.
haptics::Expected<Results> runStudy(const Study& study, const RunOptions& options);

/// mergeJobs, and then the same three files.
haptics::Expected<Results> mergeStudies(
    const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out,
    const std::function<std::optional<Study>(const Identity&)>& studyOf);

}  // namespace study
