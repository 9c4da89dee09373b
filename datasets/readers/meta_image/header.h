// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "datasets/readers/files/beginning.h"
#include "datasets/readers/files/stored_volumes.h"
#include "haptics/core/error.h"

namespace datasets {

/// Whether a file is named or begins as a MetaImage: .mhd, .mha.
bool looksLikeMetaImage(const Beginning& file);

/// Reads and checks the header of a MetaImage, whose world is LPS in millimetres. The rows of
/// TransformMatrix are the directions of the axes. Left and right are unknown where there is no
/// such matrix, and where AnatomicalOrientation says so itself ("???"); letters in it alone are not
/// trusted, since the format's description and its writers take them to mean opposite things.
/// Refuses colours ("not-scalar"), text and voxels in several files ("unsupported-syntax"), a data
/// file outside the header's folder ("outside-folder") and what it cannot hold ("truncated").
haptics::Expected<StoredVolumes> describeMetaImage(const std::filesystem::path& path);

}  // namespace datasets
