// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace haptics {

/// What the user may change while the servo loop runs. Set by the GUI thread through
/// Session::set, adopted at the next tick; never needs a new Scene.
struct Settings {
  double isovalue = 0.0;      ///< in the volume's own unit; above the background
  double stiffness = 1000.0;  ///< N/m at the hand, 0 to 20,000
  /// N·m/rad at the hand; 0 takes stiffness times the tool's mean inertia (the paper's scalar k).
  double angular_stiffness = 0.0;
  double friction = 0.0;  ///< Coulomb's coefficient between tool and surface, 0 to 1.5
};

}  // namespace haptics
