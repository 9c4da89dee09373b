// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/realtime.h"
#include "haptics/coupling/safety.h"
#include "haptics/devices/ratings.h"
#include "haptics/servo/tick.h"
#include "haptics/settings.h"

namespace haptics {

/// Stands between the coupling's wrench and the gate, where a study tries what is not shipped.
/// Servo thread.
class WrenchHook {
 public:
  virtual ~WrenchHook() = default;
  /// What to ask the gate for in place of `wanted`, with the device at X_WD. `period` [s].
  virtual Wrench shaped(const Wrench& wanted, const Pose& X_WD, double period) HAPTICS_RT = 0;
  /// What the gate made of it.
  virtual void sent(const Wrench& sent_W) HAPTICS_RT = 0;
};

/// What a tick of the servo loop goes by beside the scene.
struct ServoInput {
  const Pose& X_WD;  ///< as read
  const Settings& settings;
  std::uint16_t flags = 0;     ///< StepFlags
  WrenchHook* hook = nullptr;  ///< none in the live loop and in a replay
};

/// What a device's motors may be asked for in the live loop: its rating, a ramp of a second, 20 ms
/// from zero to the rating after a moved isovalue, 2 ms at any time.
ForceLimits limitsOf(const DeviceRating& rating);

/// What it came to.
struct ServoResult {
  TickResult tick;
  Wrench sent_W;  ///< for the device
};

/// A tick and the gate behind it, the same for the live loop, for the replay of what it recorded,
/// and for the closed loop of studies. `scene` and `proxy` are null while nothing is touched.
ServoResult servoTick(const ServoInput& input, const Scene* scene, Proxy* proxy, Safety& safety,
                      double period, Budget& budget) HAPTICS_RT;

}  // namespace haptics
