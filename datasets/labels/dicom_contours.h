// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "datasets/labels/belonging.h"
#include "datasets/labels/label_map.h"
#include "datasets/readers/dicom/parsed.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// Adds the closed planar contours of a DICOM structure set, each region of interest as a
/// structure. A voxel belongs to it if its centre lies within an odd number of the contours of the
/// nearest plane, so that holes work, and not farther from that plane than half the usual step
/// between the structure's planes. Other contours, and those that leave their plane, are left out
/// and noted. Refuses what describedBy() refuses; and by name: contours that are no places and
/// regions of one number ("bad-header"), more than 255 ("labels-too-many"), and no closed contour
/// ("labels-none").
haptics::Expected<void> addDicomContours(LabelMap& map, const std::filesystem::path& path,
                                         const ParsedDicom& parsed, const ReadProgress& progress);

/// The origins that the regions of a structure set refer to.
std::set<std::string> framesOfContours(vtkDICOMMetaData* meta);

}  // namespace datasets
