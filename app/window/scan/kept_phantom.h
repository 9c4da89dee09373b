// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "datasets/phantoms/phantoms.h"

namespace app {

/// The file of the user's cache in which the phantom "demo" is kept. Making it takes a second or
/// more; reading it takes some hundredths.
std::filesystem::path fileOfDemo();

/// The phantom that keepPhantom() wrote to `file` for the same build (see buildHere()); nullopt if
/// there is none, or if it is damaged. Any thread.
std::optional<datasets::Phantom> keptPhantom(const std::filesystem::path& file,
                                             const std::string& build);

/// Writes the phantom to `file`, whole or not at all, in place of what was there. What cannot be
/// written is not kept. Any thread.
void keepPhantom(const std::filesystem::path& file, const std::string& build,
                 const datasets::Phantom& phantom);

}  // namespace app
