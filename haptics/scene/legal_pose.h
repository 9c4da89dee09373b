// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "haptics/core/budget.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// Whether every shell point is outside at a pose. Also false if the budget runs out before that is
/// proven.
bool legal(const Isosurface& solid, const PointShell& shell, const Pose& X_WT,
           Budget& budget) HAPTICS_RT;

/// Sets `place` to the n-th pose of a search around X_WT: 26 directions, at distances that begin at
/// one voxel and grow by a quarter each round. Returns the distance [m].
double placeAround(const Pose& X_WT, double voxel, int n, Pose& place) HAPTICS_RT;

/// The pose itself if every shell point is outside, otherwise a legal pose at most 50 mm away; none
/// if the search finds none.
std::optional<Pose> legalPoseNear(const Scene& scene, double isovalue, const Pose& X_WT);

}  // namespace haptics
