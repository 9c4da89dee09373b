// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/cohort/cohort.h"

#include <algorithm>
#include <cmath>

#include "app/study/cohort/pages.h"
#include "app/study/cohort/touch.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/process/output_file.h"

namespace cohort {
namespace {

namespace fs = std::filesystem;
using haptics::Error;
using haptics::Expected;

constexpr double kReadRate = 60e6;        // bytes a second, of voxels in memory: about
constexpr double kTouchRate = 0.1;        // s of a core for a simulated second, judged: about
constexpr double kLeastShard = 60.0;      // s
constexpr int kMostShards = 1000;         // clusters bound the size of an array
constexpr double kMemoryPerVoxels = 1.6;  // times the bytes of the voxels
constexpr std::int64_t kProgram_MB = 200;

double costOf(const Line& line) {
  return 2.0 + kTouchRate * line.touching.seconds * double(line.rows());
}

/// A name of the study that another manifest does not have.
std::string nameOf(const Manifest& manifest) { return "cohort-" + manifest.identity; }

/// The pictures of the folders, taken over.
Expected<void> copyPictures(const std::vector<fs::path>& folders, const fs::path& out) {
  std::error_code failed;
  fs::create_directories(out / "pictures", failed);
  for (const fs::path& folder : folders) {
    std::error_code absent;
    for (fs::directory_iterator entry(folder / "pictures", absent);
         !absent && entry != fs::directory_iterator{}; entry.increment(absent)) {
      const fs::path to = out / "pictures" / entry->path().filename();
      if (!entry->is_regular_file() || fs::exists(to)) continue;
      fs::copy_file(entry->path(), to, failed);
      if (failed)
        return tl::unexpected(Error{Error::Kind::Unsupported,
                                    to.string() + " cannot be written; choose another folder.",
                                    "unwritable"});
    }
  }
  return {};
}

/// No result replaces a scan or a recording, whatever links lie in the folder.
void keepInputs(const Manifest& manifest, const fs::path& out) {
  std::error_code failed;
  if (!fs::exists(out, failed) || fs::is_empty(out, failed)) return;  // nothing to replace
  for (const Line& line : manifest.lines) {
    haptics::keepInput(line.recording);
    for (const fs::path& file : datasets::filesReadFor(line.path)) haptics::keepInput(file);
  }
}

}  // namespace

study::Study studyOf(const Manifest& manifest, const fs::path& out,
                     const std::atomic<bool>& cancel) {
  study::Study study{nameOf(manifest), "Cohort"};
  for (const Line& line : manifest.lines)
    study.jobs.push_back({line.label, line.label, costOf(line), [&line, out, &cancel](auto) {
                            Touched touched = touch(line, cancel);
                            std::error_code failed;
                            fs::create_directories(out / "pictures", failed);
                            for (const SlicePicture& picture : touched.pictures) {
                              const std::string name = line.label + "_" + picture.plane + ".bmp";
                              if (!haptics::writeFile(out / "pictures" / name, picture.bitmap))
                                touched.outcome.remarks = {"its pictures could not be written"};
                            }
                            touched.outcome.whole = !cancel;
                            return std::move(touched.outcome);
                          }});
  return study;
}

Expected<Summary> run(const Manifest& manifest, const study::RunOptions& options,
                      const std::atomic<bool>& cancel) {
  keepInputs(manifest, options.out);
  const auto results = study::runJobs(studyOf(manifest, options.out, cancel), options);
  if (!results) return tl::unexpected(results.error());
  if (options.shard.count > 1 || cancel) {
    Summary summary;
    summary.lines = results->finished.size();
    for (const study::Finished& one : results->finished)
      for (const study::Case& c : one.outcome.cases) summary.failing += !c.pass();
    return summary;
  }
  return writeAll(*results, manifest, options.out, {});
}

Expected<Summary> merge(const Manifest& manifest, const std::vector<fs::path>& folders,
                        const fs::path& out, const fs::path& before) {
  keepInputs(manifest, out);
  const std::atomic<bool> never = false;
  const auto results = study::mergeJobs(folders, out, [&](const study::Identity& identity) {
    return identity.study == nameOf(manifest) ? std::optional{studyOf(manifest, out, never)}
                                              : std::nullopt;
  });
  if (!results)
    return tl::unexpected(
        results.error().reason == "other-build"
            ? Error{Error::Kind::Unsupported,
                    "These shards are of another manifest or another build of Palpate; merge them "
                    "with the manifest and the build that ran them.",
                    "other-build"}
            : results.error());
  if (auto copied = copyPictures(folders, out); !copied) return tl::unexpected(copied.error());
  return writeAll(*results, manifest, out, before);
}

Plan planOf(const Manifest& manifest) {
  Plan plan;
  plan.lines = manifest.lines.size();
  double largest = 0.0;
  for (const Line& line : manifest.lines) {
    plan.rows += line.rows();
    plan.seconds += costOf(line);
    const auto survey = datasets::survey(line.path);
    if (!survey) continue;  // its row will say why
    double bytes = 0.0;
    for (const datasets::SeriesVerdict& series : survey->series)
      if (!line.series || series.index == *line.series)
        bytes = std::max(bytes, double(series.bytes));
    plan.seconds += bytes / kReadRate;
    largest = std::max(largest, bytes);
  }
  plan.memory_MB = kProgram_MB + std::llround(kMemoryPerVoxels * largest / 1e6);
  plan.shards = static_cast<int>(
      std::clamp(std::floor(plan.seconds / kLeastShard), 1.0,
                 double(std::min<std::size_t>(kMostShards, std::max<std::size_t>(1, plan.lines)))));
  return plan;
}

}  // namespace cohort
