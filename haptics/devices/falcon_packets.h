// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "haptics/core/geometry.h"

// What goes to a Novint Falcon whose firmware runs, and what comes back: packets of 16 bytes, '<',
// fourteen letters and '>'. A letter is 'A' and a nibble, the lowest of a number first. The
// protocol as libnifalcon's code has it (f7c727a). Not verified on hardware: which of the bits is
// which LED and which button, and the greatest motor value.
//
// Nothing here allocates: any thread.

namespace haptics::falcon {

using Packet = std::array<std::uint8_t, 16>;
using Motors = std::array<std::int16_t, 3>;

inline constexpr int kMostMotor = 4096;  ///< of either sign; what the field could carry is more

/// A command to the device.
struct Command {
  Motors motors{};      ///< of the three legs
  bool homing = false;  ///< look for the stops
  bool red = false, green = false, blue = false;
};

/// A reply of the device.
struct Reply {
  std::array<std::int16_t, 3> encoders{};  ///< counts, of the three legs
  std::uint8_t buttons = 0;                ///< bit 0 right (plus), 1 forward, 2 centre, 3 left
  std::uint8_t homed = 0;                  ///< bit n: leg n has been at its stops
  bool isHomed() const noexcept { return homed == 0b111; }
};

/// Motor values for the legs' torques [N·m]: -10,000 a newton metre, none beyond kMostMotor, all
/// three by one factor. Zero if one is not finite.
Motors motorsFor(const Vec3& torques) noexcept;

Packet encoded(const Command& command) noexcept;

/// The reply, or nothing if a letter is invalid.
std::optional<Reply> decoded(const Packet& packet) noexcept;

inline constexpr std::size_t kUsbPacket = 64;  ///< bytes, the longest

/// Splits what the USB chip delivers into replies. Packets come in pieces, joined, or with garbage
/// between; incomplete ones are dropped.
class ReplyStream {
 public:
  /// One transfer as it came: the two bytes of the chip's status that lead every 64 are passed
  /// over. Returns how many replies ended in it; `newest` becomes the last of them.
  int take(std::span<const std::uint8_t> transfer, Reply& newest) noexcept;
  /// Forgets the beginning of a packet.
  void clear() noexcept { length_ = 0; }

 private:
  Packet packet_{};
  std::size_t length_ = 0;
};

/// The bytes of one transfer of at most kUsbPacket without the chip's status.
std::span<const std::uint8_t> withoutStatus(std::span<const std::uint8_t> transfer) noexcept;

}  // namespace haptics::falcon
