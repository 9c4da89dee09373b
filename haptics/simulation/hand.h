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

/// The motion of a simulated hand after it has found the surface.
enum class HandMotion { Tap, Slide, Wedge, Pry, Hook, Jerk, Twist, Plunge, Mill, Hollow };

/// The pose that a hand wants for the tool, as a pure function of time.
class Hand {
 public:
  /// The pose at time t [s], t >= 0.
  Pose at(double t) const HAPTICS_RT;

  /// A recorded path: poses at increasing times [s]. Constant before the first and after the last;
  /// linear interpolation and slerp between.
  static Expected<Hand> along(std::vector<double> times, std::vector<Pose> poses);

  /// Aims a motion from outside the volume at the surface: the tool's tip (-z) leads along one of
  /// the directions around the solid's middle. The nearest surface on which a press does not slip
  /// off is chosen. `reach` [m] is the way of the hand beyond the surface. Deterministic for a
  /// seed.
  static Expected<Hand> aimed(HandMotion motion, const Scene& scene, double isovalue, double reach,
                              std::uint64_t seed);

  /// The same motion at the surface that the tool meets first from X_WT along its tip (-z).
  static Expected<Hand> from(const Pose& X_WT, HandMotion motion, const Scene& scene,
                             double isovalue, double reach, std::uint64_t seed);

  /// The reach [m] that brings the device `depth` [m] beyond the surface, with coupling and grip as
  /// springs in series.
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
  Vec3 side_ = Vec3::UnitX();     ///< unit, along the surface
  Vec3 other_ = Vec3::UnitY();
  double reach_ = 0.0;     ///< m
  double approach_ = 0.0;  ///< m: from outside the volume to the first touch
  std::uint64_t seed_ = 0;
};

}  // namespace haptics
