// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/budget.h"
#include "haptics/servo/proxy.h"

namespace haptics {

/// Whether every shell point is outside at a pose; false, too, if the budget ends before that is
/// certain.
bool legal(const Isosurface& solid, const PointShell& shell, const Pose& X_WT,
           Budget& budget) HAPTICS_RT;

/// The n-th place to look for room around a pose: 26 directions, at distances that grow from a
/// voxel by a quarter each round. Returns its distance [m].
double placeAround(const Pose& X_WT, double voxel, int n, Pose& place) HAPTICS_RT;

/// One tick of bringing the proxy outside. First the trial pose is pushed along the gradients of
/// its inside points, then the places around are tried, and on the eighteenth tick the proxy is
/// set outside the volume, where it is legal for certain. Returns true once the proxy is outside.
bool recover(const Scene& scene, const Isosurface& solid, Proxy& proxy, Budget& budget) HAPTICS_RT;

}  // namespace haptics
