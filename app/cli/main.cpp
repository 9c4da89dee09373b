// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/commands.h"
#include "app/cli/program.h"

namespace {

using namespace app::cli;

constexpr const char* kNoStudies =
    "Studies and cohorts are run by palpate-study, which was not found; build the target "
    "palpate-study, or install Palpate anew.";

/// Commands that another program has take its place here, where it is installed.
void handOver(int argc, char** argv) {
  const std::string_view command = firstWord(argc, argv);
#ifndef PALPATE_FILM
  // the same program with what films need: the window's libraries
  if (command == "export") becomeProgram("palpate-draw", argv);
#endif
  bool studies = command == "study";
#ifdef PALPATE_READERS
  studies = studies || command == "cohort";
#endif
  if (!studies) return;
  static char name[] = "palpate-cli";
  argv[0] = name;
  becomeProgram("palpate-study", argv);
}

/// A command of palpate-study. It runs here only if that program is missing.
void addMissing(CLI::App& program, Chosen& chosen, const char* name, const char* title) {
  CLI::App* command = program.add_subcommand(name, title);
  command->set_help_flag();
  command->allow_extras();
  command->callback([&chosen] { chosen = [] { return failed(kNoStudies); }; });
}

void addCommands(CLI::App& program, Chosen& chosen) {
#ifdef PALPATE_READERS
  addInfo(program, chosen);
  addConvert(program, chosen);
  addMissing(program, chosen, "cohort", kCohortTitle);
#endif
#ifdef PALPATE_DEVICES
  addDevices(program, chosen);
#endif
  addTool(program, chosen);
  addRun(program, chosen);
  addReplay(program, chosen);
  addRecover(program, chosen);
#ifdef PALPATE_READERS
  addReport(program, chosen);
#endif
  addSurface(program, chosen);
  addExport(program, chosen);
  addMissing(program, chosen, "study", kStudyTitle);
}

}  // namespace

int main(int argc, char** argv) {
  handOver(argc, argv);
  return runProgram(
      argc, argv, kCommandLine,
      "Palpate without a window: describe scans and tools, and touch scans with tools.\n"
      "Not a medical device, not for diagnosis.",
      addCommands);
}
