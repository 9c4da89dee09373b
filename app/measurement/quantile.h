// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace measurement {

/// The least of the sorted values that a share q of them does not exceed, by nearest rank, so that
/// of few the tail is the greatest; 0 for none.
inline double quantile(std::span<const double> sorted, double q) {
  if (sorted.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(q * double(sorted.size()) - 1e-9));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

}  // namespace measurement
