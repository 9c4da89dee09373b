// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <string>

namespace app::exporting {

/// What a step's force_state and flags mean, as every format tells it.
inline constexpr const char* kForceStateMeaning =
    "0 off, 1 ready, 2 armed, 3 ramping, 4 on, 5 fault";
inline constexpr const char* kFlagsMeaning =
    "sum of 1 another scene, 2 a setting moved, 4 the user lets forces be, 8 the device gave no "
    "reading, 16 it gave its last reading again, 32 for the third time in a row, 64 it is not "
    "homed, "
    "128 the clutch is held, 256 hold-to-run is not, 512 no tick for 5 ms before this one, 1024 "
    "the "
    "device is too fast for force, 2048 faster than a hand, 4096 the third gap in ten seconds, "
    "8192 of "
    "the settings the stiffness moved";

/// The fewest digits that read as the same number.
template <class Number>
void appendNumber(std::string& text, Number number) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}
template <class Number>
std::string numberOf(Number number) {
  std::string text;
  appendNumber(text, number);
  return text;
}

/// One line of sound UTF-8: what controls a terminal or ends a field becomes a space, what is no
/// character a replacement.
std::string plain(std::string text);

}  // namespace app::exporting
