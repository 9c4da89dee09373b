// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/allowed_stiffness.h"

#include <algorithm>

#include "haptics/simulation/device_model.h"

namespace haptics {
namespace {

constexpr double kShare = 0.45;   // of the limit of a sampled spring
constexpr double kMissing = 0.9;  // N·m/rad about the pivot: more gives over 0.8 mJ a turn

double shareOfLimit(double damping, const Timing& timing) {
  return kShare * 2.0 * damping / (timing.period + 2.0 * timing.delay);
}

/// How much softer the angular spring must be about the axis across which the tool is longest.
double roundness(const Mat3& inertia) { return inertia.trace() / 3.0 / largestInertia(inertia); }

}  // namespace

double allowedStiffness(const DeviceRating& rating, const PointShell& shell, const Timing& timing,
                        double arm) {
  constexpr int kTurns = 6;  // degrees of freedom of a handle whose turning is sensed
  double allowed = shareOfLimit(DeviceModel{}.damping + HumanHand{}.damping, timing);
  if (rating.torque > 0.0) {
    allowed *= roundness(shell.inertia);
  } else if (rating.sensed >= kTurns) {
    const double reach2 = shell.radius * shell.radius, inertia = largestInertia(shell.inertia);
    if (reach2 > 0.0)
      allowed = std::min(allowed, kMissing * (inertia + reach2) / (reach2 * inertia));
    if (arm > 0.0) allowed = std::min(allowed, kMissing / (arm * arm));
  }
  return std::min(rating.stiffness, allowed);
}

double allowedStiffness(const Grip& grip, const PointShell& shell, double period) {
  return shareOfLimit(grip.damping, {period}) * roundness(shell.inertia);
}

}  // namespace haptics
