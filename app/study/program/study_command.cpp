// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <memory>

#include "app/cli/interrupts.h"
#include "app/cli/program.h"
#include "app/cli/terminal.h"
#include "app/study/program/commands.h"
#include "app/study/report/run_study.h"
#include "app/study/studies.h"

namespace app::study_program {
namespace {

using namespace app::cli;

struct StudyOptions {
  bool quick = false;
  std::uint64_t seed = 1;
  std::string shard = "1/1";
  std::string out;
};

std::string sentenceOf(const study::Results& results) {
  const std::vector<study::Case> cases = results.cases();
  const auto failing =
      std::count_if(cases.begin(), cases.end(), [](const study::Case& c) { return !c.pass(); });
  std::string text = std::to_string(results.finished.size()) + " of " +
                     std::to_string(results.jobs.size()) + " jobs done; " +
                     std::to_string(cases.size() - static_cast<std::size_t>(failing)) + " of " +
                     std::to_string(cases.size()) + " cases hold.\n";
  for (const study::Case& c : cases)
    if (!c.pass())
      text += "  does not hold: " + c.name + ": " + study::shortly(c.value) + " " + c.unit + ", " +
              (c.sense == study::Case::Sense::AtMost ? "at most " : "at least ") +
              study::shortly(c.bound) + "\n";
  return text;
}

Outcome outcomeOf(const haptics::Expected<study::Results>& results, const std::string& out) {
  if (!results) return refused(results.error());
  Outcome outcome;
  std::size_t failing = 0;
  outcome.json["study"] = results->identity.study;
  outcome.json["jobs"] = results->jobs.size();
  outcome.json["missing"] = results->missing();
  outcome.json["cases"] = study::jsonOf(*results)["cases"];
  for (const study::Case& c : results->cases()) failing += !c.pass();
  outcome.json["failing"] = failing;
  outcome.text = sentenceOf(*results) + "See " + out + "/report.html.\n";
  if (failing > 0) {
    outcome.code = Exit::Failed;
    outcome.error = std::to_string(failing) + " cases do not hold; the report names them.";
  }
  if (interrupted()) {
    outcome.code = Exit::Interrupted;
    outcome.error = "Stopped; finished work is kept, and the same command continues it.";
  }
  return outcome;
}

Outcome run(const std::string& name, const StudyOptions& options) {
  const auto depth = options.quick ? study::Depth::Quick : study::Depth::Full;
  const auto shard = study::shardOf(options.shard);
  if (!shard) return usage("--shard \"" + options.shard + "\" is not i/n with i from 1 to n.");
  study::RunOptions how{depth, options.seed, *shard, options.out};
  how.stop = [] { return interrupted(); };
  how.tell = [](const std::string& line) { tell(line); };
  const Closing held;
  return outcomeOf(study::runStudy(*study::makeStudy(name, depth), how), options.out);
}

Outcome merge(const std::vector<std::string>& folders, const std::string& out) {
  const auto results = study::mergeStudies(
      {folders.begin(), folders.end()}, out, [](const study::Identity& identity) {
        return study::makeStudy(identity.study, identity.depth);
      });
  Outcome outcome = outcomeOf(results, out);
  // part of a study is not the study, even if all that was run holds
  if (results && outcome.code == Exit::Done && !results->missing().empty()) {
    outcome.code = Exit::Failed;
    outcome.error = std::to_string(results->missing().size()) + " of " +
                    std::to_string(results->jobs.size()) +
                    " jobs were not run yet; run their shards and merge again.";
  }
  return outcome;
}

}  // namespace

void addStudies(CLI::App& program, Chosen& chosen) {
  program.require_subcommand(1);
  for (const std::string& name : study::studyNames()) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* one =
        program.add_subcommand(name, study::makeStudy(name, study::Depth::Quick)->title);
    one->add_flag("--quick", options->quick,
                  "About a minute; the full form takes 2 (plan) to 90 minutes (accuracy)");
    one->add_option("--seed", options->seed, "Seed of all random numbers")
        ->check(wholeNumber(0, std::numeric_limits<std::uint64_t>::max()));
    one->add_option("--shard", options->shard, "i/n: run only the i-th of n equal parts")
        ->check(notEmpty());
    one->add_option("--out", options->out, "Folder for report.html, results.json and results.csv")
        ->required()
        ->check(notEmpty());
    one->callback(
        [name, options, &chosen] { chosen = [name, options] { return run(name, *options); }; });
  }
  auto folders = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>();
  CLI::App* merging = program.add_subcommand("merge", "Merge the shards of a study");
  merging->add_option("folders", *folders, "The --out folder of each shard")
      ->required()
      ->check(CLI::ExistingDirectory);
  merging->add_option("--out", *out, "Folder for the merged study")->required()->check(notEmpty());
  merging->callback(
      [folders, out, &chosen] { chosen = [folders, out] { return merge(*folders, *out); }; });
}

}  // namespace app::study_program
