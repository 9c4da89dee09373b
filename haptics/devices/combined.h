// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "haptics/devices/device.h"

namespace haptics {

/// Two devices as one, for a device that knows no rotation: a Falcon, and a SpaceMouse in the other
/// hand. Position, buttons and force are the first's; rotation is the second's, and its buttons
/// follow from number kButtonsEach on (haptics/settings.h). Its rating is the first's, with six
/// sensed degrees and no torque. Force goes to the first alone, torque nowhere; stop() and resume()
/// go to both.
///
/// A read waits as long as both, a write as long as the first's.
///
/// What came of a read is the worse of the two. A rotation that is stale leaves the last one
/// standing; one that is lost ends both, with zero force: a tool that turns no more with the hand
/// that holds it is not what the hand believes to feel. A second device that is NotReady makes both
/// so: before it has a rotation there is nothing to hold.
std::unique_ptr<Device> combined(std::unique_ptr<Device> position,
                                 std::unique_ptr<Device> rotation);

}  // namespace haptics
