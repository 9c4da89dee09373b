// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/proxy/proxy.h"
#include "haptics/proxy/touch_constants.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// Result of one tick.
struct TickResult {
  Wrench wrench_W;   ///< wrench of the virtual coupling, before any limit
  int contacts = 0;  ///< rows that bear force on the proxy at its pose
  /// False in every tick that finds the proxy inside after the isovalue moved, and searches for a
  /// legal pose.
  bool outside = true;
  /// The budget ended the tick, before it had tried what a tick may. The proxy keeps the last
  /// accepted pose, and the next tick continues the search.
  bool cut = false;
  /// True if the proxy went as far as contacts and the limited speed of a release allow. False if
  /// the tick was too short for its way.
  bool followed = true;
};

/// One period of the servo loop: the six steps of [Chan 2011], 2.1, with changes
/// (haptics/README.md, "The tick"). The proxy moves towards the device as far as the
/// solid allows. A proxy that was in contact and has not been at the device since follows the
/// device's motion, and approaches the device by at most releaseSpeed() times `period` [s]. In
/// contact it moves so that the force changes by at most TouchConstants::kMostFall beside what the
/// device's motion makes of it, where the way there has a place to wait.
TickResult tick(const Scene& scene, double isovalue, const VirtualCoupling& coupling,
                const Pose& X_WD, Proxy& proxy, Budget& budget, double period) HAPTICS_RT;

}  // namespace haptics
