// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "haptics/core/error.h"

namespace datasets {

/// The file that a header names for its voxels. Refuses ("outside-folder") all but plain files
/// below the header's own folder, whatever links lie on the way, and what is not there
/// ("truncated"). Folders in the name may be parted as on Windows.
haptics::Expected<std::filesystem::path> dataFileOf(const std::filesystem::path& header,
                                                    const std::string& name);

}  // namespace datasets
