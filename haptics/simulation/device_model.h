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

/// What lies between the handle, which the hand holds, and the program: encoders, motors, a delay,
/// and the arm from the handle's pivot to the tool. As it is made here it is none of that.
struct Linkage {
  static constexpr int kLongestDelay = 7;  ///< ticks

  double encoder = 0.0;        ///< m: positions are read in whole steps of it
  double angle_encoder = 0.0;  ///< rad: rotation vectors are
  int delay = 0;               ///< ticks that a wrench comes late; 0 to kLongestDelay
  bool torque = true;          ///< torque motors. Without: six sensed, three actuated
  Vec3 arm = Vec3::Zero();     ///< m, from the handle's pivot to the tool's origin, tool frame

  /// What the program reads with the handle at X_WH: the pose of the tool.
  Pose read(const Pose& X_WH) const HAPTICS_RT;
  /// Where the handle is with the tool at X_WD, all encoders fine.
  Pose handleAt(const Pose& X_WD) const HAPTICS_RT;
  /// Takes what the program sends, about the tool's origin, with the handle at X_WH, and says what
  /// acts on the handle, about its pivot, until the next tick: what was sent `delay` ticks ago. A
  /// torque that no motor makes is lost, that of the force about the pivot too.
  Wrench carry(const Wrench& sent_W, const Pose& X_WH) HAPTICS_RT;

 private:
  std::array<Wrench, kLongestDelay + 1> under_way_ = {};
  int next_ = 0;
};

/// The human hand: a spring and a damper to where it wants to be, and what of it moves along.
struct HumanHand {
  double mass = 0.05;        ///< kg
  double damping = 4.0;      ///< N·s/m
  double stiffness = 500.0;  ///< N/m
};

/// A device of the table of ratings as a mass with damping.
///
/// Force, torque and stiffness are the makers' ratings. So are the encoder steps of omega (at
/// most 0.01 mm), Touch and Omni (0.055), Desktop (0.023), by what is public and unverified; those
/// of Falcon (0.0364 degrees at an arm of 60 mm) and Polhem (4096 counts on a capstan of 28.8 mm
/// that drives a sector of 175 mm, which moves the handle at 0.13 m: 0.033 mm) and WoodenHaptics
/// (2000 counts on one of 10 mm, a sector of 120 mm, a forearm of 245 mm: 0.06 mm) follow from
/// their geometry. Where nothing is known it is 0.01 mm, and half a milliradian in rotation.
///
/// No public table has moving masses, damping and dry friction of all. Mass: 0.1 kg up to a force
/// of 5 N, 0.2 up to 15, 0.3 above. Damping: 1 N·s/m. Both from the range in which the loop was
/// tried first (0.1 to 0.3 kg, 1 to 2 N·s/m): defaults, not measurements. Dry friction: none,
/// since it only helps.
struct DeviceModel {
  std::string name;
  DeviceRating rating;
  double mass = 0.2;     ///< kg, of what moves, at the handle
  double damping = 1.0;  ///< N·s/m
  double coulomb = 0.0;  ///< N
  Linkage linkage = {};

  /// It and the hand as one body.
  Grip heldBy(const HumanHand& hand, double gyration) const;
};

/// Every device that is rated and has motors, and "omni-arm-200": a PHANTOM Omni, six sensed and
/// three actuated, whose tool has its origin 200 mm from the gimbal ([Chan 2011], 3.1, on large
/// moment arms).
std::vector<DeviceModel> deviceModels();
std::optional<DeviceModel> findDeviceModel(std::string_view name);

}  // namespace haptics
