// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <variant>

#include "datasets/readers/dicom/folder.h"

namespace datasets {

/// One of the volumes that a file of whole volumes holds.
struct VolumeInFile {
  std::filesystem::path path;
  int number = 0;  ///< from 0
};

/// What stands behind an entry of a survey.
struct Found {
  std::variant<DicomSeries, VolumeInFile> source;
};

}  // namespace datasets
