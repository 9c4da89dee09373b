// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study/cohort/manifest.h"
#include "app/study/report/run_study.h"

namespace cohort {

/// What a cohort came to, in numbers.
struct Summary {
  std::size_t lines = 0, rows = 0, refused = 0;
  std::size_t failing = 0;           ///< touches whose proxy entered the solid or was not finite
  std::size_t differing = 0;         ///< replays that differ
  std::vector<std::string> missing;  ///< labels of lines that were not run
};

/// The study of a manifest: a job for each line, so that shards, merging and going on are those of
/// all studies (app/study/report). Pictures go to `out`/pictures meanwhile.
study::Study studyOf(const Manifest& manifest, const std::filesystem::path& out,
                     const std::atomic<bool>& cancel);

/// Runs the lines of a shard that have not been run yet, each into a file of its own under
/// `options.out`. Without a shard, writes the tables and pages.
haptics::Expected<Summary> run(const Manifest& manifest, const study::RunOptions& options,
                               const std::atomic<bool>& cancel);

/// Joins the shards of a manifest in `out`, with their pictures, and writes the tables and pages:
/// group_touches.tsv, group_costs.tsv, group_replays.tsv, each with its dictionary (.json);
/// dataset_description.json of a BIDS derivative; index.html and a page for each scan. `before`:
/// the folder of an earlier cohort, to be compared row by row; empty: none. Refuses results of
/// another build or another manifest.
haptics::Expected<Summary> merge(const Manifest& manifest,
                                 const std::vector<std::filesystem::path>& folders,
                                 const std::filesystem::path& out,
                                 const std::filesystem::path& before);

/// What a cluster has to be asked for: read from the headers alone.
struct Plan {
  std::size_t lines = 0, rows = 0;
  int shards = 1;              ///< of a minute and more each, 1,000 at most
  std::int64_t memory_MB = 0;  ///< that the largest scan takes, with what is built for it
  double seconds = 0.0;        ///< of one core, about
};
Plan planOf(const Manifest& manifest);

}  // namespace cohort
