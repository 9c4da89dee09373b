// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/realtime.h"
#include "haptics/coupling/safety.h"
#include "haptics/devices/ratings.h"
#include "haptics/proxy/cutting.h"
#include "haptics/proxy/felt.h"
#include "haptics/proxy/tick.h"
#include "haptics/settings.h"

namespace haptics {

/// Changes the wrench between coupling and gate. Studies use it for methods that are not shipped.
/// Servo thread.
class WrenchHook {
 public:
  virtual ~WrenchHook() = default;
  /// Returns the wrench to pass to the gate instead of `wanted`, with the device at X_WD. `period`
  /// [s].
  virtual Wrench shaped(const Wrench& wanted, const Pose& X_WD, double period) HAPTICS_RT = 0;
  /// Called with the wrench that the gate sent.
  virtual void sent(const Wrench& sent_W) HAPTICS_RT = 0;
};

/// Input of a tick, apart from the scene.
struct ServoInput {
  const Pose& X_WD;  ///< as read from the device
  const Settings& settings;
  std::uint16_t flags = 0;       ///< StepFlags
  WrenchHook* hook = nullptr;    ///< null in the live loop and in a replay
  const Watch* watch = nullptr;  ///< structures that are felt; null: none
  Felt* felt = nullptr;          ///< of the proxy; not null where there is a watch
  /// Whose scene is touched; null: the tool cuts nothing. It cuts while StepFlags::kCut is set.
  Cutting* cutting = nullptr;
};

/// Limits of a device's force in the live loop: its rating, a ramp of one second, and the shortest
/// times from zero to the rating: 20 ms after the isovalue moved, 2 ms at any other time.
ForceLimits limitsOf(const DeviceRating& rating);

/// Result of servoTick().
struct ServoResult {
  TickResult tick;
  Wrench sent_W;  ///< wrench sent to the device
};

/// A tick and the gate after it. The live loop, the replay and the closed loop all use it. `scene`
/// and `proxy` are null if there is no scene.
ServoResult servoTick(const ServoInput& input, const Scene* scene, Proxy* proxy, Safety& safety,
                      double period, Budget& budget) HAPTICS_RT;

}  // namespace haptics
