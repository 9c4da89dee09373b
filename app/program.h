// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "app/read_ahead.h"

/// The program with the window, in a library that main.cpp loads: Qt, VTK and what else it links
/// take longer to load than a small scan takes to read. `ahead` reads a file meanwhile; null: none.
/// Returns the exit status.
extern "C" [[gnu::visibility("default")]] int palpateProgram(int argc, char** argv,
                                                             std::shared_ptr<app::ReadAhead> ahead);
