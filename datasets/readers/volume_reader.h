// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Whether a series' geometry can be trusted.
enum class Verdict {
  Sound,        ///< as it stands
  Correctable,  ///< once it is resampled onto an even, right-angled grid, if the user agrees
  Refused
};

/// What to do with a correctable series.
enum class Geometry { AsStored, Corrected };

/// What can be said of a file or series before, or without, its voxels.
struct SeriesVerdict {
  int index = 0;
  std::string modality;
  std::array<std::int64_t, 3> dims{};
  haptics::Vec3 spacing_mm = haptics::Vec3::Zero();
  Verdict verdict = Verdict::Refused;
  std::vector<std::string> reasons;  ///< codes: "gantry-tilt", "not-scalar", "truncated", …
  std::string message;               ///< one sentence for the user
};

/// Everything `info` says of a path.
struct Survey {
  bool folder = false;
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

/// Lists what lies at a path (a DICOM folder or file, an NRRD) with a verdict for each series,
/// from headers alone.
haptics::Expected<Survey> survey(const std::filesystem::path& path);

/// Reads one volume. One file of a DICOM series stands for its series. A folder with several
/// loadable series and no `series` named is refused with the list (reason "which-series").
/// Anything but one evenly spaced, right-angled, single-component stack is refused by name, and
/// what is correctable too unless `geometry` says to correct it.
haptics::Expected<haptics::Volume> readVolume(const std::filesystem::path& path,
                                              std::optional<int> series = {},
                                              Geometry geometry = Geometry::AsStored,
                                              const ReadProgress& progress = {});

/// Writes an NRRD (raw, attached, space left-posterior-superior, unit and modality as
/// key/values): geometry and voxels, nothing of the patient.
haptics::Expected<void> writeNrrd(const haptics::Volume& volume, const std::filesystem::path& out);

}  // namespace datasets
