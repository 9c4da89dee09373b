// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/geometry.h"
#include "haptics/core/trouble.h"
#include "haptics/structures/nearness.h"

namespace haptics {

/// The scheduling policy that the servo thread got.
enum class SchedulingPolicy : std::uint8_t { NotStarted, Ordinary, RealTime };

/// State of the gate between the computed wrench and the motors; coupling/safety.h draws the
/// transitions.
enum class ForceState : std::uint8_t {
  Off,      ///< the device gives no poses, or there is no scene
  Ready,    ///< zero force until the user arms it
  Armed,    ///< the user wants force, but it is withheld: fading out, or zero
  Ramping,  ///< rising to full over a second
  On,       ///< full, within the device's limits
  Fault     ///< zero force, latched: until the user arms it again
};

/// Why the force is in its state.
enum class ForceReason : std::uint8_t {
  None,
  User,       ///< the user armed or stopped it
  NoReading,  ///< Off: the device gives no poses yet
  NotHomed,   ///< Off: its poses are not valid before homing
  Scene,      ///< Off: no scene. Armed: another scene was adopted
  Inside,     ///< Armed: the new isovalue left the proxy inside, and recovery is under way
  Clutched,   ///< Armed: the clutch is down
  NotHeld,    ///< Armed: hold-to-run, and neither button nor key is held
  Gap,        ///< Armed: no tick for 5 ms
  TooFast,    ///< Armed: the device moves faster than the limit under force
  NotFinite,  ///< Armed: a number was not finite
  Stale,      ///< Armed: no new reading for three ticks
  Lost,       ///< Fault: the device is gone, or three polls failed
  Jump,       ///< Fault: the device moved faster than a hand can, so an encoder is wrong
  Stalled     ///< Fault: three gaps within ten seconds, while armed
};

/// A transition of the force from one state to another.
struct ForceTransition {
  double time = 0.0;  ///< s since the loop started
  ForceState from = ForceState::Off, to = ForceState::Off;
  ForceReason reason = ForceReason::None;
};

/// A place where the proxy bears on the surface.
struct ContactPlace {
  std::array<float, 3> p_W{};  ///< m
  float push = 0.0F;           ///< N along the surface's normal
};

/// The state after one tick, for the picture. Published by the servo thread, taken by the GUI
/// thread.
struct Snapshot {
  std::uint64_t tick = 0;        ///< ticks since the loop started
  double time = 0.0;             ///< s since the loop started
  Pose X_WD = Pose::Identity();  ///< device
  Pose X_WP = Pose::Identity();  ///< proxy
  Wrench felt_W;                 ///< sent to the device: force at D's origin, torque about it
  Wrench coupling_W;             ///< the same before limits, ramp and stop
  double isovalue = 0.0;         ///< used in this tick
  std::uint64_t scene = 0;       ///< Scene::id, 0 for none
  int contacts = 0;              ///< contacts that bear force
  std::array<ContactPlace, 8> places = {};  ///< where they are; the first `contacts` of them
  Nearnesses near = {};  ///< of the proxy to the watched structures; none without a scene
  ForceState force_state = ForceState::Off;
  ForceReason reason = ForceReason::None;
  std::uint32_t buttons = 0;        ///< buttons of the device, bit n for button n
  Trouble trouble = Trouble::None;  ///< trouble of the device, which the user must solve
  bool can_cut = false;             ///< the tool has a burr, and the scene may be cut
  bool cuts = false;                ///< the burr turns
  double burr_force = 0.0;          ///< N, on the turning burr
  bool clutched = false;            ///< the clutch is down: the tool stays while the hand moves
  double stiffness_share = 1.0;     ///< share of the set stiffness after the passivity guard
  SchedulingPolicy policy = SchedulingPolicy::NotStarted;
  double servo_rate = 0.0;         ///< Hz over the last second
  double tick_p99 = 0.0;           ///< s of CPU, over the last second or so
  std::uint64_t late_ticks = 0;    ///< ticks that began over a tenth of a period late
  std::uint64_t missed_ticks = 0;  ///< periods in which no tick began
};

/// One sample of the force plot.
struct ForceSample {
  double time = 0.0;    ///< s since the loop started
  float force = 0.0F;   ///< N, norm of what was sent
  float torque = 0.0F;  ///< N·m, norm of what was sent
};

}  // namespace haptics
