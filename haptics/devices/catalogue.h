// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/trouble.h"
#include "haptics/devices/device.h"

namespace haptics {

/// A known device and its state now.
struct DeviceEntry {
  /// Identifies the device for opening: the driver's name, a colon and which one. The name alone
  /// means the first that can be opened, and stands for a device that is not present.
  std::string id;
  std::string name;              ///< for people: "Novint Falcon"
  int sensed = 0, actuated = 0;  ///< degrees of freedom
  bool present = false;          ///< plugged in, or its service knows it
  /// Why it cannot be used now. None: it can be opened, or, if it is not known to be present, only
  /// opening shows that. What the user can settle at the device (NotHomed to ForceOff) withholds
  /// only its force.
  Trouble trouble = Trouble::None;
  Message why = {};  ///< one sentence for the user: what is wrong, and what to try; or empty
};

/// The id, and what else opening may need.
struct OpenRequest {
  std::string id;
  std::filesystem::path firmware = {};  ///< Falcon: its maker's firmware, if it has none yet
};

/// One driver: its name, how to find its devices and how to open one.
///
/// Both calls may take seconds and must not come from the servo or GUI thread. A survey opens a
/// device only while it looks, and does not disturb one that a program has open.
struct Driver {
  std::string_view name;  ///< "falcon"; the ids of its devices are "falcon" or "falcon:which"
  /// At least one entry. If nothing is plugged in, it says what is missing.
  std::vector<DeviceEntry> (*survey)();
  /// The device, with motors off. A refusal has the word of Trouble as its reason, and says what to
  /// try.
  Expected<std::unique_ptr<Device>> (*open)(const OpenRequest& request);
};

/// All drivers of real devices, in the order in which they are shown.
std::span<const Driver> drivers();

/// The entries of all drivers.
std::vector<DeviceEntry> surveyDevices();

/// The rating of an entry's model, or null. Searched by its id, the part of the id behind the
/// colon, its name, and its driver, in this order.
const DeviceRating* ratingOf(const DeviceEntry& entry);

/// Opens a device by the id of its entry.
Expected<std::unique_ptr<Device>> openDevice(const OpenRequest& request);

/// A refusal of a driver: `reason` is wordOf(trouble).
Error refusal(Trouble trouble, Message message);

}  // namespace haptics
