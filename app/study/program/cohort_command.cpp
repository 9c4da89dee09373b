// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/cli/interrupts.h"
#include "app/cli/program.h"
#include "app/cli/terminal.h"
#include "app/study/cohort/cohort.h"
#include "app/study/program/commands.h"
#include "haptics/process/input_file.h"
#include "haptics/process/output_file.h"
#include "haptics/settings.h"
#include "resources/named_tools.h"

extern char** environ;

namespace app::study_program {
namespace {

using namespace app::cli;

struct CohortOptions {
  std::string manifest, out;
  cohort::Touching touching;
  std::string tool = {}, hand = "tap,slide";  ///< no tool: the mesh, or the drill
  std::string shard = "1/1";
  int jobs = 1;
  bool plan = false;
};

/// The words of a list parted by commas.
std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

Outcome outcomeOf(const haptics::Expected<cohort::Summary>& summary, const std::string& out,
                  bool part) {
  if (!summary) return refused(summary.error());
  Outcome outcome;
  outcome.json["lines"] = summary->lines;
  outcome.json["failing"] = summary->failing;
  outcome.text = std::to_string(summary->lines) + " scans";
  if (part) {
    outcome.text += " done in " + out + ". Join the shards with `palpate-cli cohort merge`.\n";
  } else {
    outcome.json["rows"] = summary->rows;
    outcome.json["refused"] = summary->refused;
    outcome.json["differing"] = summary->differing;
    outcome.json["missing"] = summary->missing;
    outcome.text += ", " + std::to_string(summary->rows) + " touches and replays, " +
                    std::to_string(summary->refused) + " refused, " +
                    std::to_string(summary->missing.size()) + " scans missing. See " + out +
                    "/index.html.\n";
  }
  if (interrupted()) {
    outcome.code = Exit::Interrupted;
    outcome.error = "Stopped; finished work is kept, and the same command continues it.";
  } else if (summary->failing > 0 || summary->differing > 0) {
    outcome.code = Exit::Failed;
    outcome.error = "In " + std::to_string(summary->failing) +
                    " touches the proxy entered the surface or a number was not finite, and " +
                    std::to_string(summary->differing) + " replays differ; the page names them.";
  } else if (!summary->missing.empty()) {
    std::string names;
    for (std::size_t n = 0; n < std::min<std::size_t>(5, summary->missing.size()); ++n)
      names += (n > 0 ? ", " : "") + summary->missing[n];
    outcome.code = Exit::Failed;
    outcome.error = std::to_string(summary->missing.size()) + " scans were not run yet (" + names +
                    (summary->missing.size() > 5 ? ", …" : "") +
                    "); run their shards and merge again.";
  }
  return outcome;
}

/// Runs the shards 1/n to n/n of the same command side by side. False where one was refused or
/// ended by a signal; its own words are on standard error then.
bool runBeside(const CohortOptions& options, const std::vector<std::string>& command) {
  std::vector<pid_t> children;
  for (int n = 1; n <= options.jobs; ++n) {
    std::vector<std::string> words = command;
    words.insert(words.end(),
                 {"--shard", std::to_string(n) + "/" + std::to_string(options.jobs), "--json"});
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    // what they answer is not ours to print; what they tell is
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    if (posix_spawn(&child, "/proc/self/exe", &actions, nullptr, arguments.data(), environ) == 0)
      children.push_back(child);
    posix_spawn_file_actions_destroy(&actions);
  }
  bool well = static_cast<int>(children.size()) == options.jobs;
  bool told = false;
  while (!children.empty()) {
    if (interrupted() && !told) {
      told = true;
      for (const pid_t child : children) kill(child, SIGTERM);
    }
    std::erase_if(children, [&](pid_t child) {
      int status = 0;
      if (waitpid(child, &status, WNOHANG) != child) return false;
      const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
      well = well && (code == int(Exit::Done) || code == int(Exit::Failed));
      return true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
  }
  return well;
}

/// Tools, hands and mesh as the touching has them; what is wrong with them.
std::optional<Outcome> settle(CohortOptions& options) {
  cohort::Touching& touching = options.touching;
  if (options.tool.empty()) options.tool = touching.mesh.empty() ? "drill" : cohort::kOwnMesh;
  touching.tools = listed(options.tool);
  touching.hands = listed(options.hand);
  const auto unknown = [](const std::string& name, const std::string& known) {
    return usage("There is no \"" + name + "\"; choose one of " + known + ".");
  };
  for (const std::string& tool : touching.tools)
    if (resources::findNamedTool(tool) == nullptr &&
        (tool != cohort::kOwnMesh || touching.mesh.empty()))
      return unknown(tool, resources::namesOfTools() + ", or mesh with --tool-mesh");
  for (const std::string& hand : touching.hands)
    if (std::ranges::find(cohort::handNames(), hand) == cohort::handNames().end()) {
      std::string names;
      for (const std::string& name : cohort::handNames())
        names += (names.empty() ? "" : ", ") + name;
      return unknown(hand, names);
    }
  if (touching.mesh.empty()) return {};
  constexpr std::uintmax_t kLargestMesh = std::uintmax_t{1} << 30;  // bytes
  haptics::keepInput(touching.mesh);
  const auto bytes = haptics::readInput(touching.mesh, kLargestMesh);
  if (!bytes) return refused(bytes.error());
  touching.mesh_hash = 14695981039346656037ULL;  // FNV-1a
  for (const char c : *bytes + touching.mesh_unit)
    touching.mesh_hash = (touching.mesh_hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return {};
}

Outcome run(CohortOptions options) {
  if (const auto wrong = settle(options)) return *wrong;
  if (options.out.empty() && !options.plan) return usage("cohort needs a folder for its results.");
  const auto shard = study::shardOf(options.shard);
  if (!shard) return usage("--shard \"" + options.shard + "\" is not i/n with i from 1 to n.");
  if (options.jobs > 1 && shard->count > 1)
    return usage("--jobs splits the work by itself; leave out --shard.");
  const auto manifest = cohort::readManifest(options.manifest, options.touching);
  if (!manifest) return refused(manifest.error());
  if (options.plan) {
    const cohort::Plan plan = cohort::planOf(*manifest);
    Outcome outcome;
    outcome.json = {{"lines", plan.lines},
                    {"rows", plan.rows},
                    {"shards", plan.shards},
                    {"memory_MB", plan.memory_MB},
                    {"seconds", std::llround(plan.seconds)}};
    return outcome;
  }
  study::RunOptions how{study::Depth::Full, 1, *shard, options.out};
  how.stop = [] { return interrupted(); };
  how.tell = [](const std::string& line) { tell(line); };
  const Closing held;
  if (options.jobs > 1) {
    const auto number = [](double value) { return nlohmann::json(value).dump(); };
    const cohort::Touching& how_touched = options.touching;
    std::vector<std::string> command{"palpate-cli",
                                     "cohort",
                                     options.manifest,
                                     options.out,
                                     "--isovalue",
                                     options.touching.isovalue,
                                     "--tool",
                                     options.tool,
                                     "--hand",
                                     options.hand,
                                     "--repetitions",
                                     std::to_string(options.touching.repetitions),
                                     "--seconds",
                                     nlohmann::json(options.touching.seconds).dump(),
                                     "--stiffness",
                                     number(how_touched.stiffness),
                                     "--angular-stiffness",
                                     number(how_touched.angular_stiffness),
                                     "--friction",
                                     number(how_touched.friction),
                                     "--field",
                                     how_touched.field,
                                     "--normals",
                                     how_touched.normals,
                                     "--epsilon",
                                     number(how_touched.fineness.epsilon),
                                     "--sub-steps",
                                     std::to_string(how_touched.fineness.sub_steps),
                                     "--rate",
                                     std::to_string(how_touched.rate.hz),
                                     "--seed",
                                     std::to_string(how_touched.seed),
                                     "--tool-unit",
                                     how_touched.mesh_unit};
    if (how_touched.budget_us > 0)
      command.insert(command.end(), {"--budget", std::to_string(how_touched.budget_us)});
    if (!how_touched.mesh.empty())
      command.insert(command.end(), {"--tool-mesh", how_touched.mesh.string()});
    if (!runBeside(options, command) && !interrupted())
      return failed("A part of the cohort could not be run; the lines above say why.");
  }
  return outcomeOf(cohort::run(*manifest, how, interruption()), options.out, shard->count > 1);
}

struct MergeOptions {
  CohortOptions cohort;
  std::vector<std::string> folders;
  std::string before;
};

Outcome merge(MergeOptions options) {
  if (const auto wrong = settle(options.cohort)) return *wrong;
  const auto manifest = cohort::readManifest(options.cohort.manifest, options.cohort.touching);
  if (!manifest) return refused(manifest.error());
  return outcomeOf(cohort::merge(*manifest, {options.folders.begin(), options.folders.end()},
                                 options.cohort.out, options.before),
                   options.cohort.out, false);
}

/// How scans are touched where the manifest does not say so.
void addTouching(CLI::App& command, CohortOptions& options) {
  command
      .add_option("--isovalue", options.touching.isovalue,
                  "A number, or bone or skin of a scan in HU")
      ->check(CLI::IsMember({"bone", "skin"}) | finiteNumber());
  command.add_option("--tool", options.tool, "Named tools, parted by commas")->check(notEmpty());
  command.add_option("--hand", options.hand, "Simulated hands, parted by commas")
      ->check(notEmpty());
  command.add_option("--repetitions", options.touching.repetitions, "Each with another aim")
      ->check(wholeNumber(1, 10'000));
  command.add_option("--seconds", options.touching.seconds, "Length of each touch [s]")
      ->check(finiteNumber() & CLI::Range(0.001, 3600.0));
  command
      .add_option("--stiffness", options.touching.stiffness,
                  "Stiffness of the virtual coupling [N/m]")
      ->check(finiteNumber() &
              CLI::Range(haptics::kStiffnessRange.least, haptics::kStiffnessRange.most));
  command
      .add_option("--angular-stiffness", options.touching.angular_stiffness,
                  "Instead of stiffness times the tool's inertia [N·m/rad]")
      ->check(finiteNumber() & CLI::Range(haptics::kAngularStiffnessRange.least,
                                          haptics::kAngularStiffnessRange.most));
  command
      .add_option("--friction", options.touching.friction,
                  "Coulomb's coefficient between tool and surface")
      ->check(finiteNumber() &
              CLI::Range(haptics::kFrictionRange.least, haptics::kFrictionRange.most));
  command
      .add_option("--field", options.touching.field, "How voxels become a field: trilinear, spline")
      ->check(CLI::IsMember({"trilinear", "spline"}));
  command
      .add_option("--normals", options.touching.normals,
                  "Normals of points near the surface: central, cell, spline")
      ->check(CLI::IsMember({"central", "cell", "spline"}));
  command
      .add_option("--epsilon", options.touching.fineness.epsilon,
                  "Distance that counts as contact, in voxels")
      ->check(finiteNumber() & CLI::Range(0.001, 0.999));
  command
      .add_option("--sub-steps", options.touching.fineness.sub_steps,
                  "Most motions in a millisecond that contacts shape or stop")
      ->check(wholeNumber(1, 1000));
  command
      .add_option("--budget", options.touching.budget_us,
                  "What a tick may spend, counted: 100 units of work for each us")
      ->check(wholeNumber(1, 1'000'000));
  command
      .add_option("--rate", options.touching.rate.hz, "Ticks of the servo loop in a second [Hz]")
      ->check(CLI::IsMember({1000, 2000, 4000}));
  command
      .add_option("--seed", options.touching.seed,
                  "Added to the number of the repetition, the seed of the hand's aim")
      ->check(wholeNumber(0, 1'000'000'000));
  command
      .add_option("--tool-mesh", options.touching.mesh,
                  "A mesh of your own, which is the tool called mesh")
      ->check(notEmpty());
  command.add_option("--tool-unit", options.touching.mesh_unit, "Unit of --tool-mesh")
      ->check(CLI::IsMember({"m", "mm", "cm", "in"}));
}

}  // namespace

void addCohort(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<CohortOptions>();
  CLI::App* command = program.add_subcommand("cohort", kCohortTitle);
  command->add_option("manifest", options->manifest, "TSV of scans, or a BIDS folder");
  command->add_option("out", options->out, "Folder for tables and pages");
  addTouching(*command, *options);
  command->add_option("--shard", options->shard, "i/n: run only the i-th of n equal parts")
      ->check(notEmpty());
  command->add_option("--jobs", options->jobs, "Parts to run side by side")
      ->check(wholeNumber(1, 256));
  command->add_flag("--plan", options->plan,
                    "Run nothing; say how many shards and how much memory are needed");
  command->require_subcommand(0, 1);
  auto joining = std::make_shared<MergeOptions>();
  CLI::App* merging = command->add_subcommand("merge", "Join the shards of a cohort");
  merging->add_option("manifest", joining->cohort.manifest, "The manifest of the shards")
      ->required()
      ->check(notEmpty());
  merging->add_option("folders", joining->folders, "The folder of each shard")
      ->required()
      ->check(CLI::ExistingDirectory);
  merging->add_option("--out", joining->cohort.out, "Folder for tables and pages")
      ->required()
      ->check(notEmpty());
  merging->add_option("--before", joining->before, "Folder of an earlier cohort, to compare with")
      ->check(CLI::ExistingDirectory);
  addTouching(*merging, joining->cohort);
  merging->callback([joining, &chosen] { chosen = [joining] { return merge(*joining); }; });
  command->callback([command, options, &chosen] {
    if (!command->get_subcommands().empty()) return;
    if (options->manifest.empty()) throw CLI::RequiredError("manifest");
    chosen = [options] { return run(*options); };
  });
}

}  // namespace app::study_program
