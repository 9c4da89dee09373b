// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "datasets/readers/found.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Whether a file is in a format that holds whole volumes: NRRD, MetaImage, NIfTI.
bool isVolumeFile(const std::filesystem::path& path);

/// A verdict for each volume of the file; a single refusal where nothing of it can be read.
std::vector<SeriesVerdict> verdictsOf(const std::filesystem::path& path);

/// The file, and those beside it that hold its voxels.
std::vector<std::filesystem::path> filesReadFor(const VolumeInFile& chosen);

haptics::Expected<haptics::Volume> readVolume(const VolumeInFile& chosen, const Part& part,
                                              const ReadProgress& progress);

/// Of the slice in the middle.
haptics::Expected<Thumbnail> thumbnailOf(const VolumeInFile& chosen, int longest);

}  // namespace datasets
