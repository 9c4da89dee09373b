// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace app {

/// The machine, as far as figures depend on it; no name of a user or host.
nlohmann::ordered_json machineHere();

/// What made a result: program, version, commit, build and SIMD target.
nlohmann::ordered_json madeBy(const std::string& program);

/// Palpate's version.
std::string versionHere();

/// The commit that this program was built from, twelve digits, with "-changed" behind it if sources
/// were changed since; "unknown" if the build did not know it.
std::string commitHere();

/// The linker's build identity, one word. Two programs with the same identity give the same
/// results.
std::string buildHere();

}  // namespace app
