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

namespace haptics::falcon {

inline constexpr const char* kFalcon = "Novint Falcon";

/// Result of handing bytes to the bus.
enum class Sent : std::uint8_t {
  Taken,
  Busy,  ///< the previous bytes are still under way: these were not taken
  Gone   ///< unplugged, or the bus failed; this does not change
};

/// The USB chip (FTDI) of a Falcon that is open and claimed. One thread at a time. Destroyed, it
/// gives the bytes that are under way a twentieth of a second, and closes.
class FalconPort {
 public:
  virtual ~FalconPort() = default;
  /// A vendor request of the chip, without data; waits a second at most. False: not done. Set-up
  /// alone.
  virtual bool request(std::uint8_t request, std::uint16_t value) noexcept = 0;
  /// Hands over 64 bytes at most and waits for nothing.
  virtual Sent send(std::span<const std::uint8_t> bytes) noexcept = 0;
  /// The next transfer that carries more than the chip's two bytes of status, those first, into 64
  /// bytes; waits at most `wait`, which is rounded up to whole milliseconds. Returns its length, 0
  /// if none came, and nothing once none will: the device is gone, or only what is sent still gets
  /// through.
  virtual std::optional<std::size_t> receive(std::span<std::uint8_t> transfer,
                                             std::chrono::nanoseconds wait) noexcept = 0;
  /// Monotonic [ns].
  virtual std::int64_t now() const noexcept = 0;
};

/// A Falcon that is plugged in.
struct FalconPlace {
  std::string where;      ///< as the system calls its socket: "1-2.3"
  bool permitted = true;  ///< this user may open it
  bool claimed = false;   ///< a program has it
};

/// All that are plugged in; opens none of them.
std::vector<FalconPlace> findFalcons();

/// Opens and claims one. Refused as Trouble::NotPluggedIn, NoPermission, InUse or Refused.
Expected<std::unique_ptr<FalconPort>> openFalconPort(const std::string& where);

}  // namespace haptics::falcon
