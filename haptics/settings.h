// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"

namespace haptics {

/// The range of a setting, both ends included.
struct Range {
  double least, most;
  constexpr bool holds(double value) const { return value >= least && value <= most; }
};

/// The ranges of Settings, for code that reads or stores these numbers.
inline constexpr Range kStiffnessRange{0.0, 20'000.0};
inline constexpr Range kAngularStiffnessRange{0.0, 1000.0};
inline constexpr Range kFrictionRange{0.0, 1.5};
inline constexpr Range kScaleRange{0.1, 10.0};  ///< of force and of position

/// Numbers of buttons in Handling: buttons of the device that moves the tool count from 0, those of
/// a second device in the other hand from kButtonsEach.
inline constexpr int kButtonsEach = 8;
inline constexpr int kButtons = 2 * kButtonsEach;

/// What the user may change while the servo loop runs. Set by the GUI thread through
/// Session::set, adopted at the next tick; never needs a new Scene.
struct Settings {
  double isovalue = 0.0;  ///< in the volume's own unit; above the background
  /// N on the hand for each m in the volume, at a force_scale of 1; kStiffnessRange. At the hand
  /// the stiffness is stiffness · force_scale · position_scale, which the device's rating may cap.
  double stiffness = 1000.0;
  /// N·m/rad at the hand, kAngularStiffnessRange; 0 means stiffness times the tool's mean inertia
  /// (the paper's scalar k).
  double angular_stiffness = 0.0;
  double friction = 0.0;        ///< Coulomb's coefficient between tool and surface; kFrictionRange
  double force_scale = 1.0;     ///< force at the hand over force in the volume; kScaleRange
  double position_scale = 1.0;  ///< m that the tool moves for each m of the hand; kScaleRange
};

/// How a real device is held. Set by the GUI thread through Session::handle.
struct Handling {
  /// A rotation. Its columns are the directions in W of the base's axes: x right, y up, z towards
  /// the user.
  Mat3 R_WB = Mat3::Identity();
  int clutch_button = -1;    ///< while it is down the tool stays and the hand moves; -1: none
  int cut_button = -1;       ///< while it is down the burr turns; -1: none
  int hold_button = -1;      ///< button of hold-to-run; -1: none
  bool hold_to_run = false;  ///< no force unless the button or the key is held
  bool clutch = false;       ///< the clutch's key is down
  /// The key of hold-to-run is down. It expires after 0.25 s, so that a window that hangs does not
  /// keep the force on; the GUI must resend it.
  bool held = false;
};

}  // namespace haptics
