// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/program.h"
#include "app/study/program/commands.h"

int main(int argc, char** argv) {
  using namespace app;
  // palpate-cli has the studies below a command
  const bool by_cli = argc > 0 && std::string_view(argv[0]) == cli::kCommandLine;
  return cli::runProgram(
      argc, argv, by_cli ? cli::kCommandLine : "palpate-study",
      "Measure Palpate: studies, and cohorts of many scans.\n"
      "Not a medical device, not for diagnosis.",
      [by_cli](CLI::App& program, cli::Chosen& chosen) {
#ifdef PALPATE_READERS
        study_program::addCohort(program, chosen);
#endif
        study_program::addStudies(
            by_cli ? *program.add_subcommand("study", cli::kStudyTitle) : program, chosen);
      });
}
