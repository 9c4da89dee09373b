// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "datasets/readers/dicom_series.h"
#include "haptics/core/error.h"

namespace datasets {

/// What one DICOM file says of itself. Identifiers serve to group files and are never shown.
struct DicomFile {
  std::filesystem::path path;
  std::string series;    ///< SeriesInstanceUID
  std::string instance;  ///< SOPInstanceUID
  int series_number = 0;
  std::string modality;
  SlicePlane plane;
  int bits_allocated = 0;
  int bits_stored = 0;
  bool is_signed = false;
  bool rescaled = false;  ///< slope and intercept are stated
  double slope = 1.0;
  double intercept = 0.0;
  bool hounsfield = false;  ///< CT, rescaled, and the file says or implies HU
  /// Why this file cannot be a slice, if it cannot.
  std::optional<haptics::Error> fault;
};

/// Whether a file looks like DICOM: the mark after a preamble, or a first element that fits.
bool looksLikeDicom(const std::filesystem::path& path);

/// Reads one header. Empty for what is no image and no part of a series: a folder's index.
std::optional<DicomFile> readDicomHeader(const std::filesystem::path& path);

}  // namespace datasets
