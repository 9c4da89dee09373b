// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "haptics/devices/catalogue.h"
#include "haptics/devices/hid_port.h"
#include "haptics/devices/threaded.h"

namespace haptics {

// Polhem, an open capstan-driven arm: six encoders, three motors, raw HID. The protocol, the
// parameters and the arm's geometry are those that its makers published (haptikfabrikenapi and
// hfabapi, model polhem_v3, of December 2020); the formulas here are our own.
// Not verified on hardware: all signs, the zero procedure, the order of the gimbal's encoders, the
// gimbal's counts per turn on newer boards, and whether the board lets go by itself when nothing is
// sent to it. An older board's firmware does, after half a second.
// Not compensated: the arm's own weight. Not driven: WoodenHaptics, whose boards speak otherwise.

/// What the device says. Encoders a, b, c are on the motors; d, e, f in the gimbal.
struct PolhemReport {
  std::array<std::int16_t, 6> counts{};  ///< a to f
  bool button = false;                   ///< the stylus' button
  bool asks = false;                     ///< its zero button was pressed: it wants its encoders set
};

/// Reads an input report: 64 bytes, of which seven little-endian words count. Nothing for any other
/// length. The button is folded into encoder d, 10000 more where it is down.
std::optional<PolhemReport> decodePolhem(std::span<const std::uint8_t> report) noexcept;

/// An output report: its id, which is 0, and seven little-endian words.
using PolhemCommand = std::array<std::uint8_t, 65>;

/// The most that a motor is given, A: what its amplifier stands.
inline constexpr double kPolhemMostCurrent = 2.0;

/// Currents of the motors a, b, c in A, all shortened alike to kPolhemMostCurrent. Zero for all if
/// one of them is not finite; this is also what wakes the device up.
PolhemCommand polhemCurrents(const Vec3& currents) noexcept;

/// Tells the device that it is in its rest pose; its motors are without current meanwhile.
PolhemCommand polhemAtRest() noexcept;

/// The encoders' counts in the rest pose: the arm folded back to its stops, as its makers' program
/// has it.
inline constexpr std::array<std::int16_t, 6> kPolhemRest{8312, -10366, 19764, 0, 30, 0};

/// The angles of the six bodies, rad, from their encoders.
using PolhemAngles = std::array<double, 6>;
PolhemAngles polhemAngles(const std::array<std::int16_t, 6>& counts) noexcept;

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
/// The gimbal turns the handle by d about the forearm, by e across it, by f about the stylus.
struct PolhemArm {
  Pose X_BD;  ///< B's origin is the middle of the workspace; all angles zero: no rotation
  Mat3 J_B;   ///< dp/d(a, b, c), m/rad, p the origin of D in B
};

/// Nothing where the rod does not reach, or is within a degree of its dead points, where forces on
/// the handle would ask for any torque: with true encoders the arm's stops are before these.
std::optional<PolhemArm> polhemArm(const PolhemAngles& angles) noexcept;

/// The currents of the motors, A, that make this force on the handle: torques J^T F of the bodies,
/// through their capstans.
Vec3 polhemCurrentsFor(const Vec3& force_B, const Mat3& J_B) noexcept;

/// The device's link, for `threaded`. Every round sends currents and takes the newest answer.
///
/// NotReady with Trouble::NeedsCalibration until the encoders are set: the user folds the arm back
/// to its rest pose and presses the zero button of the device, or the one of the stylus. Then the
/// encoders are set and looked at: within 100 counts of the rest pose, and it is ready. Back to
/// that, without force, when the zero button is pressed again. When a motor's encoder jumps by
/// more than 2000 counts between two answers, or the counts make no arm, it is Lost: opened again,
/// it has to be set again.
///
/// After a round without an answer zero is sent until one comes. Its writes wait for the system,
/// which is a millisecond with a device that is well. Destroyed, it sends zero.
std::unique_ptr<Transport> polhemTransport(std::unique_ptr<HidPort> port);

/// The devices among these places: other boards have the same ids, so the usage page (0xffab) and
/// usage (0x0200) of a raw report device count too. Another project on such a board still passes;
/// opening finds out.
std::vector<DeviceEntry> polhemsAmong(std::span<const HidPlace> places);

/// Wakes a device up: refused as Trouble::Refused where no report of its comes within half a
/// second.
Expected<std::unique_ptr<Device>> polhemAt(std::unique_ptr<HidPort> port);

/// The driver "polhem": without a which, the first that can be opened.
std::vector<DeviceEntry> surveyPolhem();
Expected<std::unique_ptr<Device>> openPolhem(const OpenRequest& request);

}  // namespace haptics
