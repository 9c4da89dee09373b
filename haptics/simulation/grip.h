// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// A device in a soft grip: a mass on a spring and a damper, whose other end is at the pose that
/// the hand wants. Rotation has the same model, with a radius of gyration.
///
/// In free space it follows with a lag of about 15 ms. Against a held force it is stable up to 2
/// damping / period = 16 kN/m at 1 kHz, the limit of a sampled spring.
struct Grip {
  double mass = 0.1;         ///< kg, of device and hand together
  double damping = 8.0;      ///< N·s/m, of device and hand together
  double stiffness = 500.0;  ///< N/m: hand
  double gyration = 0.03;    ///< m: rotation has mass, damping and stiffness times its square
  double coulomb = 0.0;      ///< N: dry friction of the device; times `gyration` in rotation

  Pose X_WD = Pose::Identity();
  Twist velocity;  ///< m/s, rad/s

  /// Advances by `period` [s] with the force held, in ten steps.
  void advance(const Pose& X_WH, const Wrench& felt_W, double period) HAPTICS_RT;
};

}  // namespace haptics
