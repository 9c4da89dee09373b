// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "datasets/readers/dicom/file.h"
#include "datasets/readers/dicom/stack.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// Files that share a series, in the order of their names, and what can be made of them.
struct DicomSeries {
  std::vector<DicomFile> files;
  haptics::Expected<Stack> stack = Stack{};  ///< geometry and order, or why there is none
  /// Of a series that lacks slices: its largest part without a gap, a sound stack; or none.
  std::shared_ptr<const DicomSeries> unbroken;
  int copies_left_out = 0;  ///< other files with the image of one that is kept
  /// Of one file's series: damaged files beside it that do not say to which series they belong.
  int damaged_beside = 0;
};

/// The series among frames, by series number. Of files with the same image one is kept.
std::vector<DicomSeries> seriesAmong(std::vector<DicomFile> frames);

/// The same of the frames of files; what is no DICOM is passed over. `advanced` runs from 0 to 1.
haptics::Expected<std::vector<DicomSeries>> seriesAmong(
    const std::vector<std::filesystem::path>& paths, const ReadProgress& progress = {});

/// The series that one file stands for, from the file's own folder. Of several images at the place
/// of the named one (in other encodings, say) the named one is taken.
haptics::Expected<DicomSeries> seriesOf(const std::filesystem::path& file,
                                        const ReadProgress& progress = {});
/// The same of a file whose header has been parsed.
haptics::Expected<DicomSeries> seriesOf(const std::filesystem::path& file, DicomHeader header,
                                        const ReadProgress& progress);

/// Without an index and without what was found.
SeriesVerdict verdictOf(const DicomSeries& series);

}  // namespace datasets
