// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/number_columns.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace app {
namespace {

constexpr std::size_t kMostOrder = 5;  // a sixth difference is hardly ever smaller
constexpr std::size_t kWhole = sizeof(std::uint64_t);

/// Signed numbers so that small ones have few bits.
std::uint64_t folded(std::uint64_t value) {
  return (value << 1) ^ (value >> 63 != 0 ? std::numeric_limits<std::uint64_t>::max() : 0);
}
std::uint64_t unfolded(std::uint64_t value) { return (value >> 1) ^ (0 - (value & 1)); }

/// The first value stays.
void difference(std::span<std::uint64_t> values) {
  for (std::size_t i = values.size(); i-- > 1;) values[i] -= values[i - 1];
}
void sum(std::span<std::uint64_t> values) {
  for (std::size_t i = 1; i < values.size(); ++i) values[i] += values[i - 1];
}

}  // namespace

void putPlanes(std::span<const std::uint64_t> values, std::size_t width,
               std::vector<std::uint8_t>& bytes) {
  for (std::size_t k = 0; k < width; ++k)
    for (const std::uint64_t value : values)
      bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
}

bool takePlanes(std::span<const std::uint8_t>& bytes, std::size_t width,
                std::span<std::uint64_t> values) {
  const std::size_t count = values.size();
  if (width > kWhole || bytes.size() < width * count) return false;
  std::ranges::fill(values, 0);
  for (std::size_t k = 0; k < width; ++k)
    for (std::size_t i = 0; i < count; ++i)
      values[i] |= std::uint64_t{bytes[k * count + i]} << (8 * k);
  bytes = bytes.subspan(width * count);
  return true;
}

void putDifferences(std::span<const std::uint64_t> values, std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint64_t> differences(values.begin(), values.end());
  std::vector<std::uint64_t> best(values.size()), tried(values.size());
  std::int64_t fewest = std::numeric_limits<std::int64_t>::max();
  std::size_t order = 0;
  for (std::size_t n = 0; n <= std::min(kMostOrder, values.size()); ++n) {
    if (n > 0) difference(differences);
    std::ranges::transform(differences, tried.begin(), folded);
    std::int64_t bits = 0;
    for (const std::uint64_t value : tried) bits += std::bit_width(value);
    if (bits >= fewest) continue;
    fewest = bits;
    order = n;
    best.swap(tried);
  }
  const auto first = std::span{best}.first(order), rest = std::span{best}.subspan(order);
  std::uint64_t any = 0;
  for (const std::uint64_t value : rest) any |= value;
  const auto width = static_cast<std::size_t>((std::bit_width(any) + 7) / 8);
  bytes.push_back(static_cast<std::uint8_t>(order));
  bytes.push_back(static_cast<std::uint8_t>(width));
  putPlanes(first, kWhole, bytes);
  putPlanes(rest, width, bytes);
}

bool takeDifferences(std::span<const std::uint8_t>& bytes, std::span<std::uint64_t> values) {
  if (bytes.size() < 2) return false;
  const std::size_t order = bytes[0], width = bytes[1];
  bytes = bytes.subspan(2);
  if (order > std::min(kMostOrder, values.size()) ||
      !takePlanes(bytes, kWhole, values.first(order)) ||
      !takePlanes(bytes, width, values.subspan(order)))
    return false;
  std::ranges::transform(values, values.begin(), unfolded);
  for (std::size_t n = 0; n < order; ++n) sum(values);
  return true;
}

}  // namespace app
