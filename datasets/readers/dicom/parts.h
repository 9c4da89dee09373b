// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "datasets/readers/dicom/file.h"
#include "haptics/core/error.h"

namespace datasets {

/// Slices that make one volume.
struct VolumePart {
  std::vector<std::size_t> slices;  ///< indices of the files
  haptics::Message name;            ///< "phase 2 of 3 (40 %)"; empty where there is one volume
};

/// The volumes that the placed slices of one series make. All together, where they are one even
/// stack; else by the attribute, or the two, or the order in time, that make the fewest parts of
/// which each is an even stack; else by an attribute that makes some. Where none does, all
/// together.
std::vector<VolumePart> partsOf(const std::vector<DicomFile>& slices);

/// Whether these are one evenly spaced stack, tilted or not.
bool isEven(const std::vector<DicomFile>& slices);

/// How many images lie at each place, where it is the same number everywhere; else 0.
std::size_t imagesAtEachPlace(const std::vector<DicomFile>& slices);

/// The names of the attributes of which these slices state several values, of those that a verdict
/// tells.
std::vector<haptics::Message> differencesAmong(const std::vector<DicomFile>& slices);

}  // namespace datasets
