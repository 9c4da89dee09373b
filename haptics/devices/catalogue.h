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

/// A device as it stands now: known, and perhaps here.
struct DeviceEntry {
  /// To open it by, whatever else is plugged in: the driver's name, and after a colon which one;
  /// the name alone where none is here, or the first that can be opened is meant.
  std::string id;
  std::string name;              ///< for people: "Novint Falcon"
  int sensed = 0, actuated = 0;  ///< degrees of freedom
  bool present = false;          ///< plugged in, or its service knows it
  /// Why it cannot be used now. None: it can be opened, or where it is not known to be present,
  /// opening tells. What the user sees to at the device (NotHomed to ForceOff) keeps it from
  /// nothing but force.
  Trouble trouble = Trouble::None;
  std::string why = {};  ///< one sentence for the user: what is wrong, and what to try; or empty
};

/// What opening may need beside the id.
struct OpenRequest {
  std::string id;
  std::filesystem::path firmware = {};  ///< Falcon: its maker's firmware, if it has none yet
};

/// One driver: what it may drive, how to look for it and how to open it.
///
/// Both calls may take seconds, never come from the servo or GUI thread, and open no device for
/// longer than looking takes: what another program or this one has open is not disturbed.
struct Driver {
  std::string_view name;  ///< "falcon"; ids of its devices are this, or this and ":which"
  /// At least one entry, also where nothing is plugged in: then it says what is missing.
  std::vector<DeviceEntry> (*survey)();
  /// The device, motors off. Refused with Trouble's word as the reason and what to try.
  Expected<std::unique_ptr<Device>> (*open)(const OpenRequest& request);
};

/// All drivers of real devices, in the order in which they are shown.
std::span<const Driver> drivers();

/// What all drivers know and see.
std::vector<DeviceEntry> surveyDevices();

/// The rating of an entry's model, or null: found by its id, what stands behind its colon, its
/// name, or its driver, in this order.
const DeviceRating* ratingOf(const DeviceEntry& entry);

/// Opens a device by the id of its entry.
Expected<std::unique_ptr<Device>> openDevice(const OpenRequest& request);

/// A refusal as drivers give it: `reason` is wordOf(trouble).
Error refusal(Trouble trouble, std::string what);

}  // namespace haptics
