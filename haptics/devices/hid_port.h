// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/trouble.h"

namespace haptics {

/// An open HID device, report by report. One thread at a time.
class HidPort {
 public:
  virtual ~HidPort() = default;
  /// One input report, its id first where the device has ids; returns its length, 0 if none came
  /// within `wait`, and nothing once the device is gone.
  virtual std::optional<std::size_t> read(std::span<std::uint8_t> report,
                                          std::chrono::milliseconds wait) noexcept = 0;
  /// One output report, its id first (0 where the device has none). False: it was not taken.
  virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
};

/// A HID device that the system lists.
struct HidPlace {
  std::string path;  ///< to open it by
  std::uint16_t vendor = 0, product = 0;
  std::uint16_t usage_page = 0, usage = 0;  ///< of its first collection; 0 where not known
  int interface = -1;
};

/// The plugged-in devices of one vendor. Not for the GUI or servo thread.
std::vector<HidPlace> findHid(std::uint16_t vendor);

/// Why a place cannot be opened, and what to try; Trouble::None: it can.
struct HidObstacle {
  Trouble trouble = Trouble::None;
  Message why = {};
};

/// Whether the system would allow to open it, without opening it. It does not show whether it is in
/// use.
HidObstacle hidObstacle(const HidPlace& place, const std::string& name);

/// Opens it. Only one port at a time can have a device, in all running Palpates; the system itself
/// would allow any number of programs, and does not report other makers' programs.
/// Refused as Trouble::NoPermission, InUse or NotPluggedIn, in words with `name`.
Expected<std::unique_ptr<HidPort>> openHid(const HidPlace& place, const std::string& name);

}  // namespace haptics
