// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/geometry.h"

namespace haptics {

/// How the servo thread was allowed to run.
enum class SchedulingPolicy : std::uint8_t { NotStarted, Ordinary, RealTime };

/// What stands between the computed wrench and the motors.
enum class ForceState : std::uint8_t {
  Off,        ///< zero force until the user arms it again
  Ramping,    ///< rising to full over a second
  On,         ///< full, within the device's limits
  Recovering  ///< the isovalue left the proxy inside: faded out while it is brought outside
};

/// What the picture may know of one tick. Published by the servo thread, taken by the GUI's.
struct Snapshot {
  std::uint64_t tick = 0;        ///< ticks since the loop started
  double time = 0.0;             ///< s since the loop started
  Pose X_WD = Pose::Identity();  ///< device
  Pose X_WP = Pose::Identity();  ///< proxy
  Wrench felt_W;                 ///< what was sent to the device: force at, torque about D
  Wrench coupling_W;             ///< the same before limits, ramp and Escape
  double isovalue = 0.0;         ///< in force in this tick
  std::uint64_t scene = 0;       ///< Scene::id in force, 0 for none
  int contacts = 0;              ///< contacts that bear force
  ForceState force_state = ForceState::Off;
  SchedulingPolicy policy = SchedulingPolicy::NotStarted;
  double servo_rate = 0.0;         ///< Hz over the last second
  double tick_p99 = 0.0;           ///< s of CPU, over the last second or so
  std::uint64_t late_ticks = 0;    ///< began over 100 us after their time
  std::uint64_t missed_ticks = 0;  ///< periods in which no tick began
};

}  // namespace haptics
