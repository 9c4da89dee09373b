// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/carving/burr.h"
#include "haptics/collision/contact.h"
#include "haptics/core/error.h"
#include "haptics/core/realtime.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// A scene whose voxels are lowered while it is touched: the one exception to the rule that a scene
/// is immutable. It has a private view of the scan and bounds of its own; nobody else sees them.
///
/// Cuts only lower the field. So a way that was proven free stays free, a legal pose legal, and the
/// greatest values of the pyramid stay bounds. Its Lipschitz constants are raised before voxels
/// change, and made exact again block by block.
///
/// Made on any thread but the servo thread. After that all calls are the servo thread's.
class CarvedScene {
 public:
  /// A scene as this one, over voxels of its own. Refuses a volume without a memory object, reason
  /// "not-editable", and one for whose view there is no room.
  static Expected<std::unique_ptr<CarvedScene>> of(const Scene& scene);

  const std::shared_ptr<const Scene>& scene() const HAPTICS_RT { return scene_; }

  /// Begins a cut; the one before must be done.
  void begin(const BurrCut& cut) HAPTICS_RT { carving_ = BurrCarving{*scene_->volume, cut}; }
  /// Goes on with it, up to so many rows of voxels. Returns what they lost. Drops contacts, of a
  /// tool with its origin there, whose cells change: the tool would hang on what is gone.
  Removed advance(std::int64_t rows, Contacts& contacts, const Vec3& tool_W) HAPTICS_RT;
  bool isDone() const HAPTICS_RT { return carving_.isDone(); }
  /// Makes the bounds of up to so many blocks exact again. Returns how many are left.
  std::size_t refresh(std::size_t blocks) HAPTICS_RT;

 private:
  CarvedScene() = default;
  void raiseAround(const VoxelBox& changed) HAPTICS_RT;

  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<void> voxels_;        ///< those of the scene
  std::shared_ptr<ScalarField> field_;  ///< the scene's
  BurrCarving carving_;
  std::vector<float> raised_;           ///< of each finest block, as of MaxPyramid::raise()
  std::vector<std::uint32_t> waiting_;  ///< blocks to be made exact, a ring with room for each
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace haptics
