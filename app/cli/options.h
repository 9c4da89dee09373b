// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>

namespace app::cli {

// Checks of options. CLI11 accepts more than a user means: octal numbers, values that are not
// finite, and -1 as the greatest unsigned number.

/// A finite number, such as 0.5, -3 or 1e-6.
CLI::Validator finiteNumber();
/// Decimal digits without leading zeros, from `least` to `greatest`.
CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t greatest);
/// A text that is not empty.
CLI::Validator notEmpty();

/// The number that the whole of a text is.
template <class Number>
std::optional<Number> numberIn(const std::string& text) {
  Number number{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size()) return {};
  return number;
}
/// J/m3, of a text that says from 0.001 to 1000 J/mm3 what cutting a material takes.
std::optional<double> energyIn(const std::string& text);

}  // namespace app::cli
