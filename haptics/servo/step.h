// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "haptics/carving/burr.h"
#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"
#include "haptics/coupling/safety.h"
#include "haptics/proxy/proxy.h"
#include "haptics/servo/rate.h"
#include "haptics/settings.h"
#include "haptics/structures/nearness.h"

namespace haptics {

/// Events before a step's tick, as bits of Step::flags.
struct StepFlags {
  static constexpr std::uint16_t kAdopted = 1;       ///< another scene was adopted
  static constexpr std::uint16_t kSettingMoved = 2;  ///< a setting changed
  static constexpr std::uint16_t kArmed = 4;         ///< armed by the user
  static constexpr std::uint16_t kLost = 8;          ///< the device gave no reading
  static constexpr std::uint16_t kStale = 16;        ///< the device gave its last reading again
  /// Nothing but the last reading for 1.5 ms or more.
  static constexpr std::uint16_t kSilent = 32;
  static constexpr std::uint16_t kNotReady = 64;  ///< the device is not homed
  /// The clutch is held: the hand moves, the tool does not.
  static constexpr std::uint16_t kClutched = 128;
  static constexpr std::uint16_t kLetGo = 256;     ///< hold-to-run is on, and its key is released
  static constexpr std::uint16_t kGap = 512;       ///< no tick for 5 ms before this one
  static constexpr std::uint16_t kTooFast = 1024;  ///< the device moves too fast for force
  static constexpr std::uint16_t kJumped = 2048;   ///< the device moved faster than a hand can
  static constexpr std::uint16_t kStalled = 4096;  ///< the third gap in ten seconds
  static constexpr std::uint16_t kStiffnessMoved = 8192;  ///< the changed setting is the stiffness
  static constexpr std::uint16_t kWatchMoved = 16384;  ///< other structures are felt, or otherwise
  static constexpr std::uint16_t kCut = 32768;         ///< the burr turns: its key is held
};

/// One tick of a session: input and result. The servo thread fills it. It owns no memory.
struct Step {
  std::uint64_t sequence = 0;  ///< counts every tick since the recording began, lost ones included
  std::int64_t time_ns = 0;    ///< monotonic, since the recording began
  Pose X_WD = Pose::Identity();  ///< as read, exact
  Pose X_WP = Pose::Identity();  ///< after the tick
  Wrench sent_W;                 ///< wrench sent to the device, in W
  Settings settings;             ///< in force in this tick
  std::uint32_t scene = 0;       ///< Scene::id, 0 for none
  std::int64_t cut_at = 0;       ///< Budget::cutAt
  std::int64_t cpu_ns = 0;       ///< CPU time of the tick
  std::uint32_t late_ticks = 0;  ///< ticks that began late, since the loop started
  std::uint32_t missed_ticks = 0;
  ForceState force_state = ForceState::Off;
  std::uint16_t flags = 0;
  Bearing contacts;
  std::optional<BurrCut> cut;  ///< that began after the tick
  /// m3 that it removed. The recorder finds it; the servo thread may carry a cut out over several
  /// ticks.
  double removed = 0.0;
  Nearnesses near;  ///< of the proxy to the watched structures
};

/// State from which a replay of the following steps gives the same result. Recorded before the
/// first step, after a gap, and for each scene that is adopted.
struct ProxyStart {
  std::uint64_t sequence = 0;  ///< sequence of the next step
  std::uint32_t scene = 0;
  Pose X_WP = Pose::Identity();
  Vec3 turn = Vec3::Zero();  ///< Proxy::turn
  ForceLimits limits;
  Safety::Memory safety;  ///< state before the step
  ServoRate rate;         ///< of the step and those that follow
};

}  // namespace haptics
