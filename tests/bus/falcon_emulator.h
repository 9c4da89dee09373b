// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>

#include "haptics/core/geometry.h"
#include "tests/bus/usb_port.h"

namespace bus {

/// A Novint Falcon, as far as its public protocol tells: the FTDI chip, the loader that echoes a
/// firmware, three legs that a hand holds. What the motors would do is worked out from the legs'
/// angles by differences, without the drivers' Jacobian. Its motors
/// move nothing: the hand is stronger. Any thread.
///
/// Its frame F: x to the user's right, y up, z towards the user, origin in its base.
class FalconEmulator final : public UsbFunction {
 public:
  static constexpr double kHandSpeed = 0.2;  ///< m/s

  /// What goes wrong from now on.
  struct Faults {
    std::size_t most_bytes = 62;  ///< of a reply that one packet carries
    bool mute = false;            ///< commands are obeyed, not answered
    bool wrong_echo = false;      ///< while firmware loads
    int garble = 0;               ///< so many replies to come have a letter that is none
    /// Of replies. As it stands some thousand of them come in a second, which is what is reported
    /// of real ones.
    std::chrono::microseconds delay{500};
  };

  /// What has arrived so far.
  struct Seen {
    std::uint64_t commands = 0;
    std::uint64_t malformed = 0;     ///< bytes outside of commands, and commands that are none
    std::uint64_t forced_early = 0;  ///< commands with a motor value before it was homed
    std::array<int, 3> motors{};     ///< of the last command
    int largest = 0;                 ///< of all motor values, absolute
    std::uint64_t forced = 0;        ///< commands with a motor value
    int control = 0;                 ///< of the last command: bit 0 homing, 1 green, 2 blue, 3 red
    Bytes firmware;                  ///< what the loader took
  };

  /// `loaded`: firmware is in it, from an earlier program.
  explicit FalconEmulator(bool loaded) : loaded_{loaded} {}

  /// The hand takes the grip there [m] at kHandSpeed.
  void hold(const haptics::Vec3& p_F);
  void press(int buttons);  ///< bits 0 to 3
  /// The user pulls the grip out and pushes it in: true if the device was waiting for it.
  bool home();
  /// Encoders lose their place by so many counts. What had arrived until then.
  Seen jump(int counts);
  /// Bytes that an earlier program did not fetch.
  void leave(const Bytes& stale);
  Seen fail(const Faults& faults);  ///< what had arrived until then

  Seen seen() const;
  haptics::Vec3 force_F() const;  ///< N, of the last motor values where the grip is now
  /// What such motor values come to in there, N.
  static haptics::Vec3 forceOf(const std::array<int, 3>& motors, const haptics::Vec3& p_F);

  Bytes deviceDescriptor() const override;
  Bytes configuration() const override;
  std::vector<std::string> strings() const override;
  std::optional<Bytes> control(const Setup& setup, std::span<const std::uint8_t> out) override;
  void received(int endpoint, std::span<const std::uint8_t> bytes) override;
  std::optional<Bytes> toSend(int endpoint, std::size_t room) override;

 private:
  using Clock = std::chrono::steady_clock;
  enum class Line : std::uint8_t { Other, Boot, Loader, Normal };
  struct Late {
    Clock::time_point due;
    Bytes bytes;
  };

  void take(std::uint8_t byte);
  void obey();
  Bytes reply();
  void dropAll();
  haptics::Vec3 gripNow() const;

  mutable std::mutex mutex_;
  bool loaded_;
  bool homed_ = false;
  std::array<int, 3> lost_{1234, -567, 890};  // counts, until it is homed
  // the grip is under way from one to the other
  haptics::Vec3 from_F_{0.0, 0.0, 0.125}, to_F_ = from_F_;
  Clock::time_point left_at_{};
  int buttons_ = 0;
  Faults faults_;
  Seen seen_;

  Line line_ = Line::Other;
  bool data_terminal_ready_ = false;
  std::chrono::milliseconds latency_{16};
  Clock::time_point sent_at_{};
  Bytes command_;
  bool loading_ = false;
  std::deque<std::uint8_t> to_host_;
  std::deque<Late> late_;
};

}  // namespace bus
