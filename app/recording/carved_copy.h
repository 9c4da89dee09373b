// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "haptics/carving/burr.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace app {

/// The voxels of a scene with the cuts that were made in it, in a view of their own. Nothing else
/// is copied than the pages that cuts write.
class CarvedCopy {
 public:
  /// `volume`: as the scene has it before the first cut.
  explicit CarvedCopy(std::shared_ptr<const haptics::Volume> volume) : uncut_{std::move(volume)} {}

  /// Carries a cut out; returns the volume that it removed [m3].
  haptics::Expected<double> carve(const haptics::BurrCut& cut);
  bool isCut() const { return voxels_ != nullptr; }
  /// Of the voxels that differ from those before the first cut (digestOfCuts).
  std::uint64_t digest() const;

 private:
  std::shared_ptr<const haptics::Volume> uncut_;
  std::shared_ptr<void> voxels_;  ///< null: nothing was cut
};

}  // namespace app
