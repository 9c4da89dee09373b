// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/study/reference/choices.h"

namespace reference {

/// Step 1 of [Chan 2011], 2.1: the motion that would take the proxy to the device in a unit of
/// time. The paper states it as an acceleration a_u = 2 dx, applied as x + a / 2 (2.4): the
/// factors cancel, since projecting onto a cone commutes with scaling, so dx itself is used.
/// The rotation is the shorter way round, at most pi.
Twist unconstrainedMotion(const Pose& X_WP, const Pose& X_WD);

/// Where a pose is after the time t in [0, 1] of a motion, (2): its origin along a line, rotation
/// about it. At t = 0 it is the pose given, to the bit.
Pose moved(const Pose& X_WP, const Twist& motion, double t);

/// A bound on the way a point at distance `radius` [m] of the centre travels in a unit of time:
/// s <= |v| + |r| |w| (2.3), in m.
double pathBound(const Twist& motion, double radius);

}  // namespace reference
