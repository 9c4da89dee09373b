// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace haptics {

/// Where a program lies that Palpate's programs start for a part of their work: beside the running
/// program, as in a build folder, or else in the folder for such programs of the same installation.
/// That folder is found from the running program's own, so an installation may be moved as a whole.
/// Empty if there is none. Any thread but the servo's: it looks at the disk.
std::filesystem::path helperProgram(std::string_view name);

}  // namespace haptics
