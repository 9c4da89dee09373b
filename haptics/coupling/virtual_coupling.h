// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// Step 6, [Chan 2011], (5): the spring between device and proxy.
struct VirtualCoupling {
  double stiffness = 1000.0;       ///< N/m
  double angular_stiffness = 0.0;  ///< N·m/rad; 0 takes stiffness times the tool's inertia
  double friction = 0.0;           ///< Coulomb's coefficient between tool and surface; 0 is none

  /// The wrench on the hand, W: it pulls the device towards the proxy. `turn` is the unwrapped
  /// rotation from device to proxy [rad], `inertia_W` the tool's mean inertia in W [m²]. Beyond
  /// 150 degrees the torque stays constant and does not change its direction.
  Wrench pull(const Pose& X_WP, const Pose& X_WD, const Vec3& turn,
              const Mat3& inertia_W) const HAPTICS_RT;
};

/// Force and torque each shortened to its limit, direction kept. A number that is not finite
/// yields zero.
Wrench saturated(const Wrench& wrench, double max_force, double max_torque) HAPTICS_RT;

}  // namespace haptics
