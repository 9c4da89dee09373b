// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// The regular files in a folder and in all folders below it, sorted; links to folders are not
/// followed, and folders without permission or more than 32 deep are passed over. Refuses
/// ("too-large") more than 200,000 files.
haptics::Expected<std::vector<std::filesystem::path>> filesBelow(
    const std::filesystem::path& folder, const ReadProgress& progress);

}  // namespace datasets
