// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/cli/commands.h"

namespace app::cli {

/// Commands that palpate-cli starts palpate-study for.
inline constexpr char kStudyTitle[] = "Measure error against run time, stability, or the plan";
inline constexpr char kCohortTitle[] = "Touch many scans, and report on all of them";

/// What palpate-cli puts in place of its path when it starts another program.
inline constexpr char kCommandLine[] = "palpate-cli";

/// The first word of the line that is no option; empty if there is none.
std::string_view firstWord(int argc, char** argv);

/// Replaces this process by another program of the installation, which reads the same line.
/// Returns if that program is missing.
void becomeProgram(const char* program, char** argv);

/// Runs a program of commands: `add` adds them, and the one that the line names is done. Returns
/// the exit code.
int runProgram(int argc, char** argv, const std::string& name, const std::string& description,
               const std::function<void(CLI::App&, Chosen&)>& add);

}  // namespace app::cli
