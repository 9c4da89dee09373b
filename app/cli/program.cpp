// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/program.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <system_error>

#include "app/build_info/build_info.h"
#include "app/cli/interrupts.h"
#include "app/cli/terminal.h"
#include "haptics/process/helper_program.h"
#include "haptics/process/process_limits.h"
#include "haptics/servo/emergency.h"
#ifdef PALPATE_READERS
#include "app/recording/volume_hash.h"
#include "datasets/readers/files/archive.h"
#endif

namespace app::cli {
namespace {

/// --json is wanted even when the rest of the line cannot be parsed.
bool asksForJson(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::string_view(argv[i]) == "--json") return true;
  return false;
}

/// A sentence for a line that cannot be parsed.
std::string sentenceOf(const CLI::ParseError& error, const CLI::App& program) {
  const CLI::App* command = &program;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const auto choices = command->get_subcommands([](const CLI::App*) { return true; });
  const std::vector<std::string> left = command->remaining();
  const auto named =
      std::ranges::find_if(left, [](const std::string& word) { return !word.starts_with('-'); });
  std::string sentence = error.what();
  if (!choices.empty() && named != left.end()) {
    sentence = "There is no command \"" + *named + "\"; choose one of ";
    for (const CLI::App* choice : choices)
      sentence += (choice == choices.front() ? "" : ", ") + choice->get_name();
  }
  return sentence + " (see " + program.get_name() + " --help).";
}

constexpr const char* kNoThread =
    "The system has no thread or no memory left for this; close other programs and try again.";

}  // namespace

std::string_view firstWord(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (argv[i][0] != '-') return argv[i];
  return {};
}

void becomeProgram(const char* program, char** argv) {
  const std::filesystem::path path = haptics::helperProgram(program);
  if (!path.empty()) ::execv(path.c_str(), argv);
}

int runProgram(int argc, char** argv, const std::string& name, const std::string& description,
               const std::function<void(CLI::App&, Chosen&)>& add) try {
  // a sanitizer has handlers of its own
  if constexpr (!haptics::kSanitized) haptics::installCrashStop();
  haptics::forbidCoreDumps();  // a scan lies in memory
  openStandardStreams();
#ifdef PALPATE_READERS
  nameApplication();
#endif
  bool json = asksForJson(argc, argv);
  const Interrupts interrupts{json};
  CLI::App program{description, name};
  program.set_version_flag("--version", versionHere());
  program.require_subcommand(1);
  Chosen chosen;
  add(program, chosen);
  for (CLI::App* command : program.get_subcommands({})) {
    auto answering = command->get_subcommands({});
    if (command->get_require_subcommand_min() == 0) answering.push_back(command);
    for (CLI::App* one : answering)
      one->add_flag("--json", json, "Print one JSON object and nothing else");
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    program.exit(help);
    std::cout.flush();
    return static_cast<int>(std::cout ? Exit::Done : Exit::Failed);
  } catch (const CLI::ParseError& error) {
    return print(usage(sentenceOf(error, program)), json);
  }
#ifdef PALPATE_READERS
  datasets::sweepTemporaryFolders();
#endif
  try {
    return print(chosen(), json);
  } catch (const std::system_error&) {
    return print(failed(kNoThread), json);
  } catch (const std::exception&) {
    // libraries may throw where memory ends; there is nothing better to say of it
    return print(failed("Palpate ran out of memory; try a smaller volume."), json);
  }
} catch (const std::exception&) {  // before a command began
  std::fprintf(stderr, "%s\n", kNoThread);
  return static_cast<int>(Exit::Failed);
}

}  // namespace app::cli
