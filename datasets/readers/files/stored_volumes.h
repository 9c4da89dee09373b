// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "datasets/readers/files/file_geometry.h"
#include "datasets/readers/files/stored_voxels.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

inline constexpr std::int64_t kMostVolumes = 10'000;  ///< in one file

/// The checked header of a file of whole volumes, without its voxels.
struct StoredVolumes {
  haptics::Grid grid;  ///< of each volume
  haptics::VolumeFacts facts;
  bool spacing_stated = true;           ///< false: 1 mm is assumed
  std::vector<haptics::Message> notes;  ///< sentences that the verdict adds: what was set right
  StoredVoxels voxels;
  double slope = 1.0, intercept = 0.0;  ///< value = slope * stored + intercept

  std::int64_t count() const {
    return voxels.layout.sizes[static_cast<std::size_t>(voxels.layout.volume_axis)];
  }
};

/// Gives the volumes their grid. Refuses what gridOf() refuses. Axes that it turns by more than
/// 0.005 degrees, the rounding of single precision, are noted.
haptics::Expected<void> place(StoredVolumes& stored, const FileGeometry& geometry);

/// Refuses sizes that exceed any memory and more than kMostVolumes volumes ("too-large"), sizes
/// below one ("bad-header"), and more voxels than the file can hold ("truncated"), before memory is
/// allocated.
haptics::Expected<void> checkStored(const StoredVoxels& voxels,
                                    const std::filesystem::path& header);

/// Reads a part of one of the volumes, or maps it if isMapped() says so. Whole numbers stay whole
/// if slope and intercept are whole: in the stored type, or in the narrowest of int16, uint16,
/// int32 and uint32 that holds every voxel. All other values become float32.
haptics::Expected<haptics::Volume> readVolume(const StoredVolumes& stored, int number,
                                              const Part& part, const ReadProgress& progress);

/// Makes the Volume from voxels that have been read.
haptics::Expected<haptics::Volume> finished(const StoredVolumes& stored, const Window& window,
                                            haptics::ScalarType type, std::shared_ptr<void> voxels,
                                            const ReadProgress& progress);

}  // namespace datasets
