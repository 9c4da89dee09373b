// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// The rotation vector [rad, W] from the rotation of `from` to that of `to`. Of all such vectors,
/// which differ by multiples of 2 pi, it is the one nearest to `last`. The logarithm alone would
/// change its sign, and the torque with it, as the angle passes pi.
Vec3 unwrappedTurn(const Pose& from, const Pose& to, const Vec3& last) HAPTICS_RT;

/// Step 1, [Chan 2011], 2.4: the motion that would take the proxy to the device in unit time.
/// `turn` is the rotation of the last call, and is updated.
Twist unconstrainedMotion(const Pose& X_WP, const Pose& X_WD, Vec3& turn) HAPTICS_RT;

}  // namespace haptics
