// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/devices/capstan_board.h"
#include "haptics/devices/catalogue.h"

namespace haptics {

// Polhem, an open capstan-driven arm: six encoders, three motors, behind the board of
// capstan_board.h. The parameters and the arm's geometry are those that its makers published
// (haptikfabrikenapi and hfabapi, model polhem_v3, of December 2020); the formulas here are our
// own.
// Not verified on hardware: all signs, the order of the gimbal's encoders, and the gimbal's counts
// per turn on newer boards.
// Not compensated: the arm's own weight.

/// The encoders' counts in the rest pose: the arm folded back to its stops, as its makers' program
/// has it.
inline constexpr BoardCounts kPolhemRest{8312, -10366, 19764, 0, 30, 0};

/// The angles of the six bodies, rad, from their encoders.
using PolhemAngles = std::array<double, 6>;
PolhemAngles polhemAngles(const BoardCounts& counts) noexcept;

/// The arm in one pose.
///
/// A body turns by a about the vertical. In its plane, with r away from the axis and z up, two
/// pivots stand at r = ±L0/2, L0 = 34 mm. From the outer one the upper arm, L1 = 165 mm, goes at
/// angle b to the elbow E; from the inner one a crank, L2 = 25 mm, at angle c to its end K. Through
/// E goes the forearm at angle l: its long end, L5 = 130.8 mm, carries the gimbal G, its short one,
/// L4 = 34 mm, is held by a rod of L3 = 190 mm to K. So
///
///   E = (L0/2, 0) + L1 u(b)    K = (-L0/2, 0) + L2 u(c)    u(t) = (cos t, sin t)
///   C = E - L4 u(l)    |C - K| = L3    G = E + L5 u(l)
///
/// of which the solution is taken where, seen from E, C is clockwise of K. Differentiated, with
/// n(t) = u'(t) and w = C - K:
///
///   dl = (L1 w.n(b) db - L2 w.n(c) dc) / (L4 w.n(l))    dG = L1 n(b) db + L5 n(l) dl
///
/// The gimbal turns the handle by d about the forearm, by e across it, by f about the stylus. All
/// angles zero: no rotation.
///
/// Nothing where the rod does not reach, or is within a degree of its dead points, where forces on
/// the handle would ask for any torque: with true encoders the arm's stops are before these.
std::optional<ArmState> polhemArm(const PolhemAngles& angles) noexcept;

/// The arm, for its board.
const CapstanArm& polhem();

/// The driver "polhem": without a which, the first that can be opened.
std::vector<DeviceEntry> surveyPolhem();
Expected<std::unique_ptr<Device>> openPolhem(const OpenRequest& request);

}  // namespace haptics
