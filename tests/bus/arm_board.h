// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <string>

#include "haptics/core/geometry.h"
#include "tests/bus/uhid_port.h"

namespace bus {

/// A WoodenHaptics: its mbed board (1234:0006) through uhid, which answers each command with its
/// encoders, and an arm whose handle a hand leads. Any thread.
class ArmBoardEmulator {
 public:
  ArmBoardEmulator();

  /// The zero button is pressed; it stays so until the encoders are set.
  void askForZero();
  /// The hand goes there [m in B], at 0.2 mm a command. It begins at the arm's rest pose.
  void lead(const haptics::Vec3& p_B);
  bool isThere() const;
  /// What its motors do at the handle under the last command [N in B], by differences of its own
  /// geometry.
  haptics::Vec3 force_B() const;
  long commands() const;  ///< that it has heard
  long forced() const;    ///< of them, with any current
  std::string node() const { return port_.node(); }

 private:
  using Words = std::array<std::int16_t, 7>;
  void hear(std::span<const std::uint8_t> report);

  mutable std::mutex mutex_;
  haptics::Vec3 hand_, goal_;
  std::array<int, 3> zero_{};  ///< what the encoders count at angle 0
  Words last_{};
  bool asks_ = false;
  long commands_ = 0, forced_ = 0;
  UhidPort port_;
};

}  // namespace bus
