// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

#include "datasets/readers/files/beginning.h"
#include "datasets/readers/files/file_stamp.h"
#include "datasets/readers/files/stored_volumes.h"
#include "datasets/readers/found.h"
#include "datasets/readers/nrrd/voxels.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// A format that holds whole volumes: a row of the table in volume_file.cpp.
struct VolumeFormat;
/// The format of a file; null if it is none of them.
const VolumeFormat* formatOf(const Beginning& file);

/// Whether a file is in such a format.
bool isVolumeFile(const std::filesystem::path& path);

/// What the header of a file of whole volumes says, parsed once for its verdicts and its voxels.
struct VolumeHeader {
  std::variant<StoredVolumes, std::shared_ptr<const ParsedNrrd>> parsed;
  std::vector<FileStamp> files;  ///< the header's, then those that hold the voxels

  const StoredVolumes& stored() const;
  /// Whether all files are as they were.
  bool isUpToDate() const;
};

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
