// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include "haptics/recording/columns.h"

namespace app::exporting {

/// The column of this name, which there is.
const haptics::StepColumn& columnNamed(std::string_view name);

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
