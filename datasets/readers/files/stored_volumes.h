// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "datasets/readers/files/stored_voxels.h"
#include "haptics/core/volume.h"

namespace datasets {

inline constexpr std::int64_t kMostVolumes = 10'000;  ///< that one file may offer

/// What the header of a file of whole volumes says, checked, without its voxels.
struct StoredVolumes {
  haptics::Grid grid;  ///< of each volume
  haptics::VolumeFacts facts;
  bool spacing_stated = true;  ///< false: 1 mm is assumed
  StoredVoxels voxels;
  double slope = 1.0, intercept = 0.0;  ///< from what is stored to what is meant

  std::int64_t count() const {
    return voxels.layout.sizes[static_cast<std::size_t>(voxels.layout.volume_axis)];
  }
};

/// Refuses sizes that no memory holds and more volumes than are offered ("too-large"), sizes below
/// one ("bad-header"), and voxels that the file cannot hold ("truncated"), before any is asked for.
haptics::Expected<void> checkStored(const StoredVoxels& voxels,
                                    const std::filesystem::path& header);

/// Reads a part of one of the volumes, by mapping where that is the way to open it. Whole numbers
/// stay whole where slope and intercept are: in the stored type, or in the narrowest of int16,
/// uint16, int32 and uint32 that holds every voxel; all else becomes float32.
haptics::Expected<haptics::Volume> readVolume(const StoredVolumes& stored, int number,
                                              const Part& part, const ReadProgress& progress);

/// Finishes a volume of which a part was read.
haptics::Expected<haptics::Volume> finished(const StoredVolumes& stored, const Window& window,
                                            haptics::ScalarType type, std::shared_ptr<void> voxels,
                                            const ReadProgress& progress);

}  // namespace datasets
