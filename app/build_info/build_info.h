// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace app {

/// What a program runs on, as far as figures depend on it; nothing that tells whose it is.
nlohmann::ordered_json machineHere();

/// Palpate's version.
std::string versionHere();

/// What this very program was built from and how, as one word: the linker's build identity. Two
/// programs with the same one give the same results.
std::string buildHere();

}  // namespace app
