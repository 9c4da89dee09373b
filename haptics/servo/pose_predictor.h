// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <numbers>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// Extrapolates the pose of a handle by the time in which its force comes late.
///
/// A force that is late by d belongs to where the handle was, so a sampled loop carries a spring of
/// 2 b / (T + 2 d) instead of 2 b / T. If the tick takes the pose in which the handle will be when
/// the force arrives, it carries as much as without the delay. The velocity is the mean over the
/// last millisecond, so the error is the acceleration times d (d + 1 ms) / 2: less than a
/// micrometre for 0.125 ms and 10 m/s^2. A reading that is wrong by x comes again a millisecond
/// later as -x d / 1 ms.
///
/// A step of the encoder would grow by d over a millisecond, ahead of a handle that is slow, and
/// that feeds its motion: on top of a ball, a handle with steps of 10 um circled for good. So the
/// linear velocity is the mean over the last 8 ms if the way since was straight to within a step on
/// each axis. Windows that adapt to the motion are due to Janabi-Sharifi, Hayward and Chen,
/// "Discrete-time adaptive windowing for velocity estimation" (2000); those between 1 and 8 ms that
/// they use as well, delay what shakes, and the loop carries up to a quarter less.
class PosePredictor {
 public:
  /// `lead` [s]. `step` [m]: of the encoders at the handle; 0: exact.
  PosePredictor(double lead, double step) : lead_{lead}, straight_{std::numbers::sqrt3 * step} {}

  /// The pose at `lead` [s] after the measurement of `X` at `time_ns`. It is X itself for the first
  /// millisecond, and after a gap. The same time again gives the same pose. Numbers that are not
  /// finite are returned, and not remembered.
  Pose ahead(const Pose& X, std::int64_t time_ns) HAPTICS_RT;
  /// Begins anew: what comes next has nothing to do with what was before.
  void forget() HAPTICS_RT { count_ = 0; }

 private:
  static constexpr std::int64_t kWindow_ns = 1'000'000, kLongWindow_ns = 8'000'000;
  static constexpr std::int64_t kEarly_ns = 100'000;  // by which a reading may come
  static constexpr std::int64_t kGap_ns = 5'000'000;
  struct Reading {
    Pose X;
    std::int64_t time_ns;
  };
  /// The reading n before the next one.
  const Reading& ago(std::size_t n) const HAPTICS_RT {
    return readings_[(count_ - n) % readings_.size()];
  }
  /// How many readings ago a window began, or 0 if the readings do not go back so far.
  std::size_t beginOf(std::int64_t window_ns, std::int64_t time_ns) const HAPTICS_RT;
  /// Whether the readings since the n-th lie on the line from there to `p`, each at its time.
  bool isStraight(std::size_t n, const Vec3& p, std::int64_t time_ns) const HAPTICS_RT;

  double lead_;                       ///< s
  double straight_;                   ///< m: farther from a line is a bend
  std::array<Reading, 40> readings_;  ///< 8 ms at 4 kHz, and a few that come early
  std::size_t count_ = 0;             ///< since the start, or since a gap
  Pose X_ahead_ = Pose::Identity();
};

}  // namespace haptics
