// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace app::cli {

// Checks of options. CLI11 accepts more than a user means: octal numbers, values that are not
// finite, and -1 as the greatest unsigned number.

/// A finite number, such as 0.5, -3 or 1e-6.
CLI::Validator finiteNumber();
/// Decimal digits without leading zeros, from `least` to `greatest`.
CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t greatest);
/// A text that is not empty.
CLI::Validator notEmpty();

}  // namespace app::cli
