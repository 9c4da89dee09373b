// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/devices/ratings.h"
#include "haptics/simulation/grip.h"

namespace haptics {

/// The parts between the handle and the program: encoders, motors, a delay, and the arm from the
/// handle's pivot to the tool. The defaults are an ideal linkage: exact encoders, all motors, no
/// delay, no arm.
struct Linkage {
  static constexpr int kLongestDelay = 7;  ///< ticks

  double encoder = 0.0;        ///< m: step of the positions read; 0: exact
  double angle_encoder = 0.0;  ///< rad: step of the rotation vectors read; 0: exact
  double delay = 0.0;          ///< of a wrench, in ticks, 0 to kLongestDelay
  bool torque = true;          ///< has torque motors; false: six degrees sensed, three actuated
  Vec3 arm = Vec3::Zero();     ///< m, from the handle's pivot to the tool's origin, tool frame

  /// The pose of the tool that the program reads with the handle at X_WH.
  Pose read(const Pose& X_WH) const HAPTICS_RT;
  /// The pose of the handle with the tool at X_WD, with exact encoders.
  Pose handleAt(const Pose& X_WD) const HAPTICS_RT;
  /// Takes the wrench that the program sends. Returns the one that arrives until the next tick:
  /// sent `delay` ticks ago. If a tick has two, it is their mean, each by the share of its time.
  Wrench late(const Wrench& sent) HAPTICS_RT;
  /// Takes the wrench that the program sends, about the tool's origin, with the handle at X_WH.
  /// Returns the wrench that acts on the handle, about its pivot, until the next tick: the late
  /// one. Without torque motors the torque is lost, and so is the torque of the force about the
  /// pivot.
  Wrench carry(const Wrench& sent_W, const Pose& X_WH) HAPTICS_RT;

 private:
  std::array<Wrench, kLongestDelay + 1> under_way_ = {};
  int next_ = 0;
};

/// The human hand: a spring and a damper to the pose that it wants, and the mass that moves along.
struct HumanHand {
  double mass = 0.05;        ///< kg
  double damping = 4.0;      ///< N·s/m
  double stiffness = 500.0;  ///< N/m
};

/// A device of the table of ratings as a mass with damping.
///
/// Force, torque and stiffness are the makers' ratings. The encoder steps of omega (at most 0.01
/// mm), Touch and Omni (0.055) and Desktop (0.023) are public figures and not verified. Those of
/// Falcon (0.0364 degrees at an arm of 60 mm) and Polhem (4096 counts on a capstan of 28.8 mm that
/// drives a sector of 175 mm, which moves the handle at 0.13 m: 0.033 mm) and WoodenHaptics (2000
/// counts on one of 10 mm, a sector of 120 mm, a forearm of 245 mm: 0.06 mm) follow from their
/// geometry. An unknown step is 0.01 mm, and half a milliradian in rotation.
///
/// No public table has moving masses, damping and dry friction of all devices. Mass: 0.1 kg up to a
/// force of 5 N, 0.2 up to 15, 0.3 above. Damping: 1 N·s/m. Both are defaults from the range of the
/// first trials (0.1 to 0.3 kg, 1 to 2 N·s/m), not measurements. Dry friction: none, since friction
/// only makes the loop more stable.
struct DeviceModel {
  std::string name;
  DeviceRating rating;
  double mass = 0.2;     ///< kg, moving mass at the handle
  double damping = 1.0;  ///< N·s/m
  double coulomb = 0.0;  ///< N
  Linkage linkage = {};

  /// Device and hand as one body.
  Grip heldBy(const HumanHand& hand, double gyration) const;
};

/// Every device that is rated and has motors, and "omni-arm-200": a PHANTOM Omni, six sensed and
/// three actuated, whose tool has its origin 200 mm from the gimbal ([Chan 2011], 3.1, on large
/// moment arms).
std::vector<DeviceModel> deviceModels();
std::optional<DeviceModel> findDeviceModel(std::string_view name);

}  // namespace haptics
