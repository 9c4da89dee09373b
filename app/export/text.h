// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include "app/recording/columns.h"

namespace app::exporting {

/// The column with this name, which must exist.
const StepColumn& columnNamed(std::string_view name);

/// Appends the shortest digits that round-trip to the same number.
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

/// Makes one line of valid UTF-8. Terminal control characters and field separators become spaces;
/// invalid bytes become the replacement character.
std::string plain(std::string text);

}  // namespace app::exporting
