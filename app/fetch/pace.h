// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "app/fetch/archive.h"

namespace app::fetch {

/// Whether a server is silent, or slower than is waited for. Bytes may be counted on any thread;
/// one thread looks.
class Pace {
 public:
  enum class Verdict { Fine, Silent, Slow };
  using Clock = std::chrono::steady_clock;

  explicit Pace(double patience_s)
      : patience_{std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(patience_s))} {}

  /// Waiting begins now.
  void restart() { seen_ = bytes_, window_ = bytes_, heard_at_ = window_at_ = Clock::now(); }
  void came(std::uint64_t bytes) { bytes_ += bytes; }
  std::uint64_t bytes() const { return bytes_; }

  Verdict look() {
    const auto now = Clock::now();
    const std::uint64_t bytes = bytes_;
    if (bytes != seen_) seen_ = bytes, heard_at_ = now;
    if (now - heard_at_ > patience_) return Verdict::Silent;
    if (now - window_at_ <= patience_) return Verdict::Fine;
    const double seconds = std::chrono::duration<double>(now - window_at_).count();
    const bool slow = static_cast<double>(bytes - window_) < seconds * double(kLeastRate_B_s);
    // one that has stopped is silent, which shows a little later
    if (slow && now - heard_at_ > patience_ / 2) return Verdict::Fine;
    window_ = bytes, window_at_ = now;
    return slow ? Verdict::Slow : Verdict::Fine;
  }

 private:
  Clock::duration patience_;
  std::atomic<std::uint64_t> bytes_{0};
  std::uint64_t seen_ = 0, window_ = 0;
  Clock::time_point heard_at_ = Clock::now(), window_at_ = Clock::now();
};

}  // namespace app::fetch
