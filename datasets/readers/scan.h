// SPDX-License-Identifier: BSD-3-Clause Types that all readers share: verdict, survey, reading,
// part, progress, labels, thumbnail.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/geometry.h"

namespace datasets {

/// Whether a series' geometry can be trusted.
enum class Verdict {
  Sound,        ///< can be read as stored
  Correctable,  ///< can be read after resampling onto an even, right-angled grid, if the user
                ///< agrees
  Refused
};

/// What to do with a correctable series.
enum class Geometry { AsStored, Corrected };

/// Which of the stored voxels to read: a smaller volume of a scan that exceeds the memory.
struct Part {
  /// Voxels of a whole volume, from `first` to before `end` on each axis.
  struct Box {
    std::array<std::int64_t, 3> first{}, end{};
  };
  int step = 1;                 ///< every n-th voxel along each axis, counted from the box's first
  std::optional<Box> box = {};  ///< none: all

  bool isWhole() const { return step == 1 && !box; }
};

/// How to read what was found.
struct Reading {
  std::optional<int> series = {};  ///< which entry of the survey; none: the only one
  Geometry geometry = Geometry::AsStored;
  bool largest_part = false;  ///< if a series lacks slices, read its UnbrokenPart
  Part part = {};
};

/// A grey window that a file states, in the unit of its voxels: black at level - width / 2 and
/// below, white at level + width / 2 and above.
struct StatedWindow {
  double level = 0.0;
  double width = 1.0;  ///< above 0
  std::string name;    ///< in UTF-8, for the screen only; empty: not stated
};

/// The names in a file, in UTF-8. They may be shown only on the screen of the person who opened the
/// file. A name that is not stated is empty.
struct Labels {
  std::string patient, study, series;
};

/// The largest run of slices without a gap, in a series that lacks slices. The slices keep their
/// own positions.
struct UnbrokenPart {
  std::int64_t slices = 0;
  std::int64_t of = 0;  ///< slices in the series
  /// Positions of its first and last slice along the normal (row x column), in patient LPS. For
  /// axial slices this is z.
  double from_mm = 0.0, to_mm = 0.0;
  haptics::Vec3 spacing_mm = haptics::Vec3::Zero();
};

struct Found;

/// A series, or one volume of a file, as known before its voxels are read.
struct SeriesVerdict {
  int index = 0;
  std::string modality;
  std::array<std::int64_t, 3> dims{};
  haptics::Vec3 spacing_mm = haptics::Vec3::Zero();
  Verdict verdict = Verdict::Refused;
  std::vector<std::string> reasons;  ///< codes: "gantry-tilt", "not-scalar", "truncated", …
  haptics::Message message;          ///< one sentence for the user
  haptics::Message part = {};  ///< which volume of its series: "phase 2 of 3"; empty: the only one
  /// For a series that is refused because slices are missing: the part that can be loaded if the
  /// user agrees; or none.
  std::optional<UnbrokenPart> unbroken_part = {};
  Labels labels;
  /// The windows of the slice in the middle, in the order of the file; the first is meant to be
  /// shown at first.
  std::vector<StatedWindow> windows = {};
  int file_count = 0;
  std::int64_t bytes = 0;                ///< estimated size of the voxels in memory; 0: unknown
  std::vector<haptics::Message> faults;  ///< a sentence for each file that cannot be used
  std::shared_ptr<const Found> found;
  std::shared_ptr<const void> place;  ///< keeps the temporary folder of an archive
};

/// A file that marks parts of a scan: a DICOM object (holdsStructures()), or a .seg.nrrd
/// (holdsSegments()).
struct StructuresFound {
  enum class Kind { Segments, Contours };
  std::filesystem::path path;
  std::string name;  ///< as the folder or archive names it
  Kind kind = Kind::Segments;
  std::shared_ptr<const void> place = {};  ///< as in SeriesVerdict
};

/// Everything that `info` reports about a path.
struct Survey {
  /// The path is a folder, an archive or a file of several volumes; one must be chosen.
  bool several = false;
  std::vector<SeriesVerdict> series;
  /// What readLabels() may put onto them, found with them: in the folder and below, or beside the
  /// file.
  std::vector<StructuresFound> structures = {};
};

/// Lets another thread watch and cancel a read. The reading thread calls `advanced` and reads
/// `cancel`.
struct ReadProgress {
  std::function<void(double fraction)> advanced = [](double) {};
  const std::atomic<bool>* cancel = nullptr;  ///< true ends the read with Error::Kind::Cancelled

  bool isCancelled() const { return cancel != nullptr && *cancel; }
  /// Progress of one step. The whole must outlive it.
  ReadProgress part(double from, double to) const {
    return {[this, from, to](double f) { advanced(from + (to - from) * f); }, cancel};
  }
};

/// A plane of the patient.
enum class AnatomicalPlane { Axial, Coronal, Sagittal };

/// A small picture of the middle one of the slices that the file stores, by the convention of the
/// window's slices: the patient's right is at the left of axial and coronal pictures, the front at
/// the left of sagittal ones; above is the front in axial pictures, else the head. An oblique slice
/// is turned by the nearest of the patient's axes. The 2nd to the 98th percentile of its values
/// become 0 to 255.
struct Thumbnail {
  int width = 0, height = 0;       ///< pixels, square ones
  std::vector<std::uint8_t> grey;  ///< upper rows first
  /// Nearest to the slice; none: the file does not say how it lies, and the picture is as stored.
  std::optional<AnatomicalPlane> plane = {};
};

}  // namespace datasets
