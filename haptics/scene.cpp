// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene.h"

#include <atomic>
#include <utility>

#include "haptics/servo/recovery.h"

namespace haptics {

Expected<std::shared_ptr<const Scene>> makeScene(std::shared_ptr<const Volume> volume, Tool tool) {
  static std::atomic<std::uint64_t> last_id{0};
  if (!volume || !volume->voxels)
    return tl::unexpected(Error{Error::Kind::NotFound, "There is no volume to touch; open one."});
  if (tool.shell.points.empty())
    return tl::unexpected(
        Error{Error::Kind::Malformed, "The tool has no points; a tool needs at least one."});
  ScalarField field{volume};
  const MassMetric metric{tool.shell.inertia};
  const Tolerances lengths{field.voxel()};
  ShellTree tree{tool.shell.points};
  return std::make_shared<const Scene>(
      Scene{++last_id, std::move(volume), std::move(tool), std::move(tree), std::move(field), metric, lengths});
}

std::optional<Pose> legalPoseNear(const Scene& scene, double isovalue, const Pose& X_WT) {
  constexpr double kFarthest = 0.050;  // m
  const Isosurface solid{scene.field, isovalue};
  Budget unlimited = Budget::counted(std::numeric_limits<std::int64_t>::max());
  if (legal(solid, scene.tool.shell, X_WT, unlimited)) return X_WT;
  Pose place;
  for (int n = 0; placeAround(X_WT, scene.field.voxel(), n, place) <= kFarthest; ++n)
    if (legal(solid, scene.tool.shell, place, unlimited)) return place;
  return {};
}

}  // namespace haptics
