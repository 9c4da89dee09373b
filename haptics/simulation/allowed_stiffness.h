// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/devices/ratings.h"
#include "haptics/simulation/grip.h"
#include "haptics/tool/point_shell.h"

namespace haptics {

/// Period and delay of a force.
struct Timing {
  double period = 1e-3;  ///< s for which a force is held
  double delay = 0.0;    ///< s by which it comes late
};

/// The stiffest spring [N/m, at the hand] that a device may render with a tool of these points: the
/// smaller of its rating and 0.45 of the limit of a sampled spring, 2 b / (T + 2 delay), where
/// b is the damping of device and hand in simulation/device_model.h. With 0.5 instead of 0.45,
/// presses on noise of 10 % gave up to 1.06 mJ, and the bound is 1 mJ (app/study/stability).
///
/// With torque motors the angular spring, which is the stiffness times the tool's inertia, has the
/// same limit; across a long tool it is stiffer than the mean.
///
/// A handle that turns without torque motors gets energy: the torque that is missing does no work.
/// The energy grows with the angular stiffness that is missing about the handle's pivot. A contact
/// at the far end of the tool, at r from its origin, gives K r² I / (I + r²), with the tool's
/// largest inertia I: that end gives way by turning as well as by moving. A tool whose origin is
/// `arm` [m] from the pivot gives K arm². Either may be at most 0.9 N·m/rad. The shipped programs
/// have no arm: a driver reads the pose of the pivot, and the tool's origin is there.
///
/// Any thread.
double allowedStiffness(const DeviceRating& rating, const PointShell& shell, const Timing& timing,
                        double arm = 0.0);

/// The same for the grip of the simulated hands and the mouse, which has no rating.
double allowedStiffness(const Grip& grip, const PointShell& shell, double period);

}  // namespace haptics
