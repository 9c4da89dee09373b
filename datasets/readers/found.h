// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <variant>

#include "datasets/readers/dicom/folder.h"

namespace datasets {

struct VolumeHeader;  // volume_file.h

/// One of the volumes that a file of whole volumes holds.
struct VolumeInFile {
  std::filesystem::path path;
  int number = 0;  ///< from 0
  /// What the file's header says; null where it cannot be read.
  std::shared_ptr<const VolumeHeader> header = {};
};

/// What stands behind an entry of a survey.
struct Found {
  std::variant<DicomSeries, VolumeInFile> source;
};

}  // namespace datasets
