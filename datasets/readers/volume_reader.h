// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Lists what lies at a path (a folder with all folders in it, an archive, or one file) with a
/// verdict for each series, from headers alone.
haptics::Expected<Survey> survey(const std::filesystem::path& path,
                                 const ReadProgress& progress = {});

/// Reads one entry of a survey. Anything but one evenly spaced, right-angled, single-component
/// stack is refused by name, and what is correctable too unless `reading` says to correct it; of
/// what lacks slices the largest part is read where it says so. What the free memory does not hold
/// is refused ("too-large"); a part of it may fit.
haptics::Expected<haptics::Volume> readVolume(const SeriesVerdict& chosen,
                                              const Reading& reading = {},
                                              const ReadProgress& progress = {});

/// Surveys a path and reads what it holds. One file of a DICOM series stands for its series.
/// Several loadable entries and none named are refused with the list (reason "which-series").
haptics::Expected<haptics::Volume> readVolume(const std::filesystem::path& path,
                                              const Reading& reading = {},
                                              const ReadProgress& progress = {});

/// Of the middle slice, at most `longest` pixels to a side.
haptics::Expected<Thumbnail> thumbnailOf(const SeriesVerdict& chosen, int longest);

/// The files that the scans at a path are read from, the path itself first: slices, headers, and
/// the voxels that lie beside a header. Of an archive, and of what cannot be read, the path alone.
std::vector<std::filesystem::path> filesReadFor(const std::filesystem::path& path,
                                                const ReadProgress& progress = {});

}  // namespace datasets
