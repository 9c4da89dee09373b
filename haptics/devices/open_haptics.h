// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/devices/catalogue.h"

namespace haptics {

/// 3D Systems' Touch and Touch X, and SensAble's PHANTOM Omni, Desktop and Premium, over the HD
/// part of the maker's OpenHaptics, which the user installs. What is declared of it is by its
/// public header of version 3.0 and the reference of 3.5. Nothing here has met a device yet; what
/// only one can tell is marked [U].
///
/// Frames: the maker's base has the axes of B. Units there: mm, N, N/mm, and mN·m for torque [U]: a
/// unit with torque motors gets torque only if the most that it says of itself is of the size that
/// mN·m would give. Its stiffness, force and continuous force replace the table's where they are
/// within a factor of three of them.
///
/// Threads: the library has a thread of its own that calls the driver a thousand times a second;
/// each call reads pose and buttons and sends the newest wrench. Reading and writing take no time.
/// stop() is obeyed by the next call. Without a call for 15 ms a reading is Stale, for half a
/// second the device is Lost.
///
/// Safety: a wrench is sent for 5 ms after its write at most, then zero (relay.h). An error of the
/// library makes the force zero until a second has passed without one and without a wrench unlike
/// zero being asked for: warm motors are NotReady with Trouble::MotorsHot, too much force, impulse
/// or speed Stale, the third in a row Lost; a lost link or a fault of the device is Lost at once. A
/// unit that is not calibrated is NotReady with Trouble::NeedsCalibration and without force until
/// its stylus is put into the inkwell, or the maker's tool has been used. The maker's own limits of
/// force stay on. Closing sends zero, stops the library's thread and switches the force off. What
/// the motors do when the program is killed is the maker's [U].
///
/// `libraries`: names or paths to try, in this order. The library does not tell what is plugged in
/// before it is opened, and a survey does not do that.
std::vector<DeviceEntry> surveyOpenHaptics(std::span<const std::string> libraries);

/// `request.id`: "openhaptics", or with a colon and the name that the maker's setup tool gave the
/// unit. One at a time in a program, for there is one thread that calls.
Expected<std::unique_ptr<Device>> openOpenHaptics(const OpenRequest& request,
                                                  std::span<const std::string> libraries);

/// The same with the names that the maker gives the library: the driver.
std::vector<DeviceEntry> surveyOpenHaptics();
Expected<std::unique_ptr<Device>> openOpenHaptics(const OpenRequest& request);

}  // namespace haptics
