// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "datasets/readers/dicom/file.h"
#include "datasets/readers/dicom/stack.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// Files of one series, in the order of their names, and their geometry.
struct DicomSeries {
  std::vector<DicomFile> files;
  /// Geometry and order, or the reason why there is none.
  haptics::Expected<Stack> stack = Stack{};
  /// For a series that lacks slices: its largest part without a gap, if that is a sound stack;
  /// otherwise null.
  std::shared_ptr<const DicomSeries> unbroken;
  haptics::Message part;  ///< which of its series' volumes: "phase 2 of 3"; empty: the only one
  /// Names of the attributes in which its files differ although they make one stack.
  std::vector<haptics::Message> differences;
  /// The question that the user has to answer before the files count as one stack.
  std::optional<haptics::Error> question;
  std::vector<DicomFile> left_out;  ///< of the series, with the fault that says why
  int copies_left_out = 0;          ///< files left out because another file has the same image
  /// In the series of one file: damaged files beside it that do not state their series.
  int damaged_beside = 0;
};

/// The series among frames, by series number. Of several files with the same image, one is kept.
std::vector<DicomSeries> seriesAmong(std::vector<DicomFile> frames);

/// The same for the frames of files. Files that are not DICOM are ignored. `advanced` runs from 0
/// to 1.
haptics::Expected<std::vector<DicomSeries>> seriesAmong(
    const std::vector<std::filesystem::path>& paths, const ReadProgress& progress = {});

/// Reads the series of one file from that file's folder: the volume that holds the file, or all
/// volumes of which it holds frames. If several images lie at its place (for example in other
/// encodings), the named file is used. Structures that lie beside it are added to `structures`.
haptics::Expected<std::vector<DicomSeries>> seriesOf(
    const std::filesystem::path& file, DicomHeader header, const ReadProgress& progress,
    std::vector<StructuresFound>* structures = nullptr);

/// Takes the objects that hold structures out of what was found in a folder or below.
std::vector<StructuresFound> takeStructures(std::vector<DicomFile>& frames,
                                            const std::filesystem::path& folder);

/// The slice in the middle of the stack; of a series that makes none, in the order of the files. A
/// series has at least one.
const DicomFile& middleSliceOf(const DicomSeries& series);

/// Leaves `index` and `found` unset.
SeriesVerdict verdictOf(const DicomSeries& series);

}  // namespace datasets
