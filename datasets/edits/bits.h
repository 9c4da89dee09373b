// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

#include "haptics/core/volume.h"

namespace datasets {

/// One bit for each voxel of a grid. Each row along i begins with a new word.
class VoxelBits {
 public:
  explicit VoxelBits(const std::array<std::int64_t, 3>& dims)
      : dims_{dims},
        words_{(dims[0] + 63) / 64},
        bits_(static_cast<std::size_t>(words_ * dims[1] * dims[2])) {}

  std::int64_t wordsInRow() const { return words_; }
  const std::array<std::int64_t, 3>& dims() const { return dims_; }
  std::uint64_t* row(std::int64_t j, std::int64_t k) {
    return bits_.data() + (k * dims_[1] + j) * words_;
  }
  const std::uint64_t* row(std::int64_t j, std::int64_t k) const {
    return bits_.data() + (k * dims_[1] + j) * words_;
  }
  /// Null beyond the grid.
  const std::uint64_t* rowOrNull(std::int64_t j, std::int64_t k) const {
    return j < 0 || k < 0 || j >= dims_[1] || k >= dims_[2] ? nullptr : row(j, k);
  }
  bool at(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return (row(j, k)[i >> 6] >> (i & 63) & 1) != 0;
  }
  std::vector<std::uint64_t>& words() { return bits_; }
  const std::vector<std::uint64_t>& words() const { return bits_; }

 private:
  std::array<std::int64_t, 3> dims_;
  std::int64_t words_;
  std::vector<std::uint64_t> bits_;
};

/// Sets the bits first <= i < end of a row.
inline void setBits(std::uint64_t* row, std::int64_t first, std::int64_t end) {
  for (std::int64_t i = first; i < end;) {
    const std::int64_t in_word = std::min<std::int64_t>(end - i, 64 - (i & 63));
    const std::uint64_t ones =
        in_word == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << in_word) - 1;
    row[i >> 6] |= ones << (i & 63);
    i += in_word;
  }
}

/// Calls each(first, end) for the runs of set bits of a row of `words` words.
template <class F>
void eachRun(const std::uint64_t* row, std::int64_t words, F&& each) {
  std::int64_t first = -1;
  for (std::int64_t w = 0; w < words; ++w) {
    std::uint64_t word = row[w];
    if (first < 0 && word == 0) continue;
    if (first >= 0 && word == ~std::uint64_t{0}) continue;
    int bit = 0;
    while (bit < 64) {
      const std::uint64_t rest = word >> bit;
      if (first < 0) {
        if (rest == 0) break;
        bit += std::countr_zero(rest);
        first = w * 64 + bit;
      } else {
        const int ones = std::countr_one(rest);
        if (bit + ones >= 64) break;
        bit += ones;
        each(first, w * 64 + bit);
        first = -1;
      }
    }
  }
  if (first >= 0) each(first, words * 64);
}

}  // namespace datasets
