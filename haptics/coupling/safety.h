// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/coupling/passivity.h"
#include "haptics/snapshot.h"

namespace haptics {

/// What the motors may be asked for.
struct ForceLimits {
  double force = std::numeric_limits<double>::infinity();   ///< N, norm
  double torque = std::numeric_limits<double>::infinity();  ///< N·m, norm; 0: no torque motors
  double ramp_time = 0.0;  ///< s from zero to full after whatever stopped it
  /// s from zero to the limit while the force follows a moved isovalue; 0: no such limit
  double slew_time = 0.0;
  double rise_time = 0.0;  ///< s from zero to the limit, always; 0: no such limit
  /// N, norm, that the motors stand for ever: what they are asked for is held to that as they heat
  /// up, by the mean of its square over kWarmUp.
  double continuous_force = std::numeric_limits<double>::infinity();
  bool guard_passivity = false;  ///< lower the stiffness before it buzzes

  static constexpr double kWarmUp = 20.0;  ///< s
};

/// What a tick knows of device and user before it has computed anything.
struct Circumstances {
  bool armed = false;                            ///< the user wants force
  bool ready = false;                            ///< the device gives poses and there is a scene
  ForceReason unready = ForceReason::NoReading;  ///< why not, if not
  ForceReason withheld = ForceReason::None;      ///< what stands against force now
  ForceReason fault = ForceReason::None;         ///< what latches
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
/// Armed fades the force in kFade where the tool is taken from the hand (clutch, hold-to-run,
/// proxy left inside), and is zero at once where there is doubt (gap, speed, stale reading, a
/// number that is not finite, another scene). Off, Ready and Fault are zero from that very tick on.
///
/// Servo thread only.
class Safety {
 public:
  static constexpr double kFade = 0.05;  ///< s from full to zero

  /// All that it remembers from tick to tick.
  struct Memory {
    ForceState state = ForceState::Off;
    ForceReason reason = ForceReason::NoReading;
    ForceReason withheld = ForceReason::None;
    bool let_go = false;  ///< in Fault: the user has seen it, so arming counts
    double gain = 0.0;    ///< 0 to 1
    bool slewing = false;
    double slew_left = 0.0;  ///< s
    double heat = 0.0;       ///< of the motors: 1 is what they stand for ever
    Wrench sent;
    PassivityGuard::Memory passivity;
  };
  using Transitions = FixedVector<ForceTransition, 4>;

  explicit Safety(const ForceLimits& limits) : limits_{limits} {}
  /// Goes on where another one was.
  Safety(const ForceLimits& limits, const Memory& memory) : limits_{limits}, at_{memory} {}

  /// Begins a tick. To be followed by `pass` in any case.
  void begin(const Circumstances& now) HAPTICS_RT;
  /// The isovalue or the stiffness moved: until the force has caught up, and for slew_time at
  /// least, it changes no faster than the slew limit. `stiffness`: it was that, so what the
  /// passivity guard found of the old one counts no more.
  void settingMoved(bool stiffness) HAPTICS_RT;
  /// Where the device has gone since the last tick, under what was sent then. `scale`: m in W for
  /// each m of the hand.
  void moved(const Pose& X_WD, double scale, double period) HAPTICS_RT;
  /// The share of the set stiffness that is to be used in this tick: less than 1 where the loop
  /// gave the hand energy.
  double stiffnessShare() const HAPTICS_RT { return at_.passivity.share; }

  /// What may be sent in this tick. `outside`: the proxy is legal. `period` [s].
  Wrench pass(const Wrench& wanted, bool outside, double period) HAPTICS_RT;

  ForceState state() const HAPTICS_RT { return at_.state; }
  ForceReason reason() const HAPTICS_RT { return at_.reason; }
  /// Steps from state to state since `begin`; their time is not filled in.
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
