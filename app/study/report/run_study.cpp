// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/report/run_study.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <fstream>
#include <numeric>

#include "app/build_info/build_info.h"
#include "haptics/process/input_file.h"
#include "haptics/process/output_file.h"

namespace study {
namespace {

constexpr std::uintmax_t kLargestJob = 256 << 20;  // bytes

namespace fs = std::filesystem;
using haptics::Error;
using haptics::Expected;

Error cannotWrite(const fs::path& path) {
  return {Error::Kind::Unsupported,
          path.string() + " cannot be written; choose a folder that is yours to write.",
          "unwritable"};
}

/// A job's file: its name with what a file name cannot hold replaced.
fs::path fileOf(const fs::path& folder, const std::string& job) {
  std::string name = job;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
  return folder / "jobs" / (name + ".json");
}

/// The jobs that stand in a folder; what `identity` is not given is taken from the first.
Expected<std::vector<Finished>> jobsIn(const fs::path& folder, std::optional<Identity>& identity) {
  std::vector<Finished> found;
  std::error_code failed;
  fs::directory_iterator entry{folder / "jobs", failed};
  for (; !failed && entry != fs::directory_iterator{}; entry.increment(failed)) {
    if (entry->path().extension() != ".json" || !entry->is_regular_file(failed)) continue;
    const auto text = haptics::readInput(entry->path(), kLargestJob);
    if (!text) return tl::unexpected(text.error());
    const std::string name = entry->path().string();
    const Json json = haptics::isNestedDeeper(*text, haptics::kDeepestJson)
                          ? Json(Json::value_t::discarded)
                          : Json::parse(*text, nullptr, false);
    const auto its = identityOf(json, name);
    if (!its) return tl::unexpected(its.error());
    if (!identity) identity = *its;
    if (*its != *identity)
      return tl::unexpected(
          Error{Error::Kind::Unsupported,
                name + " is of another study, version, build, depth or seed than the rest; results "
                       "of two are not mixed: choose another folder, or remove it.",
                "mixed"});
    auto finished = finishedOf(json, name);
    if (!finished) return tl::unexpected(finished.error());
    found.push_back(std::move(*finished));
  }
  if (failed && failed != std::errc::no_such_file_or_directory)
    return tl::unexpected(Error{Error::Kind::Unsupported,
                                folder.string() + " cannot be read; check who may read it.",
                                "not-readable"});
  return found;
}

/// A job that throws is a job that failed, and not the end of the others.
Outcome outcomeOf(const Job& job, std::uint64_t seed) {
  try {
    return job.run(seed);
  } catch (const std::exception& error) {
    Outcome outcome;
    outcome.cases.push_back({job.name + ": ran to its end", 0.0, 1.0, "", Case::Sense::AtLeast,
                             std::string{"It ended with: "} + error.what()});
    return outcome;
  }
}

/// The jobs in the order of the study, each once.
Results resultsOf(const Study& study, const Identity& identity, std::vector<Finished> found) {
  Results results{identity, study.title, study.introduction, study.front};
  for (const Job& job : study.jobs) {
    results.jobs.push_back(job.name);
    const auto at = std::ranges::find(found, job.name, &Finished::job);
    if (at != found.end()) results.finished.push_back(std::move(*at));
  }
  return results;
}

/// The results, once their files are written.
Expected<Results> written(Expected<Results> results, const fs::path& out) {
  if (!results) return results;
  const std::pair<const char*, std::string> files[] = {
      {"results.json", jsonOf(*results).dump(1) + "\n"},
      {"results.csv", csvOf(*results)},
      {"report.html", htmlOf(*results)}};
  for (const auto& [name, text] : files)
    if (auto file = haptics::writeFile(out / name, text); !file)
      return tl::unexpected(file.error());
  return results;
}

Expected<void> makeFolder(const fs::path& out) {
  std::error_code failed;
  fs::create_directories(out / "jobs", failed);
  if (failed) return tl::unexpected(cannotWrite(out));
  return {};
}

/// The jobs of a shard: dealt out so that all shards cost about the same.
std::vector<const Job*> shareOf(const Study& study, const Shard& shard) {
  std::vector<std::size_t> order(study.jobs.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater{},
                           [&](std::size_t n) { return study.jobs[n].cost; });
  std::vector<double> load(static_cast<std::size_t>(shard.count), 0.0);
  std::vector<std::size_t> mine;
  for (const std::size_t n : order) {
    const auto least = std::ranges::min_element(load);
    *least += study.jobs[n].cost;
    if (least - load.begin() == shard.index - 1) mine.push_back(n);
  }
  std::ranges::sort(mine);
  std::vector<const Job*> jobs;
  for (const std::size_t n : mine) jobs.push_back(&study.jobs[n]);
  return jobs;
}

/// A seed of its own for each job (FNV-1a).
std::uint64_t seedOf(std::uint64_t seed, const std::string& job) {
  std::uint64_t hash = 14695981039346656037ULL ^ seed;
  for (const char c : job) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

std::string duration(double seconds) {
  if (seconds < 90.0) return std::to_string(std::lround(seconds)) + " s";
  if (seconds < 5400.0) return std::to_string(std::lround(seconds / 60.0)) + " min";
  return std::to_string(std::lround(seconds / 3600.0)) + " h";
}

}  // namespace

std::optional<Shard> shardOf(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, shard.index);
  if (first != std::errc{} || slash == end || *slash != '/') return {};
  const auto [stop, second] = std::from_chars(slash + 1, end, shard.count);
  if (second != std::errc{} || stop != end) return {};
  if (shard.count < 1 || shard.count > 10'000 || shard.index < 1 || shard.index > shard.count)
    return {};
  return shard;
}

Expected<Results> runJobs(const Study& study, const RunOptions& options) {
  const Identity identity{study.name, app::versionHere(), app::buildHere(), options.depth,
                          options.seed};
  if (auto made = makeFolder(options.out); !made) return tl::unexpected(made.error());
  std::optional<Identity> expected = identity;
  auto found = jobsIn(options.out, expected);
  if (!found) return tl::unexpected(found.error());

  std::vector<const Job*> jobs = shareOf(study, options.shard);
  std::erase_if(jobs, [&](const Job* job) {
    return std::ranges::find(*found, job->name, &Finished::job) != found->end();
  });
  double cost = 0.0, spent = 0.0, cost_done = 0.0;
  for (const Job* job : jobs) cost += job->cost;
  const Json machine = app::machineHere();
  for (std::size_t n = 0; n < jobs.size() && !options.stop(); ++n) {
    const Job& job = *jobs[n];
    const auto begun = std::chrono::steady_clock::now();
    Finished finished{job.name, job.section, 0.0, machine,
                      outcomeOf(job, seedOf(options.seed, job.name))};
    if (!finished.outcome.whole) break;
    finished.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (auto written = haptics::writeFile(fileOf(options.out, job.name),
                                          jsonOf(identity, finished).dump(1) + "\n");
        !written)
      return tl::unexpected(written.error());
    spent += finished.seconds;
    cost_done += job.cost;
    const double left = cost_done > 0.0 ? (cost - cost_done) * spent / cost_done : 0.0;
    options.tell(std::to_string(n + 1) + " of " + std::to_string(jobs.size()) + ": " + job.name +
                 ", " + duration(finished.seconds) + "; about " + duration(left) + " left");
  }
  // of shards that share the folder, what the others have done meanwhile is there as well
  found = jobsIn(options.out, expected);
  if (!found) return tl::unexpected(found.error());
  return resultsOf(study, identity, std::move(*found));
}

Expected<Results> mergeJobs(const std::vector<fs::path>& folders, const fs::path& out,
                            const std::function<std::optional<Study>(const Identity&)>& studyOf) {
  std::optional<Identity> identity;
  std::vector<Finished> all;
  const auto add = [&](std::vector<Finished> found) {
    for (Finished& one : found)
      if (std::ranges::find(all, one.job, &Finished::job) == all.end())
        all.push_back(std::move(one));
  };
  for (const fs::path& folder : folders) {
    auto found = jobsIn(folder, identity);
    if (!found) return tl::unexpected(found.error());
    if (found->empty())
      return tl::unexpected(Error{Error::Kind::NotFound,
                                  folder.string() + " holds no jobs of a study; name the folders "
                                                    "that --out was given.",
                                  "no-jobs"});
    add(std::move(*found));
  }
  // what is in `out` already belongs to the whole, or refuses it
  auto there = jobsIn(out, identity);
  if (!there) return tl::unexpected(there.error());
  add(std::move(*there));
  const std::optional<Study> study =
      identity && identity->build == app::buildHere() ? studyOf(*identity) : std::nullopt;
  if (!study)
    return tl::unexpected(Error{Error::Kind::Unsupported,
                                "These jobs were run by another build of Palpate; merge them with "
                                "the one that ran them.",
                                "other-build"});
  if (auto made = makeFolder(out); !made) return tl::unexpected(made.error());
  for (const Finished& one : all)
    if (auto written =
            haptics::writeFile(fileOf(out, one.job), jsonOf(*identity, one).dump(1) + "\n");
        !written)
      return tl::unexpected(written.error());
  return resultsOf(*study, *identity, std::move(all));
}

Expected<Results> runStudy(const Study& study, const RunOptions& options) {
  return written(runJobs(study, options), options.out);
}

Expected<Results> mergeStudies(
    const std::vector<fs::path>& folders, const fs::path& out,
    const std::function<std::optional<Study>(const Identity&)>& studyOf) {
  return written(mergeJobs(folders, out, studyOf), out);
}

}  // namespace study
