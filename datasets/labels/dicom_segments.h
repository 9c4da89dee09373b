// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>

#include "datasets/labels/label_map.h"
#include "datasets/readers/dicom/parsed.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// Adds the segments of a DICOM segmentation object: binary, fractional (a pixel belongs where it
/// has half of the greatest value or more) or a label map. A voxel of the scan takes the nearest
/// pixel of the nearest plane. Refuses what describedBy() refuses; and by name: an object without
/// segments or with a number twice ("bad-header"), more than 255 ("labels-too-many"), frames that
/// are turned against each other ("mixed-orientation") or do not lie on even planes
/// ("uneven-spacing"), and two frames of one segment at one place ("duplicate").
haptics::Expected<void> addDicomSegments(LabelMap& map, const std::filesystem::path& path,
                                         const ParsedDicom& parsed, const ReadProgress& progress);

/// Red, green and blue, 0 to 1, of a colour that DICOM states as CIELab, each number from 0 to
/// 65535. White is that of sRGB, as DCMTK and 3D Slicer take it.
std::array<double, 3> colourOfCieLab(const std::array<double, 3>& stated);

}  // namespace datasets
