// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "datasets/readers/dicom_folder.h"
#include "datasets/readers/volume_file.h"

namespace datasets {

/// What stands behind an entry of a survey.
struct Found {
  std::variant<DicomSeries, VolumeInFile> source;
};

}  // namespace datasets
