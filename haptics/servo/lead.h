// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// Extrapolates the pose of a handle by the time in which its force comes late.
///
/// A force that is late by d belongs to where the handle was, so a sampled loop carries a spring of
/// 2 b / (T + 2 d) instead of 2 b / T. If the tick takes the pose in which the handle will be when
/// the force arrives, it carries as much as without the delay. The velocity is the mean over the
/// last millisecond, so the error is the acceleration times d (d + 1 ms) / 2: less than a
/// micrometre for 0.125 ms and 10 m/s^2. A step of the encoder grows by d over a millisecond, and a
/// reading that is wrong by x comes again a millisecond later as -x d / 1 ms.
class Lead {
 public:
  explicit Lead(double lead) : lead_{lead} {}

  /// The pose at `lead` [s] after the measurement of `X` at `time_ns`. It is X itself for the first
  /// millisecond, and after a gap. The same time again gives the same pose. Numbers that are not
  /// finite are returned, and not remembered.
  Pose ahead(const Pose& X, std::int64_t time_ns) HAPTICS_RT;
  /// Begins anew: what comes next has nothing to do with what was before.
  void forget() HAPTICS_RT { count_ = 0; }

 private:
  static constexpr std::int64_t kWindow_ns = 900'000;  // at least; a reading may come early
  static constexpr std::int64_t kGap_ns = 5'000'000;
  struct Reading {
    Pose X;
    std::int64_t time_ns;
  };
  double lead_;  ///< s
  std::array<Reading, 8> readings_;
  std::size_t count_ = 0;  ///< since the start, or since a gap
  Pose X_ahead_ = Pose::Identity();
};

}  // namespace haptics
