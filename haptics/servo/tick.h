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

/// N/s: how fast the force falls when the surface lets go of the proxy (README, "Release"). By this
/// over the stiffness, in m/s, the proxy comes nearer to the device.
inline constexpr double kRelease = 90.0;

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
/// The proxy moves from where it is towards the device as far as the solid lets it. One that the
/// solid held, and that has not been at the device since, follows the device's motion and comes
/// nearer by no more than kRelease allows in a `period` [s].
TickResult tick(const Scene& scene, double isovalue, const VirtualCoupling& coupling,
                const Pose& X_WD, Proxy& proxy, Budget& budget, double period = 1e-3) HAPTICS_RT;

}  // namespace haptics
