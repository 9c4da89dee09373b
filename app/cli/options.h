// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace app::cli {

// Checks of options. What the command line's library takes is wider than what a user means: numbers
// in octal, what is no finite number, and -1 as the greatest of the naturals.

/// A number that is finite, as 0.5, -3 or 1e-6.
CLI::Validator finiteNumber();
/// Decimal digits without leading zeros, within bounds.
CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t greatest);
/// Some text.
CLI::Validator notEmpty();

}  // namespace app::cli
