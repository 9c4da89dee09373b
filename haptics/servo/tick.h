// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/scene.h"
#include "haptics/servo/proxy.h"

namespace haptics {

/// Units of work in a tick's default budget: about 200 us.
inline constexpr std::int64_t kTickWork = 20'000;

/// What one tick came to.
struct TickResult {
  Wrench wrench_W;   ///< of the virtual coupling, before any limit
  int contacts = 0;  ///< rows that bear on the proxy at its pose
  /// False in every tick in which the proxy was found inside, after the isovalue moved, and had to
  /// be brought out.
  bool outside = true;
  /// The budget ended the tick; what was under way goes on in the next, and nothing wrong is done.
  bool cut = false;
};

/// One period of the servo loop: the six steps of [Chan 2011], 2.1, refined as the README tells.
/// The proxy moves from where it is towards the device as far as the solid lets it.
TickResult tick(const Scene& scene, double isovalue, const VirtualCoupling& coupling,
                const Pose& X_WD, Proxy& proxy, Budget& budget) HAPTICS_RT;

}  // namespace haptics
