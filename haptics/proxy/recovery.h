// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/budget.h"
#include "haptics/proxy/proxy.h"

namespace haptics {

/// One tick, of `period` [s], of the search for a legal pose. For 6 ms the trial pose is pushed
/// along the gradients at its inside points. For the next 11 ms poses around the proxy are tried.
/// Then the proxy is put outside the grid, where it is always legal. Returns true once the proxy is
/// outside.
bool recover(const Scene& scene, const Isosurface& solid, Proxy& proxy, double period,
             Budget& budget) HAPTICS_RT;

}  // namespace haptics
