// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/devices/ratings.h"
#include "haptics/simulation/grip.h"

namespace haptics {

/// Period and delay of a force.
struct Timing {
  double period = 1e-3;  ///< s for which a force is held
  int delay = 0;         ///< delay of the force in periods
};

/// The stiffest spring [N/m, at the hand] that a device may render: the smaller of its rating and
/// 0.45 of the limit of a sampled spring, 2 b / (T (1 + 2 delay)), where b is the damping of device
/// and hand in simulation/device_model.h. With 0.5 instead of 0.45, presses on noise of 10 % gave
/// up to 1.06 mJ, and the bound is 1 mJ (app/study/stability).
///
/// With torque motors the angular spring, which is the stiffness times the tool's `inertia` [m²],
/// has the same limit; across a long tool it is stiffer than the mean. Without torque motors, the
/// `arm` [m] from the handle's pivot to the tool lowers the limit: the missing torque does no work
/// when the handle turns, so the hand receives energy, which grows with arm and stiffness. Any
/// thread.
double allowedStiffness(const DeviceRating& rating, const Mat3& inertia, const Timing& timing,
                        double arm = 0.0);

/// The same for the grip of the simulated hands and the mouse, which has no rating.
double allowedStiffness(const Grip& grip, const Mat3& inertia, double period);

}  // namespace haptics
