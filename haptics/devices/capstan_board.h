// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "haptics/core/clock.h"
#include "haptics/devices/catalogue.h"
#include "haptics/devices/hid_port.h"
#include "haptics/devices/threaded.h"

namespace haptics {

// The common part of Polhem and WoodenHaptics: arms with three motors on capstans and up to six
// encoders, behind a board with a raw HID protocol. Its makers published the protocol
// (haptikfabrikenapi, programs and firmware). The board does not report which arm it drives; the
// user chooses.
// Not verified on hardware: all signs, the zero procedure, and whether a newer board switches its
// motors off if nothing is sent. The published firmware of the older board does, after half a
// second.

/// The boards: a Teensy, and before it an mbed LPC1768. Other projects on such boards have the same
/// ids.
struct BoardIds {
  std::uint16_t vendor, product;
  std::size_t report;  ///< bytes of a report, either way, without its id
};
inline constexpr BoardIds kTeensyBoard{0x16c0, 0x0486, 64};
inline constexpr BoardIds kMbedBoard{0x1234, 0x0006, 14};

using BoardCounts = std::array<std::int16_t, 6>;

/// An input report of a board. Encoders a, b, c are on the motors; d, e, f in the gimbal, if there
/// is one.
struct BoardReport {
  BoardCounts counts{};  ///< a to f
  bool button = false;   ///< the stylus' button
  bool asks = false;     ///< its zero button was pressed: its encoders must be set
};

/// Reads an input report of seven little-endian words. Nothing for a length that no board has. The
/// button is part of encoder d, which is 10000 larger while the button is down.
std::optional<BoardReport> decodeBoard(std::span<const std::uint8_t> report) noexcept;

/// An output report: its id, which is 0, and seven little-endian words; a board takes as much of it
/// as its reports are long.
using BoardCommand = std::array<std::uint8_t, 65>;

/// The largest current of a motor, A, which its amplifier can deliver.
inline constexpr double kBoardMostCurrent = 2.0;

/// The report with the currents of the motors a, b, c in A, scaled by one factor to
/// kBoardMostCurrent. All are zero if one is not finite. A report of zeros also wakes a board up.
BoardCommand boardCurrents(const Vec3& currents) noexcept;

/// The report that sets the board's encoder counts. Its motors have no current meanwhile.
BoardCommand boardSets(const BoardCounts& counts) noexcept;

/// The pose of an arm's handle and its Jacobian.
struct ArmState {
  Pose X_BD;  ///< B's origin is the middle of the workspace
  Mat3 J_B;   ///< dp/d(a, b, c), m/rad, p the origin of D in B
};

/// From the makers' axes H (towards the user, right, up) to those of B.
Mat3 makersAxes() noexcept;

/// The parameters of an arm behind a board.
struct CapstanArm {
  std::string_view driver;                ///< also the id of its rating
  std::span<const BoardIds> boards;       ///< boards that may drive it
  BoardCounts rest;                       ///< the counts in its rest pose
  std::array<double, 3> ratio;            ///< a body's turn over its motor's
  std::array<double, 3> torque_constant;  ///< of its motors, N·m/A
  /// The pose for these counts. Nothing if the arm cannot have them, or is near a dead point, where
  /// a force on the handle would need unbounded torque.
  std::optional<ArmState> (*state)(const BoardCounts& counts) noexcept;
};

/// The currents of the motors, A, that make this force on the handle: torques J^T F of the bodies,
/// through their capstans.
Vec3 currentsFor(const CapstanArm& arm, const Vec3& force_B, const Mat3& J_B) noexcept;

/// The arm's link, for `threaded`. Every round sends currents and takes the newest answer.
///
/// NotReady with Trouble::NeedsCalibration until the encoders are set: the user puts the arm to its
/// rest pose and presses the zero button of the device, or holds the one of the stylus for a
/// second, the arm still. Then the encoders are set and looked at: within 100 counts of the rest
/// pose, and it is ready. Back to that, without force, when the zero button is pressed again. When
/// a motor's encoder jumps by more than 2000 counts between two answers, or the counts make no arm,
/// it is Lost: opened again, it has to be set again.
///
/// After a round without an answer zero is sent until one comes. Its writes wait for the system,
/// which is a millisecond with a device that is well. Destroyed, it sends zero until one is taken,
/// for 50 ms at most.
///
/// `report`: as in BoardIds. `arm` outlives it.
std::unique_ptr<Transport> armTransport(const CapstanArm& arm, std::unique_ptr<HidPort> port,
                                        std::size_t report, MonotonicClock clock = monotonicNs);

/// The boards among these places that the arm may stand behind: also by the usage page (0xffab) and
/// usage (0x0200) of a raw report device. Another project on such a board still passes; opening
/// finds out. So does the other arm, and nothing finds that out: `why` says it to the user.
std::vector<DeviceEntry> armsAmong(const CapstanArm& arm, std::span<const HidPlace> places);

/// Wakes a device up: refused as Trouble::Refused where no report of its board comes within half a
/// second, or the board has firmware of before October 2019, which speaks otherwise.
Expected<std::unique_ptr<Device>> armAt(const CapstanArm& arm, std::unique_ptr<HidPort> port,
                                        std::size_t report, MonotonicClock clock = monotonicNs);

/// As a driver's.
std::vector<DeviceEntry> surveyArms(const CapstanArm& arm);
Expected<std::unique_ptr<Device>> openArm(const CapstanArm& arm, const OpenRequest& request);

}  // namespace haptics
