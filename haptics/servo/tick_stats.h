// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "haptics/core/realtime.h"

namespace haptics {

/// Statistics of the ticks of the last second. It neither allocates nor sorts: times are counted in
/// bins 5 % apart.
class TickStats {
 public:
  /// Adds a tick that began at `now` [s] and took `cpu` [s].
  void add(double now, double cpu) HAPTICS_RT {
    const double bin = std::log(std::fmax(cpu, kLeast) / kLeast) / kStep;
    ++bins_[bin < double(kBins - 1) ? static_cast<std::size_t>(bin) : kBins - 1];
    ++count_;
    if (count_ == 1) begun_ = now;
    if (now - begun_ < 1.0) return;
    rate_ = double(count_ - 1) / (now - begun_);
    std::uint32_t above = 0;
    std::size_t i = kBins;
    while (i > 0 && above + bins_[i - 1] <= count_ / 100) above += bins_[--i];
    p99_ = kLeast * std::exp(kStep * double(i));
    bins_.fill(0);
    count_ = 0;
  }
  double rate() const HAPTICS_RT { return rate_; }  ///< Hz; 0 in the first second
  double p99() const HAPTICS_RT { return p99_; }    ///< s, rounded up by at most 5 %

 private:
  static constexpr double kLeast = 1e-7, kStep = 0.05;
  static constexpr std::size_t kBins = 320;  // up to 0.8 s
  std::array<std::uint32_t, kBins> bins_{};
  std::uint32_t count_ = 0;
  double begun_ = 0.0, rate_ = 0.0, p99_ = 0.0;
};

}  // namespace haptics
