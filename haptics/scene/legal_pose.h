// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "haptics/core/budget.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// Whether every shell point is outside at a pose; false, too, if the budget ends before that is
/// certain.
bool legal(const Isosurface& solid, const PointShell& shell, const Pose& X_WT,
           Budget& budget) HAPTICS_RT;

/// The n-th place to look for room around a pose: 26 directions, at distances that grow from a
/// voxel by a quarter each round. Returns its distance [m].
double placeAround(const Pose& X_WT, double voxel, int n, Pose& place) HAPTICS_RT;

/// The pose itself if every shell point is outside, else a legal pose near it, at most 50 mm
/// away; none if there is none to be found.
std::optional<Pose> legalPoseNear(const Scene& scene, double isovalue, const Pose& X_WT);

}  // namespace haptics
