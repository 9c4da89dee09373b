// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "haptics/core/latest_value.h"
#include "haptics/devices/device.h"
#include "haptics/simulation/grip.h"
#include "haptics/simulation/hand.h"

namespace haptics {

/// The simulated hand: a device in a soft grip that follows a hand's path, one period per read. Its
/// base B is W. It has the rating of a sigma.7.
std::unique_ptr<Device> openSimulated(Hand hand, Grip grip, double period);

/// The mouse: a device in a soft grip that is pulled to the pose at which the mouse points. Its
/// base B is W. The GUI thread publishes poses in `target`, which must outlive the device.
std::unique_ptr<Device> openMouse(LatestValue<Pose>& target, Grip grip, double period);

}  // namespace haptics
