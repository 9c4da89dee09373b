// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/coupling/passivity.h"
#include "haptics/snapshot.h"

namespace haptics {

/// Limits of what is sent to the motors.
struct ForceLimits {
  double force = std::numeric_limits<double>::infinity();   ///< N, norm
  double torque = std::numeric_limits<double>::infinity();  ///< N·m, norm; 0: no torque motors
  double ramp_time = 0.0;  ///< s from zero to full after every stop
  /// s from zero to the limit while the force follows a moved isovalue; 0: no such limit
  double slew_time = 0.0;
  double rise_time = 0.0;  ///< s from zero to the limit, always; 0: no such limit
  /// N, norm, that the motors can render without end. As they heat up, by the mean square of the
  /// force over kWarmUp, the force is limited to it.
  double continuous_force = std::numeric_limits<double>::infinity();
  bool guard_passivity = false;  ///< lower the stiffness if the loop shakes (PassivityGuard)

  static constexpr double kWarmUp = 20.0;  ///< s
};

/// State of device and user at the beginning of a tick.
struct Circumstances {
  bool armed = false;                            ///< the user wants force
  bool ready = false;                            ///< the device gives poses and there is a scene
  ForceReason unready = ForceReason::NoReading;  ///< why not, if not
  ForceReason withheld = ForceReason::None;      ///< why there must be no force now, if so
  ForceReason fault = ForceReason::None;         ///< why the force is latched off, if so
  bool adopted = false;                          ///< another scene or start: the force is new
};

/// The last gate before the motors. One state machine:
///
///            poses and a scene          arm            nothing withholds       ramp_time
///   Off ───────────────────────▶ Ready ────▶ Armed ─────────────────────▶ Ramping ──────▶ On
///    ▲                            ▲            ▲                             │            │
///    │ no poses, no scene         │ stop       └───────── withheld ──────────┴────────────┘
///    └── from Ready to On         └── from Armed, Ramping, On
///
///   Fault ◀── lost, jump, stalled: from anywhere. Only arming leads out of it, to Ready and on.
///
/// On the way to Armed, the force fades in kFade after clutch, hold-to-run or a proxy left inside.
/// After a gap, excess speed, a stale reading, a number that is not finite or another scene it is
/// zero at once. In Off, Ready and Fault it is zero from that tick on.
///
/// Servo thread only.
class Safety {
 public:
  static constexpr double kFade = 0.05;  ///< s from full to zero

  /// The whole state that is kept from tick to tick.
  struct Memory {
    ForceState state = ForceState::Off;
    ForceReason reason = ForceReason::NoReading;
    ForceReason withheld = ForceReason::None;
    bool let_go = false;  ///< in Fault: the user has disarmed since, so arming leaves it
    double gain = 0.0;    ///< 0 to 1
    bool slewing = false;
    double slew_left = 0.0;  ///< s
    double heat = 0.0;       ///< of the motors: 1 is the heat at continuous force
    Wrench sent;
    PassivityGuard::Memory passivity;
  };
  using Transitions = FixedVector<ForceTransition, 4>;

  explicit Safety(const ForceLimits& limits) : limits_{limits} {}
  /// Continues from the state of another one.
  Safety(const ForceLimits& limits, const Memory& memory) : limits_{limits}, at_{memory} {}

  /// Begins a tick. Must be followed by `pass`.
  void begin(const Circumstances& now) HAPTICS_RT;
  /// The isovalue or the stiffness changed. Until the force has caught up, and for at least
  /// slew_time, the slew limit applies. `stiffness`: the stiffness changed, so the passivity guard
  /// starts anew.
  void settingMoved(bool stiffness) HAPTICS_RT;
  /// The pose of the device now, for the passivity guard. `scale`: m in W for
  /// each m of the hand.
  void moved(const Pose& X_WD, double scale, double period) HAPTICS_RT;
  /// The share of the set stiffness to use in this tick: less than 1 after the passivity guard has
  /// acted.
  double stiffnessShare() const HAPTICS_RT { return at_.passivity.share; }

  /// The wrench to send in this tick. `outside`: the proxy is legal. `period` [s].
  Wrench pass(const Wrench& wanted, bool outside, double period) HAPTICS_RT;

  ForceState state() const HAPTICS_RT { return at_.state; }
  ForceReason reason() const HAPTICS_RT { return at_.reason; }
  /// Transitions since `begin`; their time is not set.
  const Transitions& transitions() const HAPTICS_RT { return transitions_; }
  const Memory& memory() const HAPTICS_RT { return at_; }
  const ForceLimits& limits() const HAPTICS_RT { return limits_; }

 private:
  void enter(ForceState state, ForceReason reason) HAPTICS_RT;
  bool mayBeFelt() const HAPTICS_RT;
  double strongest() const HAPTICS_RT;

  ForceLimits limits_;
  Memory at_;
  Transitions transitions_;
};

}  // namespace haptics
