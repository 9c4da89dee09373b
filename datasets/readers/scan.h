// SPDX-License-Identifier: BSD-3-Clause
// The words that all readers share: verdict, survey, part, progress.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
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
  Sound,        ///< as it stands
  Correctable,  ///< once it is resampled onto an even, right-angled grid, if the user agrees
  Refused
};

/// What to do with a correctable series.
enum class Geometry { AsStored, Corrected };

/// Which of the voxels that are stored to take: a smaller volume of a scan that memory does not
/// hold.
struct Part {
  /// Voxels of a whole volume, each axis from its first to beyond its last.
  struct Box {
    std::array<std::int64_t, 3> first{}, end{};
  };
  int step = 1;  ///< every so manieth voxel along each axis, counted from the box's first
  std::optional<Box> box = {};  ///< none: all

  bool isWhole() const { return step == 1 && !box; }
};

/// How to read what was found.
struct Reading {
  std::optional<int> series = {};  ///< which entry of the survey; none: the only one
  Geometry geometry = Geometry::AsStored;
  bool largest_part = false;  ///< of a series that lacks slices take UnbrokenPart
  Part part = {};
};

/// What a file calls its content, in UTF-8: for the screen of the person who opened it, and nowhere
/// else. Empty where it is not stated.
struct Labels {
  std::string patient, study, series;
};

/// The largest run of slices without a gap, of a series that lacks some. Its slices are taken as
/// they are, with their own positions.
struct UnbrokenPart {
  std::int64_t slices = 0;
  std::int64_t of = 0;  ///< slices that are there
  /// Where its first and its last slice lie along the normal (row x column), in patient LPS: for
  /// axial slices their z.
  double from_mm = 0.0, to_mm = 0.0;
  haptics::Vec3 spacing_mm = haptics::Vec3::Zero();
};

struct Found;

/// What can be said of a series, or of one volume of a file, before its voxels are read.
struct SeriesVerdict {
  int index = 0;
  std::string modality;
  std::array<std::int64_t, 3> dims{};
  haptics::Vec3 spacing_mm = haptics::Vec3::Zero();
  Verdict verdict = Verdict::Refused;
  std::vector<std::string> reasons;  ///< codes: "gantry-tilt", "not-scalar", "truncated", …
  haptics::Message message;          ///< for the user
  /// Of a series that is refused because slices are missing: what can be loaded of it, if the user
  /// agrees; or none.
  std::optional<UnbrokenPart> unbroken_part = {};
  Labels labels;
  int file_count = 0;
  std::int64_t bytes = 0;                ///< of the voxels in memory, estimated; 0: not known
  std::vector<haptics::Message> faults;  ///< a sentence for each file that cannot be used
  std::shared_ptr<const Found> found;
  std::shared_ptr<const void> place;  ///< what its files lie in, if that is to vanish later
};

/// Everything `info` says of a path.
struct Survey {
  bool several = false;  ///< a folder, an archive or a file of several volumes: one is to be chosen
  std::vector<SeriesVerdict> series;
};

/// Watches a read from another thread. Both calls come from the reading thread.
struct ReadProgress {
  std::function<void(double fraction)> advanced = [](double) {};
  const std::atomic<bool>* cancel = nullptr;  ///< true ends the read with Error::Kind::Cancelled

  bool isCancelled() const { return cancel != nullptr && *cancel; }
  /// Of a step that is a part of the whole; not to outlive it.
  ReadProgress part(double from, double to) const {
    return {[this, from, to](double f) { advanced(from + (to - from) * f); }, cancel};
  }
};

/// A small picture of the middle slice as the file stores it, the range of its values as 0 to 255;
/// at most `longest` pixels to a side.
struct Thumbnail {
  int width = 0, height = 0;  ///< pixels, square ones
  std::vector<std::uint8_t> grey;
};

}  // namespace datasets
