// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "app/cli/options.h"
#include "app/cli/outcome.h"

namespace app::cli {

/// Each function adds its subcommand to the program. If the user names the subcommand, it sets
/// `chosen` to the function to run.
using Chosen = std::function<Outcome()>;
void addTool(CLI::App& program, Chosen& chosen);
void addRun(CLI::App& program, Chosen& chosen);
void addSurface(CLI::App& program, Chosen& chosen);
void addExport(CLI::App& program, Chosen& chosen);
void addReplay(CLI::App& program, Chosen& chosen);
void addRecover(CLI::App& program, Chosen& chosen);
#ifdef PALPATE_READERS
void addInfo(CLI::App& program, Chosen& chosen);
void addConvert(CLI::App& program, Chosen& chosen);
void addReport(CLI::App& program, Chosen& chosen);
#endif
#ifdef PALPATE_DEVICES
void addDevices(CLI::App& program, Chosen& chosen);
#endif

}  // namespace app::cli
