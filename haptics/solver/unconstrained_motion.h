// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// The rotation vector [rad, W] that takes the rotation of `from` to that of `to`: of the two that
/// do, and their turns by 2 pi, the one nearest to `last`. The logarithm alone flips its sign as
/// the angle passes pi, and with it the torque.
Vec3 unwrappedTurn(const Pose& from, const Pose& to, const Vec3& last) HAPTICS_RT;

/// Step 1, [Chan 2011], 2.4: the motion that would take the proxy to the device in unit time.
/// `turn` is the rotation from the last call; it is replaced by this one's.
Twist unconstrainedMotion(const Pose& X_WP, const Pose& X_WD, Vec3& turn) HAPTICS_RT;

}  // namespace haptics
