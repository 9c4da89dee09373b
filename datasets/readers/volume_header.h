// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

#include "datasets/readers/files/beginning.h"
#include "datasets/readers/files/file_stamp.h"
#include "datasets/readers/files/stored_volumes.h"
#include "datasets/readers/nrrd/voxels.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// What the header of a file of whole volumes says, parsed once for its verdicts and its voxels.
struct VolumeHeader {
  std::variant<StoredVolumes, std::shared_ptr<const ParsedNrrd>> parsed;
  std::vector<FileStamp> files;  ///< the header's, then those that hold the voxels

  const StoredVolumes& stored() const;
  /// Whether all files are as they were.
  bool isUpToDate() const;
  /// Whether the file holds one volume, whose voxels lie plain or deflated: what readDirectly()
  /// takes.
  bool isReadDirectly() const;
};

using HeaderPtr = std::shared_ptr<const VolumeHeader>;

/// A format that holds whole volumes: a row of the table in volume_header.cpp.
struct VolumeFormat {
  bool (*recognises)(const Beginning& file);
  haptics::Expected<HeaderPtr> (*header)(const std::filesystem::path& path);
};

/// The format of a file; null if it is none of them.
const VolumeFormat* formatOf(const Beginning& file);

/// Whether a file is in such a format.
bool isVolumeFile(const std::filesystem::path& path);

/// The header of a file. One in none of these formats is refused by the NRRD's parser, which says
/// why.
haptics::Expected<HeaderPtr> headerOf(const std::filesystem::path& path);

/// The volume of a header that isReadDirectly(), without VTK and teem. Any thread.
haptics::Expected<haptics::Volume> readDirectly(const VolumeHeader& header,
                                                const ReadProgress& progress);

}  // namespace datasets
