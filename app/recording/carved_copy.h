// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "haptics/carving/burr.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace app {

/// A volume with the cuts that were made in it, in a view of its own: nothing else is copied than
/// the pages that cuts write. Recorder, replay and window each carry the recorded commands out for
/// themselves.
class CarvedCopy {
 public:
  /// `uncut`: as it is before the first cut.
  explicit CarvedCopy(std::shared_ptr<const haptics::Volume> uncut)
      : uncut_{std::move(uncut)}, volume_{*uncut_} {}

  /// Makes the view, which takes a tenth of a second for a large volume; else the first cut does.
  haptics::Expected<void> open();
  /// What a cut has done.
  struct Done {
    haptics::Removed removed;
    haptics::VoxelBox box;    ///< that holds all voxels that it lowered; empty: there are none
    std::int64_t looked = 0;  ///< voxels that it may have reached: its work
  };
  /// A cut that no burr makes (isPossible) does nothing.
  haptics::Expected<Done> carve(const haptics::BurrCut& cut);

  const std::shared_ptr<const haptics::Volume>& uncut() const { return uncut_; }
  /// With the voxels as they are now.
  const haptics::Volume& volume() const { return volume_; }
  /// Of the voxels that differ from those before the first cut (digestOfCuts); 0: none does.
  std::uint64_t digest() const;

 private:
  std::shared_ptr<const haptics::Volume> uncut_;
  haptics::Volume volume_;
  std::shared_ptr<void> voxels_;  ///< of `volume_`; null: there is no view yet
};

}  // namespace app
