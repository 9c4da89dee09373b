// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// What a simulated hand does once it has found the surface.
enum class HandMotion { Tap, Slide, Wedge, Pry, Hook, Jerk, Twist };

/// Where a hand wants the tool to be over time, as a pure function of it.
class Hand {
 public:
  /// At time t [s], t >= 0.
  Pose at(double t) const HAPTICS_RT;

  /// A recorded path: poses at times that increase; held before and after, linear and slerp
  /// between.
  static Expected<Hand> along(std::vector<double> times, std::vector<Pose> poses);

  /// Aims a motion from outside the volume at the surface: the tool's tip (-z) leads along one of
  /// the directions around the solid's middle, and the nearest surface that can be pressed on
  /// rather than slipped off is chosen. `reach` [m] is how far beyond the surface the hand goes;
  /// deterministic for a seed.
  static Expected<Hand> aimed(HandMotion motion, const Scene& scene, double isovalue, double reach,
                              std::uint64_t seed);

  /// How far a hand must aim beyond the surface [m] for the device to end up `depth` beyond it
  /// when coupling and grip are springs in series.
  static double reachFor(double depth, double coupling_stiffness, double grip_stiffness) {
    return depth * (1.0 + coupling_stiffness / grip_stiffness);
  }

 private:
  Hand() = default;
  Pose scripted(double t) const HAPTICS_RT;

  // recorded
  std::vector<double> times_;
  std::vector<Pose> poses_;
  // scripted
  HandMotion motion_ = HandMotion::Tap;
  Pose X_WA_ = Pose::Identity();  ///< first touch
  Vec3 in_ = -Vec3::UnitZ();      ///< into the surface
  Vec3 side_ = Vec3::UnitX();     ///< along it
  Vec3 other_ = Vec3::UnitY();
  double reach_ = 0.0;     ///< m
  double approach_ = 0.0;  ///< m: from outside the volume to the first touch
  std::uint64_t seed_ = 0;
};

}  // namespace haptics
