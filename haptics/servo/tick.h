// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/proxy.h"

namespace haptics {

/// Units of work in a tick's default budget: about 200 us.
inline constexpr std::int64_t kTickWork = 20'000;

/// m/s: how fast a proxy that the surface held comes nearer to the device once it is let go, by the
/// coupling's stiffness [N/m]. From 3000 N/m on the force falls by 90 N a second (README,
/// "Release").
inline double releaseSpeed(double stiffness) HAPTICS_RT {
  constexpr double kStiff = 3000.0, kFall = 90.0;  // N/m, N/s
  const double softer = std::max(1.0, kStiff / stiffness);
  return kFall / stiffness * softer * softer;
}
/// N: what is pulled with more than this comes nearer at once, for no device renders it.
inline constexpr double kMostReleased = 50.0;

/// What one tick came to.
struct TickResult {
  Wrench wrench_W;   ///< of the virtual coupling, before any limit
  int contacts = 0;  ///< rows that bear on the proxy at its pose
  /// False in every tick in which the proxy was found inside, after the isovalue moved, and had to
  /// be brought out.
  bool outside = true;
  /// The budget ended the tick; what was under way goes on in the next, and nothing wrong is done.
  bool cut = false;
  /// The proxy got as far as contacts, and what follows a release, let it; not: its way was too
  /// long for a tick.
  bool followed = true;
};

/// One period of the servo loop: the six steps of [Chan 2011], 2.1, refined as the README tells.
/// The proxy moves from where it is towards the device as far as the solid lets it. One that the
/// solid held, and that has not been at the device since, follows the device's motion and comes
/// nearer by no more than releaseSpeed() in a `period` [s].
TickResult tick(const Scene& scene, double isovalue, const VirtualCoupling& coupling,
                const Pose& X_WD, Proxy& proxy, Budget& budget, double period = 1e-3) HAPTICS_RT;

}  // namespace haptics
