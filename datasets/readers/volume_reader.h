// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Lists the series at a path (a folder with all folders in it, an archive, or one file), with a
/// verdict for each. It reads headers only. A file of segments is refused, unless `layers`: then it
/// lists them, as the volumes that they are stored in.
haptics::Expected<Survey> survey(const std::filesystem::path& path,
                                 const ReadProgress& progress = {}, bool layers = false);

/// Reads one entry of a survey. Only an evenly spaced, right-angled stack of scalars is accepted;
/// the error names the reason. `reading` can ask to correct a correctable stack, or to read the
/// largest part if slices are missing. A volume that exceeds the free memory is refused
/// ("too-large"); a part of it may fit.
haptics::Expected<haptics::Volume> readVolume(const SeriesVerdict& chosen,
                                              const Reading& reading = {},
                                              const ReadProgress& progress = {});

/// Surveys a path and reads its volume. One file of a DICOM series stands for its series. If
/// several entries can be loaded and none is named, refuses with the list (reason "which-series").
haptics::Expected<haptics::Volume> readVolume(const std::filesystem::path& path,
                                              const Reading& reading = {},
                                              const ReadProgress& progress = {});

/// Thumbnail of the middle slice, at most `longest` pixels per side.
haptics::Expected<Thumbnail> thumbnailOf(const SeriesVerdict& chosen, int longest);

/// The files that an entry is read from.
std::vector<std::filesystem::path> filesReadFor(const SeriesVerdict& chosen);
/// The files that the scans at a path are read from, the path itself first: slices, headers, and
/// the voxels that lie beside a header. For an archive, and for a path that cannot be read, only
/// the path.
std::vector<std::filesystem::path> filesReadFor(const std::filesystem::path& path,
                                                const ReadProgress& progress = {});

}  // namespace datasets
