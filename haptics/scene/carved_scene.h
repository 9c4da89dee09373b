// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/carving/burr.h"
#include "haptics/collision/contact.h"
#include "haptics/core/budget.h"
#include "haptics/core/error.h"
#include "haptics/core/realtime.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// A private view with the voxels of a volume: pages that are the scan's cost nothing. Refuses a
/// volume without a memory object, reason "not-editable".
Expected<std::shared_ptr<void>> viewLike(const Volume& volume);

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
  void begin(const BurrCut& cut) HAPTICS_RT;
  /// Goes on with it, its bounds first, for so many units of work while there is budget. Returns
  /// what was removed.
  Removed advance(const Material& material, std::int64_t work, Budget& budget) HAPTICS_RT;
  /// Drops contacts, of a tool with its origin there, whose cells the cut may have changed: the
  /// tool would hang on what is gone.
  void drop(Contacts& contacts, const Vec3& tool_W) const HAPTICS_RT;
  bool isDone() const HAPTICS_RT { return !raising_ && carving_.isDone(); }
  /// Finds the bounds of up to so many blocks anew. Where it was cut last they stay as high as the
  /// next cut may need. Returns how many blocks have bounds that are not exact.
  std::size_t refresh(std::size_t blocks) HAPTICS_RT;
  /// No more cuts for now, so that refresh() makes all blocks exact.
  void rest() HAPTICS_RT { raised_box_ = {}; }

 private:
  CarvedScene() = default;
  /// Bounds that a cut needs before its first voxel changes.
  struct Raising {
    VoxelBox blocks;
    double steepest = 0.0;      ///< value a voxel
    std::int64_t j = 0, k = 0;  ///< the next row of blocks
  };
  /// Raises a row of blocks. Returns the units of work.
  std::int64_t raiseRow() HAPTICS_RT;
  bool isWithinRaised(const VoxelBox& blocks) const HAPTICS_RT;

  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<void> voxels_;        ///< those of the scene
  std::shared_ptr<const Volume> scan_;  ///< as it was before the first cut
  std::shared_ptr<ScalarField> field_;  ///< the scene's
  BurrCarving carving_;
  std::optional<Raising> raising_;      ///< none: all is raised for the cut
  BurrCut cut_;                         ///< the one that `carving_` carries out
  std::vector<float> raised_;           ///< of each finest block, as of MaxPyramid::raise()
  std::vector<std::uint32_t> waiting_;  ///< blocks to be made exact, a ring with room for each
  std::size_t first_ = 0, count_ = 0;
  VoxelBox raised_box_;     ///< blocks that all are raised by `raised_by_`, or more
  double raised_by_ = 0.0;  ///< value a voxel
};

}  // namespace haptics
