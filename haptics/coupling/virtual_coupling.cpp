// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/coupling/virtual_coupling.h"

#include <numbers>

namespace haptics {
namespace {
constexpr double kLargestTurn = 150.0 / 180.0 * std::numbers::pi;  // rad

Vec3 shortened(const Vec3& v, double limit) HAPTICS_RT {
  const double size = v.norm();
  return size > limit ? Vec3{v * (limit / size)} : v;
}
}  // namespace

Wrench VirtualCoupling::pull(const Pose& X_WP, const Pose& X_WD, const Vec3& turn,
                             const Mat3& inertia_W) const HAPTICS_RT {
  const Vec3 twist = shortened(turn, kLargestTurn);
  return {.force = stiffness * (X_WP.translation() - X_WD.translation()),
          .torque = angular_stiffness > 0.0 ? Vec3{angular_stiffness * twist}
                                            : Vec3{stiffness * (inertia_W * twist)}};
}

Wrench saturated(const Wrench& wrench, double max_force, double max_torque) HAPTICS_RT {
  if (!wrench.force.allFinite() || !wrench.torque.allFinite()) return {};
  return {.force = shortened(wrench.force, max_force),
          .torque = shortened(wrench.torque, max_torque)};
}

}  // namespace haptics
