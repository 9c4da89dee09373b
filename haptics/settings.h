// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/geometry.h"

namespace haptics {

/// What the user may change while the servo loop runs. Set by the GUI thread through
/// Session::set, adopted at the next tick; never needs a new Scene.
struct Settings {
  double isovalue = 0.0;  ///< in the volume's own unit; above the background
  /// N on the hand, were force_scale 1, for each m in the volume; 0 to 20,000. At the hand that is
  /// stiffness · force_scale · position_scale, which a device's rating may cap.
  double stiffness = 1000.0;
  /// N·m/rad at the hand; 0 takes stiffness times the tool's mean inertia (the paper's scalar k).
  double angular_stiffness = 0.0;
  double friction = 0.0;        ///< Coulomb's coefficient between tool and surface, 0 to 1.5
  double force_scale = 1.0;     ///< of what the hand feels to what the tool exerts, 0.1 to 10
  double position_scale = 1.0;  ///< m that the tool moves for each m of the hand, 0.1 to 10
};

/// How a real device is held. Set by the GUI thread through Session::handle.
struct Handling {
  /// Where the base's axes point in W, as columns: x right, y up, z towards the user; a rotation.
  Mat3 R_WB = Mat3::Identity();
  int clutch_button = -1;    ///< while it is down the tool stays and the hand moves; -1: none
  int hold_button = -1;      ///< hold-to-run by it; -1: none
  bool hold_to_run = false;  ///< no force unless the button or the key is held
  bool clutch = false;       ///< the clutch's key is down
  /// The key of hold-to-run is down. Counts for 0.25 s: a window that hangs holds nothing, so who
  /// means it says it again and again.
  bool held = false;
};

}  // namespace haptics
