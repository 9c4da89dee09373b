// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/snapshot.h"

namespace haptics {

/// What the motors may be asked for.
struct ForceLimits {
  double force = std::numeric_limits<double>::infinity();   ///< N, norm
  double torque = std::numeric_limits<double>::infinity();  ///< N·m, norm; 0: no torque motors
  double ramp_time = 0.0;  ///< s from zero to full after arming or a change of scene
  /// s from zero to the limit while the force follows a moved isovalue; 0: no such limit
  double slew_time = 0.0;
};

/// The last gate before the motors. One state machine:
///
///   Off ──arm──▶ Ramping ──ramp_time──▶ On ──isovalue left the proxy inside──▶ Recovering
///    ▲              ▲                                                              │
///    └── forceOff, from anywhere          faded out, and the proxy outside again ──┘
///
/// Servo thread only. A number that is not finite ends in zero for that tick, and in a
/// new ramp.
class Safety {
 public:
  /// All that it remembers from tick to tick.
  struct Memory {
    ForceState state = ForceState::Off;
    double gain = 0.0;  ///< 0 to 1
    bool slewing = false;
    double slew_left = 0.0;  ///< s
    Wrench sent;
  };

  explicit Safety(const ForceLimits& limits) : limits_{limits} {}
  /// Goes on where another one was.
  Safety(const ForceLimits& limits, const Memory& memory) : limits_{limits}, at_{memory} {}

  void arm() HAPTICS_RT;
  void forceOff() HAPTICS_RT { at_.state = ForceState::Off; }
  /// A new scene or start: the force ramps from zero again, unless it is off.
  void restart() HAPTICS_RT;
  /// The isovalue or the stiffness moved: until the force has caught up, and for slew_time at
  /// least, it changes no faster than the slew limit.
  void settingMoved() HAPTICS_RT {
    at_.slewing = limits_.slew_time > 0.0;
    at_.slew_left = limits_.slew_time;
  }

  /// What may be sent in this tick. `outside`: the proxy is legal. `period` [s].
  Wrench pass(const Wrench& wanted, bool outside, double period) HAPTICS_RT;

  ForceState state() const HAPTICS_RT { return at_.state; }
  const Memory& memory() const HAPTICS_RT { return at_; }
  const ForceLimits& limits() const HAPTICS_RT { return limits_; }

 private:
  ForceLimits limits_;
  Memory at_;
};

}  // namespace haptics
