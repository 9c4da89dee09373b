// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

class vtkDICOMMetaData;

namespace datasets {

/// Who was scanned, and by which origin places are counted, as far as DICOM states it. Compared,
/// never shown.
struct ScanIdentity {
  std::string patient_id, patient_name;       ///< empty: not stated
  std::set<std::string> frames_of_reference;  ///< empty: not stated
};

/// Of an entry of a survey; nothing is stated by a file of whole volumes.
ScanIdentity identityOf(const SeriesVerdict& scan);
/// What the root of a DICOM object states.
ScanIdentity identityOf(vtkDICOMMetaData* meta);

/// Refuses (Error::Kind::Correctable) structures that are of another patient ("another-patient"),
/// or placed by another origin ("another-frame-of-reference"), than the scan. What one of the two
/// does not state cannot differ.
haptics::Expected<void> checkBelongs(const std::filesystem::path& path,
                                     const ScanIdentity& structures, const ScanIdentity& scan);

}  // namespace datasets
