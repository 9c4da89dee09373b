// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/devices/ratings.h"
#include "haptics/simulation/grip.h"

namespace haptics {

/// When the force of a spring acts.
struct Timing {
  double period = 1e-3;  ///< s, that a force is held
  int delay = 0;         ///< periods that it comes late
};

/// The stiffest spring [N/m, at the hand] that a device may render: its rating, and 0.45 of what
/// a sampled spring may be, 2 b / (T (1 + 2 delay)), b being the damping of device and hand as
/// simulation/device_model.h has them. At half, presses on noise of 10 % gave up to 1.06 mJ where 1
/// is asked (app/study/stability).
///
/// With torque motors the angular spring, which is the stiffness times the tool's `inertia` [m²],
/// has the same limit, and across a long tool it is stiffer than in the mean. Without them an
/// `arm` [m], from the handle's pivot to the tool, counts: the torque that no motor makes is
/// missing where the handle turns, and the longer the arm and the stiffer the spring, the more
/// energy that gives. Any thread.
double allowedStiffness(const DeviceRating& rating, const Mat3& inertia, const Timing& timing,
                        double arm = 0.0);

/// The same for the grip in which the simulated hands and the mouse hold the device, and which
/// nobody rates.
double allowedStiffness(const Grip& grip, const Mat3& inertia, double period);

}  // namespace haptics
