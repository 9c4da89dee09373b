// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace haptics {

/// Why a device cannot be used, or not yet.
enum class Trouble : std::uint8_t {
  None,
  NotPluggedIn,
  NoPermission,      ///< this user may not open it: a udev rule is missing
  NoLibrary,         ///< the maker's library, or one that it needs, is not installed
  NoService,         ///< the maker's service does not answer
  InUse,             ///< another program, or this one, has opened it
  NoFirmware,        ///< it needs its maker's firmware, which the user has to name
  NotHomed,          ///< the user has to move it to its stops
  NeedsCalibration,  ///< the user has to put it in its cradle, or start the maker's tool
  NotStarted,        ///< it has no power, or has not started
  MotorsHot,         ///< the motors are too hot; they cool down without action by the user
  ForceOff,          ///< the device switched its force off by its button, speed limit or watchdog
  Refused,           ///< this driver does not understand the device's answers
  Lost               ///< unplugged, or silent
};

/// One word for programs: "no-permission".
constexpr std::string_view wordOf(Trouble trouble) {
  switch (trouble) {
    case Trouble::None:
      return "none";
    case Trouble::NotPluggedIn:
      return "not-plugged-in";
    case Trouble::NoPermission:
      return "no-permission";
    case Trouble::NoLibrary:
      return "no-library";
    case Trouble::NoService:
      return "no-service";
    case Trouble::InUse:
      return "in-use";
    case Trouble::NoFirmware:
      return "no-firmware";
    case Trouble::NotHomed:
      return "not-homed";
    case Trouble::NeedsCalibration:
      return "needs-calibration";
    case Trouble::NotStarted:
      return "not-started";
    case Trouble::MotorsHot:
      return "motors-hot";
    case Trouble::ForceOff:
      return "force-off";
    case Trouble::Refused:
      return "refused";
    case Trouble::Lost:
      return "lost";
  }
  return "none";
}

}  // namespace haptics
