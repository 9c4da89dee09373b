// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/budget.h"
#include "haptics/servo/proxy.h"

namespace haptics {

/// One tick of bringing the proxy outside. First the trial pose is pushed along the gradients of
/// its inside points, then the places around are tried, and on the eighteenth tick the proxy is
/// set outside the volume, where it is legal for certain. Returns true once the proxy is outside.
bool recover(const Scene& scene, const Isosurface& solid, Proxy& proxy, Budget& budget) HAPTICS_RT;

}  // namespace haptics
