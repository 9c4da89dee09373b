// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/recording/carved_copy.h"
#include "app/recording/recording.h"
#include "app/report/figures.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/scene/watch.h"

namespace app::report {

/// What a burr took of structures, and how much of their surfaces it laid bare: carries the
/// recorded cuts out once more, in the voxels of the scan.
class CutStructures {
 public:
  /// All of them must outlive it. A scan without voxels: of a recording with cuts nothing is known.
  /// `hash`: of the scan, if known. What was cut of another scan does not count.
  CutStructures(const Recording& recording, const haptics::Watch& watch,
                std::shared_ptr<const haptics::Volume> scan, const std::optional<VolumeHash>& hash);

  /// Steps in order of time. Refuses what touchedAsRecorded() refuses.
  haptics::Expected<void> add(const haptics::Step& step);

  struct Taken {
    double removed = 0.0;  ///< m3, of its voxels, each in part by its value
    /// m2: of its surface that was covered by solid before the first cut, and is not after the
    /// last. kNone, and so is `removed`: not known.
    double exposed = 0.0;
  };
  /// Of each structure of the watch. After the last step.
  std::vector<Taken> taken();

 private:
  void endScene();
  double removedOf(const haptics::DistanceMap& map) const;
  double exposedOf(const haptics::DistanceMap& map) const;

  const Recording& recording_;
  const haptics::Watch& watch_;
  std::shared_ptr<const haptics::Volume> scan_;
  std::optional<VolumeHash> hash_;
  std::uint32_t scene_ = 0;
  std::optional<CarvedCopy> copy_;                 ///< of the last scene with a cut
  std::shared_ptr<const haptics::Volume> before_;  ///< the first one; null: nothing was cut
  haptics::VoxelBox cut_;                          ///< in the present scene
  haptics::VoxelBox all_;                          ///< in all of them
  haptics::BurrCut last_;
  std::vector<Taken> taken_;
};

/// Whether the voxel at a place belongs to a structure: the samples of its map are negative there.
bool belongs(const haptics::DistanceMap& map, const haptics::Vec3& p_W);

}  // namespace app::report
