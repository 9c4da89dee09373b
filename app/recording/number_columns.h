// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace app {

// Columns of numbers as bytes, without loss. `put…` appends a column to `bytes`; `take…` reads one
// from the front of `bytes`, moves the front behind it, and returns false if it is not one. All
// arithmetic is modulo 2^64.

/// The lowest bytes of all values, then the next bytes, and so on: so bytes that hardly change are
/// adjacent. Keeps the lowest `width` bytes of each value.
void putPlanes(std::span<const std::uint64_t> values, std::size_t width,
               std::vector<std::uint8_t>& bytes);
bool takePlanes(std::span<const std::uint8_t>& bytes, std::size_t width,
                std::span<std::uint64_t> values);

/// The differences from value to value, as often differenced as makes them small: a hand moves
/// smoothly, and the bits of a double, read as a whole number, do too. Two bytes, how often (n) and
/// the width; the first n differences in eight bytes each, as they have nothing before them; then
/// the others in this width; both as planes. A difference d is stored as 2d, or as -2d - 1 if it is
/// negative.
void putDifferences(std::span<const std::uint64_t> values, std::vector<std::uint8_t>& bytes);
bool takeDifferences(std::span<const std::uint8_t>& bytes, std::span<std::uint64_t> values);

/// The most bytes of a column of so many values, by either way.
constexpr std::size_t mostColumnBytes(std::size_t count) {
  return 2 + sizeof(std::uint64_t) * count;
}

}  // namespace app
