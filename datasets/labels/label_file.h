// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "datasets/labels/label_map.h"
#include "datasets/readers/scan.h"

namespace datasets {

/// What a file does not say itself.
struct LabelReading {
  /// Of the numbers of a label map: see readLabelTable(). It names what the file itself does not;
  /// empty: there is none.
  std::filesystem::path table = {};
};

/// Reads a label map beside a scan: 3D Slicer's .seg.nrrd with names, colours and layers, or any
/// NRRD, MetaImage or NIfTI file of whole numbers. Each number but 0 is a structure, without a name
/// where no segment has it; each volume of a file is a layer. The
/// space of the patient is common to both; their grids may differ. Refuses what survey() and
/// readVolume() refuse, and by name: another format, and values that are not whole numbers of at
/// most seven digits ("not-labels"), a segment in a layer that is not there ("bad-header"), no
/// label at all ("labels-none"), more than 255 structures ("labels-too-many"), a file or scan whose
/// orientation is not known unless both have the same voxels ("orientation-unknown"), and labels
/// that lie beside the scan ("labels-elsewhere"). Any thread; it reads one layer at a time.
haptics::Expected<LabelMap> readLabels(const std::filesystem::path& path,
                                       const haptics::Volume& scan,
                                       const ReadProgress& progress = {},
                                       const LabelReading& reading = {});

}  // namespace datasets
