// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace app {

/// The machine, as far as figures depend on it; no name of a user or host.
nlohmann::ordered_json machineHere();

/// Palpate's version.
std::string versionHere();

/// The linker's build identity, one word. Two programs with the same identity give the same
/// results.
std::string buildHere();

}  // namespace app
