// SPDX-License-Identifier: BSD-3-Clause
// Any bytes from a Falcon's USB chip: as replies, through the link that makes readings and forces
// of them, and as answers to the loading of firmware.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>

#include "haptics/devices/falcon.h"
#include "haptics/devices/falcon_kinematics.h"
#include "haptics/devices/falcon_packets.h"
#include "tests/fuzz/require.h"
#include "tests/support/scratch_folder.h"

namespace {

using haptics::falcon::Packet;
using haptics::falcon::Sent;
using Bytes = std::span<const std::uint8_t>;

/// The next transfer of the input: a byte with its length, then the bytes.
Bytes nextTransfer(Bytes& input) {
  if (input.empty()) return {};
  const std::size_t length = std::min<std::size_t>(input[0] % 65, input.size() - 1);
  const Bytes transfer = input.subspan(1, length);
  input = input.subspan(1 + length);
  return transfer;
}

void requireWithinLimits(const haptics::falcon::Motors& motors) {
  for (const std::int16_t motor : motors)
    fuzz::require(std::abs(motor) <= haptics::falcon::kMostMotor, "no motor beyond its range");
}

void takeApart(Bytes input) {
  haptics::falcon::ReplyStream stream;
  haptics::falcon::Reply reply;
  while (!input.empty()) {
    const Bytes transfer = nextTransfer(input);
    const int replies = stream.take(transfer, reply);
    fuzz::require(replies >= 0 && std::size_t(replies) <= transfer.size(), "no more than came");
    if (replies == 0) continue;
    haptics::Vec3 theta1;
    for (int i = 0; i < 3; ++i)
      theta1[i] = haptics::falcon::angleOf(reply.encoders[std::size_t(i)]);
    const auto p_B = haptics::falcon::positionOf(theta1, haptics::Vec3::Zero());
    if (!p_B) continue;
    fuzz::require(p_B->norm() < 0.1, "a place within reach");
    const auto legs = haptics::falcon::legsAt(*p_B);
    fuzz::require(legs && (legs->theta1 - theta1).norm() < 1e-8, "whose legs stand as they said");
    const haptics::Vec3 torques = haptics::falcon::torquesFor(*legs, {50.0, -20.0, 80.0});
    fuzz::require(torques.norm() < 1.01 * haptics::falcon::kMostTorque, "torques are limited");
    requireWithinLimits(haptics::falcon::motorsFor(torques));
  }
}

/// Says what the input says, whatever is sent.
class Scripted final : public haptics::falcon::FalconPort {
 public:
  Scripted(Bytes input, bool runs) : input_{input}, runs_{runs} {}
  bool request(std::uint8_t, std::uint16_t) noexcept override { return true; }
  Sent send(Bytes bytes) noexcept override {
    if (!input_.empty() && input_[0] == 0xFF) return Sent::Gone;
    if (!input_.empty() && input_[0] == 0xFE) return input_ = input_.subspan(1), Sent::Busy;
    if (bytes.size() != 16 || !runs_) return Sent::Taken;
    Packet packet;
    std::copy(bytes.begin(), bytes.end(), packet.begin());
    const auto command = haptics::falcon::decoded(packet);
    fuzz::require(command.has_value(), "a packet of the protocol");
    requireWithinLimits(command->encoders);
    if (!homed_)
      fuzz::require(command->encoders == haptics::falcon::Motors{}, "no force before it is homed");
    return Sent::Taken;
  }
  std::optional<std::size_t> receive(std::span<std::uint8_t> transfer,
                                     std::chrono::nanoseconds wait) noexcept override {
    if (runs_ && !greeted_) {
      greeted_ = true;
      constexpr std::string_view kReply = "\x01\x60<AAAAAAAAAAAAAA>";
      std::copy(kReply.begin(), kReply.end(), transfer.begin());
      return kReply.size();
    }
    if (!input_.empty() && input_[0] == 0xFF) return std::nullopt;
    const Bytes next = nextTransfer(input_);
    clock_ += next.empty() ? wait.count() : 50'000;
    std::copy(next.begin(), next.end(), transfer.begin());
    // only these letters say that all legs are homed
    for (const std::uint8_t byte : next) homed_ |= byte >= 'A' + 112 && byte <= 'A' + 127;
    return next.size();
  }
  std::int64_t now() const noexcept override { return clock_; }

 private:
  Bytes input_;
  std::int64_t clock_ = 1;
  const bool runs_;
  bool greeted_ = false, homed_ = false;
};

void exchange(Bytes input) {
  auto link = haptics::falcon::linkTo(std::make_unique<Scripted>(input, true), {});
  if (!link) return;
  haptics::DeviceReading reading;
  for (int n = 0; n < 60; ++n) {
    const auto status = (*link)->exchange({.force = {3.0, 1.0 * n, -2.0}}, reading);
    fuzz::require(reading.X_BD.matrix().allFinite() && reading.X_BD.translation().norm() < 0.1,
                  "a place within reach");
    if (status == haptics::DeviceStatus::Lost) break;
  }
}

void load(Bytes input) {
  static const support::ScratchFolder scratch;
  static const auto firmware = scratch.write("firmware", std::string(150, 'f'));
  const auto link = haptics::falcon::linkTo(std::make_unique<Scripted>(input, false), firmware);
  if (!link)
    fuzz::require(!link.error().message.empty() && !link.error().reason.empty(),
                  "a refusal has a sentence and a reason");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const Bytes rest{bytes + 1, size - 1};
  switch (bytes[0] % 3) {
    case 0:
      takeApart(rest);
      break;
    case 1:
      exchange(rest);
      break;
    default:
      load(rest);
      break;
  }
  return 0;
}
