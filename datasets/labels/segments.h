// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "datasets/labels/label_map.h"

namespace datasets {

/// A segment that the header of a .seg.nrrd describes.
struct Segment {
  Structure structure;
  bool coloured = false;   ///< the header states its colour
  std::int64_t layer = 0;  ///< which of the file's volumes it lies in
  std::int64_t label = 1;  ///< its voxels' value there
};

/// The segments of 3D Slicer's .seg.nrrd, in the order of the file; none for any other file. Before
/// there were layers each segment had a volume of its own, with label 1. Refuses ("bad-header")
/// layers and labels that are no whole numbers, and two segments with one label in one layer;
/// ("labels-too-many") more than 255. Source: 3D Slicer, developer guide, "Segmentations: file
/// format".
haptics::Expected<std::vector<Segment>> segmentsOf(const std::filesystem::path& path);

/// A name as it may be shown: without control characters, bytes that are no UTF-8 and blanks at its
/// ends, and no longer than Structure::kLongestName.
std::string shownName(std::string_view stated);

}  // namespace datasets
