// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <variant>

#include "datasets/readers/dicom/folder.h"

namespace datasets {

struct VolumeHeader;  // volume_header.h

/// One volume of a file of whole volumes.
struct VolumeInFile {
  std::filesystem::path path;
  int number = 0;  ///< from 0
  /// The file's header; null if it cannot be read.
  std::shared_ptr<const VolumeHeader> header = {};
};

/// What `readVolume` needs of an entry of a survey.
struct Found {
  std::variant<DicomSeries, VolumeInFile> source;
};

}  // namespace datasets
