// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/commands.h"

namespace app::study_program {

/// Adds a subcommand for each study, and `merge`.
void addStudies(CLI::App& program, cli::Chosen& chosen);
#ifdef PALPATE_READERS
/// Adds `cohort`.
void addCohort(CLI::App& program, cli::Chosen& chosen);
#endif

}  // namespace app::study_program
