// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "datasets/readers/found.h"
#include "datasets/readers/scan.h"
#include "datasets/readers/volume_header.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// A verdict for each volume of a file in such a format; a single refusal where nothing of it can
/// be read.
std::vector<SeriesVerdict> verdictsOf(const std::filesystem::path& path,
                                      const VolumeFormat& format);

/// The file, and those beside it that hold its voxels.
std::vector<std::filesystem::path> filesReadFor(const VolumeInFile& chosen);

/// The header is parsed again where a file has changed since the survey.
haptics::Expected<haptics::Volume> readVolume(const VolumeInFile& chosen, const Part& part,
                                              const ReadProgress& progress);

/// Of the slice in the middle.
haptics::Expected<Thumbnail> thumbnailOf(const VolumeInFile& chosen, int longest);

}  // namespace datasets
