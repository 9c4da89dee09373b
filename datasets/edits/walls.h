// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "datasets/edits/edited.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/structures/distance_map.h"

namespace datasets {

/// A structure whose surface is a wall for the touch.
struct StructureWall {
  std::uint8_t structure = 0;  ///< its number in the label map
  bool solid = false;          ///< its surface stops the tool; false: it is not there
  haptics::DistanceMap distances = {};
};

/// A volume for the touch alone, in which structures are solid or not there: Volume::derivation.
/// Its edits are those of the volume that one sees.
struct Walled : Edited {
  struct Wall {
    std::uint8_t structure = 0;
    bool solid = false;
    bool operator==(const Wall&) const = default;
  };
  std::shared_ptr<const haptics::Volume> seen;  ///< the volume without walls
  std::vector<Wall> walls;
  double isovalue = 0.0;  ///< at which the walls lie where the structures do
  /// Of all voxels that differ from the scan's, as Edited::digest is of those that edits changed.
  std::uint64_t digest_of_walls = 0;
  std::vector<haptics::VoxelBox> written;  ///< boxes that hold what differs from `seen`
  std::size_t bytes = 0;                   ///< of memory that only this volume has
};

/// How a volume came about from one without walls; null: it has none.
inline const Walled* walledOf(const haptics::Volume& volume) {
  return dynamic_cast<const Walled*>(volume.derivation.get());
}

/// The volume without walls; most often it is the volume itself.
std::shared_ptr<const haptics::Volume> seenOf(std::shared_ptr<const haptics::Volume> volume);

/// The volume (without the walls that it has) in which these structures are walls: those that are
/// not there lowered, then the solid ones raised. The same arguments give the same voxels, to the
/// bit; without walls, and if none changes a voxel, it is the volume itself. `previous`: the volume
/// that was touched before, of which bounds are renewed where this one differs; may be null.
/// Refuses a scan without a memory object, reason "not-editable". Any thread; on all cores.
haptics::Expected<std::shared_ptr<const haptics::Volume>> walled(
    std::shared_ptr<const haptics::Volume> volume, std::span<const StructureWall> walls,
    double isovalue, const std::shared_ptr<const haptics::Volume>& previous = {},
    const std::atomic<bool>* cancel = nullptr);

}  // namespace datasets
