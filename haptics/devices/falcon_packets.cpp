// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/falcon_packets.h"

#include <algorithm>
#include <cmath>

namespace haptics::falcon {
namespace {

constexpr std::size_t kStatus = 2, kControl = 13;

}  // namespace

Motors motorsFor(const Vec3& torques) noexcept {
  constexpr double kScale = -10'000.0;  // a newton metre
  const Vec3 wanted = kScale * torques;
  const double greatest = wanted.cwiseAbs().maxCoeff();
  if (!wanted.allFinite()) return {};
  const double factor = greatest > kMostMotor ? kMostMotor / greatest : 1.0;
  Motors motors;
  for (int i = 0; i < 3; ++i)
    motors[std::size_t(i)] = static_cast<std::int16_t>(std::lround(wanted[i] * factor));
  return motors;
}

Packet encoded(const Command& command) noexcept {
  Packet packet;
  packet.fill('A');
  packet.front() = '<';
  packet.back() = '>';
  for (std::size_t motor = 0; motor < 3; ++motor) {
    const auto value = static_cast<std::uint16_t>(command.motors[motor]);
    for (std::size_t nibble = 0; nibble < 4; ++nibble)
      packet[1 + 4 * motor + nibble] =
          static_cast<std::uint8_t>('A' + ((value >> (4 * nibble)) & 0xF));
  }
  packet[kControl] =
      static_cast<std::uint8_t>('A' + (command.homing ? 1 : 0) + (command.green ? 2 : 0) +
                                (command.blue ? 4 : 0) + (command.red ? 8 : 0));
  return packet;
}

std::optional<Reply> decoded(const Packet& packet) noexcept {
  if (packet.front() != '<' || packet.back() != '>') return std::nullopt;
  Reply reply;
  for (std::size_t leg = 0; leg < 3; ++leg) {
    unsigned value = 0;
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      const unsigned letter = packet[1 + 4 * leg + nibble] - unsigned{'A'};
      if (letter > 0xF) return std::nullopt;
      value |= letter << (4 * nibble);
    }
    reply.encoders[leg] = static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
  }
  const unsigned bits = packet[kControl] - unsigned{'A'};
  if (bits > 0x7F) return std::nullopt;
  reply.buttons = static_cast<std::uint8_t>(bits & 0xF);
  reply.homed = static_cast<std::uint8_t>(bits >> 4);
  return reply;
}

int ReplyStream::take(std::span<const std::uint8_t> transfer, Reply& newest) noexcept {
  int replies = 0;
  for (std::size_t i = 0; i < transfer.size(); ++i) {
    if (i % kUsbPacket < kStatus) continue;
    const std::uint8_t byte = transfer[i];
    if (byte == '<')
      length_ = 0;
    else if (length_ == 0)
      continue;
    packet_[length_++] = byte;
    if (byte != '>' && length_ < packet_.size()) continue;
    // here it ends: whole, too short, or too long
    const auto reply = length_ == packet_.size() ? decoded(packet_) : std::nullopt;
    length_ = 0;
    if (!reply) continue;
    newest = *reply;
    ++replies;
  }
  return replies;
}

std::span<const std::uint8_t> withoutStatus(std::span<const std::uint8_t> transfer) noexcept {
  return transfer.subspan(std::min(kStatus, transfer.size()));
}

}  // namespace haptics::falcon
