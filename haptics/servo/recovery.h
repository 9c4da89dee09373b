// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/budget.h"
#include "haptics/servo/proxy.h"

namespace haptics {

/// One tick of the search for a legal pose. In the first 6 ticks the trial pose is pushed along the
/// gradients at its inside points. In the next 11 ticks poses around the proxy are tried. In the
/// 18th tick the proxy is put outside the grid, where it is always legal. Returns true once the
/// proxy is outside.
bool recover(const Scene& scene, const Isosurface& solid, Proxy& proxy, Budget& budget) HAPTICS_RT;

}  // namespace haptics
