// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "datasets/labels/belonging.h"
#include "datasets/labels/label_map.h"
#include "datasets/labels/surface_inside.h"
#include "datasets/readers/scan.h"

namespace datasets {

/// What a file does not say itself.
struct LabelReading {
  /// Of the numbers of a label map: see readLabelTable(). It names what the file itself does not.
  /// Empty: if the file names nothing, the table that lies beside it with its name, as .ctbl,
  /// .label or .txt.
  std::filesystem::path table = {};
  /// Of a surface whose file does not state it.
  std::optional<SurfaceSpace> space = {};
  /// Of the scan, to tell whether a DICOM object belongs to it: see checkBelongs().
  ScanIdentity of = {};
  /// The user says that the file belongs to the scan, whatever the two state.
  bool agreed = false;
};

/// Whether a file says that it holds structures: a .seg.nrrd, or a DICOM segmentation or structure
/// set.
bool isStructures(const std::filesystem::path& path);

/// Reads the structures of a scan: 3D Slicer's .seg.nrrd with names, colours and layers; any NRRD,
/// MetaImage or NIfTI file of whole numbers; a DICOM segmentation (addDicomSegments()) or structure
/// set (addDicomContours()). In a label map each number but 0 is a structure, without a name where
/// no segment has it; each volume of a file is a layer. The space of the patient is common to both;
/// their grids may differ. Refuses what survey() and readVolume() refuse, and by name: another
/// format, and values that are not whole numbers of at most seven digits ("not-labels"), a segment
/// in a layer that is not there ("bad-header"), no label at all ("labels-none"), more than 255
/// structures ("labels-too-many"), a file or scan whose orientation is not known unless both have
/// the same voxels ("orientation-unknown"), labels that lie outside the scan ("labels-elsewhere"),
/// and a DICOM object that is not of this scan. Any thread; it reads one layer at a time.
haptics::Expected<LabelMap> readLabels(const std::filesystem::path& path,
                                       const haptics::Volume& scan,
                                       const ReadProgress& progress = {},
                                       const LabelReading& reading = {});

}  // namespace datasets
