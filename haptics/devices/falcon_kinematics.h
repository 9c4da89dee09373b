// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "haptics/core/geometry.h"

// The linkage of the Novint Falcon: three legs between the base and the grip, of which theta1 of
// each is driven and measured. Geometry and angles after R. E. Stamper's thesis as libnifalcon
// (BSD) has them, derived anew: libnifalcon's velocity Jacobian has sin^2 theta2 in its z column,
// where the derivative is sin theta2 sin theta3.
//
// B has its axes as libnifalcon's frame has them (x right, y up, z out of the casing towards the
// user), and its origin in the middle of the workspace, 125 mm out. Not verified on hardware: the
// signs of the axes, the workspace's 75 to 175 mm, which encoder belongs to which leg.
//
// Nothing here allocates, and nothing keeps a state: any thread.

namespace haptics::falcon {

/// Angles of the three legs [rad]: theta1 of the driven arm, theta2 of the rods in the leg's
/// plane, theta3 of the rods out of it.
struct LegAngles {
  Vec3 theta1 = Vec3::Zero(), theta2 = Vec3::Zero(), theta3 = Vec3::Zero();
};

/// theta1 of a leg by its encoder, once it is homed [rad].
double angleOf(std::int16_t encoder) noexcept;

/// The legs with the grip at `p_B` [m], or nothing: they do not reach there.
std::optional<LegAngles> legsAt(const Vec3& p_B) noexcept;

/// Where the grip is [m] when the driven arms stand at `theta1` [rad]: a Newton iteration from
/// `start_B`, and if need be from the middle, of 20 steps each at most. Nothing: it did not
/// converge, or the place is outside what the grip can reach.
std::optional<Vec3> positionOf(const Vec3& theta1, const Vec3& start_B) noexcept;

/// J of d theta1/dt = J v_B [rad/m].
Mat3 velocityJacobian(const LegAngles& legs) noexcept;

/// The torques of the three driven arms [N·m] that make the grip push the hand by `force_B` [N]:
/// J^-T F, so that torque · d theta1 = F · dx. Their norm is kMostTorque at most, by one factor
/// for all three, which keeps the force's direction. Zero where J is close to singular or anything
/// is not finite.
Vec3 torquesFor(const LegAngles& legs, const Vec3& force_B) noexcept;

inline constexpr double kMostTorque = 0.7;  ///< N·m, norm: what 8 N take; not verified

}  // namespace haptics::falcon
