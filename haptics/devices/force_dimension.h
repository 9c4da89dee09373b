// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/devices/catalogue.h"

namespace haptics {

/// Force Dimension's omega, delta, sigma and lambda, over the maker's library, which the user
/// installs: version 3, from 3.3.2 on, the first with a watchdog. What is declared of it is by its
/// public header of version 3.17.5. Nothing here has met a device yet; what only one can tell is
/// marked [U].
///
/// Frames: the maker's base has x towards the user, y to the right, z up, and its axes are turned
/// into B; the handle's axes likewise, so that a handle in its neutral orientation is that of B.
/// Grip and wrist angles, which left-handed units report negated, are not used: the orientation
/// comes as a matrix, which is the base's for either hand [U]. Torques act about the handle [U].
///
/// Threads: a call of the library blocks on USB, some 0.3 ms when all is well, and no bound is
/// documented for when it is not. So all calls are made by a transport's thread (threaded.h), at
/// most 4000 rounds a second. It is in step: a round sends the answer to the last pose first, and
/// then asks for the next pose. Reading and writing take no time, a reading older than 15 ms is
/// Stale, and stop() is obeyed by the next round. A round that takes over 5 ms sends zero.
///
/// Safety: the device's own watchdog turns its force off when no command has come for 5 ms, which
/// is what a killed or hanging program leaves behind; a unit that does not take the watchdog is not
/// opened. Its speed limit is left as the maker set it: its unit differs from model to model.
/// Opening moves nothing: a unit that is not initialised is NotReady with
/// Trouble::NeedsCalibration, until the user has moved it as its manual says, or started the
/// maker's tool; force comes after that by itself. A unit that has switched its force off is
/// NotReady with Trouble::ForceOff; after a break of speed limit or watchdog its force is switched
/// on again once no wrench unlike zero has been asked for for a second, after its button or
/// dead-man's switch only the user can; and so long it stays zero after any pause. The weight of
/// the handle is borne by the library whenever commands are sent. The grip is never driven. Closing
/// sends zero and brakes.
///
/// `libraries`: names or paths to try, in this order.
std::vector<DeviceEntry> surveyForceDimension(std::span<const std::string> libraries);

/// `request.id`: "force-dimension", or with a colon and a number the one of several, from 0 on. One
/// can be open at a time: whether the library may be in two threads at once is not documented.
Expected<std::unique_ptr<Device>> openForceDimension(const OpenRequest& request,
                                                     std::span<const std::string> libraries);

/// The same with the names that the maker gives it, libdrd before libdhd: the driver.
std::vector<DeviceEntry> surveyForceDimension();
Expected<std::unique_ptr<Device>> openForceDimension(const OpenRequest& request);

}  // namespace haptics
