// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/proxy/proxy.h"
#include "haptics/scene/scene.h"
#include "haptics/scene/watch.h"

namespace haptics {

/// A spring that gives way in series with the coupling's, for one of force and torque: tissue of
/// stiffness c times the coupling's, damped [Kelvin-Voigt]. Its numbers are in the unit of the
/// wrench: what the coupling would pull if the tool lay there.
///
/// It is passive whatever c becomes from tick to tick. A rise of c would add energy to a spring
/// that is bent, so its rest moves along as far as the energy asks for; and it never holds the hand
/// back on its way out.
class YieldingSpring {
 public:
  /// What is left of `pull` in this tick. c > 0, infinity: rigid. `period` [s].
  Vec3 pass(const Vec3& pull, double c, double period) HAPTICS_RT;

 private:
  Vec3 given_ = Vec3::Zero();  ///< how far the tissue has given way
  Vec3 rest_ = Vec3::Zero();   ///< where its spring is at rest
  double c_ = 0.0;             ///< of the last tick
};

/// What structures make of the wrench on the hand. With none that is softer or guarded, it is not
/// one bit different. Servo thread.
class Felt {
 public:
  /// `pulled`: the coupling's wrench with this stiffness [N/m], X_WD the device, and the proxy
  /// after the tick.
  Wrench shaped(const Watch& watch, const Scene& scene, const Proxy& proxy, const Pose& X_WD,
                double stiffness, const Wrench& pulled, double period) HAPTICS_RT;
  /// The state before the first tick.
  void forget() HAPTICS_RT { *this = {}; }

 private:
  YieldingSpring force_, torque_;
  double compliance_ = 0.0;  ///< m/N, of what the tool touches or touched last
};

/// The wrench about X_WD's origin that keeps the tool away from a guarded structure: the gradient
/// of a potential of the least distance of its points, so a closed path gives no energy. The least
/// is rounded where points are about as near, so that the force turns from one to the next along a
/// way of half a millimetre. It rises from 0 within the margin to Feel::most at the structure, and
/// stays that within.
Wrench guardAt(const Watch::Watched& guarded, const Scene& scene, const Pose& X_WD) HAPTICS_RT;

}  // namespace haptics
