// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "datasets/readers/dicom/file.h"
#include "haptics/core/error.h"

namespace datasets {

/// Files that are judged together.
struct FileGroup {
  std::vector<DicomFile> slices;         ///< whose places are known; a faulty one counts as a slice
  std::vector<DicomFile> faulty = {};    ///< that may be slices of it, nobody knows where
  std::vector<DicomFile> left_out = {};  ///< of its series, but no images of the stack
  haptics::Message view = {};  ///< "orientation 2 of 2": where a series has several; else empty
  /// How they come together, if not by the identifier of their series.
  enum class Join {
    OneSeries,
    SeriesOfOneSlice,  ///< each is a series of its own, of one patient and study
    NothingInCommon    ///< each is of a study of its own
  };
  Join join = Join::OneSeries;
};

/// Puts frames together by patient, study, series, modality and geometry: slices of one series that
/// have the same rows, columns, orientation and pixel spacing. An identifier that is blank is one
/// of its folder. A scout or a picture among the slices of a stack is left out of it.
std::vector<FileGroup> groupsOf(std::vector<DicomFile> frames);

}  // namespace datasets
