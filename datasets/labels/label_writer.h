// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "datasets/labels/label_map.h"
#include "datasets/readers/scan.h"

namespace datasets {

/// Writes a label map as 3D Slicer's .seg.nrrd: names and colours as they are, and as many layers
/// as the overlaps need. The orientation of its scan must be known. Writes the file completely or
/// not at all.
haptics::Expected<void> writeLabels(const LabelMap& labels, const std::filesystem::path& out,
                                    const ReadProgress& progress = {});

}  // namespace datasets
