// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cmath>
#include <exception>
#include <string_view>

#include "app/cli/commands.h"
#ifdef PALPATE_READERS
#include "datasets/readers/archive.h"
#endif

namespace {

/// --json is wanted even when the rest of the line cannot be parsed.
bool asksForJson(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::string_view(argv[i]) == "--json") return true;
  return false;
}

}  // namespace

namespace app::cli {

CLI::Validator finiteNumber() {
  return {[](std::string& text) {
            double value = 0.0;
            const char* end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            const bool number = error == std::errc{} && stop == end && std::isfinite(value);
            return number ? std::string{} : "\"" + text + "\" is not a number";
          },
          "NUMBER"};
}

CLI::Validator notEmpty() {
  return {[](std::string& text) { return text.empty() ? std::string{"is empty"} : std::string{}; },
          "TEXT"};
}

}  // namespace app::cli

int main(int argc, char** argv) {
  using namespace app::cli;
  CLI::App program{
      "Palpate without a window: what a scan is, what a tool is, and how one feels the other.\n"
      "Not a medical device, not for diagnosis.",
      "palpate-cli"};
  program.require_subcommand(1);
  Chosen chosen;
#ifdef PALPATE_READERS
  addInfo(program, chosen);
  addConvert(program, chosen);
#endif
#ifdef PALPATE_DEVICES
  addDevices(program, chosen);
#endif
  addTool(program, chosen);
  addRun(program, chosen);
  addReplay(program, chosen);
  addRecover(program, chosen);
  addExport(program, chosen);
  addStudy(program, chosen);
  bool json = asksForJson(argc, argv);
  for (CLI::App* command : program.get_subcommands({})) {
    const auto leaves = command->get_subcommands({});
    for (CLI::App* leaf : leaves.empty() ? std::vector{command} : leaves)
      leaf->add_flag("--json", json, "Print one JSON object and nothing else");
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return print(usage(std::string{error.what()} + " (palpate-cli --help tells more)"), json);
  }
  watchForInterrupts();
#ifdef PALPATE_READERS
  datasets::sweepTemporaryFolders();
#endif
  try {
    return print(chosen(), json);
  } catch (const std::exception&) {
    // libraries may throw where memory ends; there is nothing better to say of it
    return print({Exit::Failed, {}, {}, "Palpate ran out of memory; try a smaller volume."}, json);
  }
}
