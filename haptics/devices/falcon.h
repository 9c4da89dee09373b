// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "haptics/devices/catalogue.h"
#include "haptics/devices/falcon_port.h"
#include "haptics/devices/threaded.h"

// The Novint Falcon: three degrees of freedom sensed and actuated, four buttons. Protocol by
// libnifalcon's code (BSD). The device has no program of its own when it is switched on: its
// maker's firmware is loaded once and stays until the power is cut. Palpate has no copy of it.
//
// Force only after homing: the user pulls the grip out and pushes it in until all three legs have
// been at their stops; the LED is red until then, and blue from then on. Zero goes out wherever
// there is doubt: not homed, the last exchange without a reading, legs close to singular, a force
// that is not finite.
//
// The device has no watchdog that is known: it keeps the last motor values for as long as nothing
// else comes. stop(), the end of the servo and the destructor send zeros. A process that is killed
// sends none: the system then cancels what is under way and frees the interface, but neither
// resets the device nor drops the chip's DTR or RTS lines. What the motors then do is not verified
// on hardware; the switch is on the power cable.
//
// Not verified on hardware either: all of the protocol's bits, the motor's scale (-10,000 a newton
// metre, up to 4096), and how many exchanges a second the bus carries.

namespace haptics {

std::vector<DeviceEntry> surveyFalcon();

/// "falcon" is the first that is plugged in. Asks the device whether its firmware runs, and loads
/// the file of the request if not: some seconds.
Expected<std::unique_ptr<Device>> openFalcon(const OpenRequest& request);

namespace falcon {

/// Entries for what is plugged in: one Falcon is "falcon", of several each is "falcon:1-2.3".
std::vector<DeviceEntry> entriesOf(std::span<const FalconPlace> places);

/// The firmware in a file: 1 byte to kMostFirmware. Refused as Trouble::NoFirmware.
Expected<std::vector<std::uint8_t>> readFirmware(const std::filesystem::path& file);

inline constexpr std::size_t kMostFirmware = 256 * 1024;  ///< bytes; the chip's memory has fewer

/// A Falcon whose firmware runs, loaded from `firmware` if need be. Refused as NoFirmware, Refused
/// or Lost.
Expected<std::unique_ptr<Transport>> linkTo(std::unique_ptr<FalconPort> port,
                                            const std::filesystem::path& firmware);

}  // namespace falcon
}  // namespace haptics
