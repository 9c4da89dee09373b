// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

namespace haptics {

/// The public ratings of a device. 0 means that it has no such ability. If nothing is public, the
/// value is a cautious one, and `source` says so.
struct DeviceRating {
  std::string_view id = {};        ///< as the command line calls it
  std::string_view name = {};      ///< as its maker calls it
  int sensed = 0, actuated = 0;    ///< degrees of freedom; a grip's opening counts as one
  double force = 0.0;              ///< N, norm
  double continuous_force = 0.0;   ///< N, norm, that its motors can render for hours
  double torque = 0.0;             ///< N·m, norm; 0 without torque motors
  double stiffness = 0.0;          ///< N/m, the most that may be rendered
  double angular_stiffness = 0.0;  ///< N·m/rad, likewise
  double damping = 0.0;            ///< N·s/m, the most that may be rendered
  double workspace = 0.0;          ///< m, radius
  double resolution = 0.0;         ///< m, of the handle's position
  double rate = 1000.0;            ///< Hz, the highest rate of its link
  double delay = 0.0;              ///< s by which its force is late (devices/README.md)
  double lead = 0.0;               ///< s of it that a lead makes good (servo/pose_predictor.h)
  std::string_view source = {};    ///< where the values are from, and which are not verified
};

/// All known models, one row each.
std::span<const DeviceRating> deviceRatings();

/// The rating of a device by its id, or null.
const DeviceRating* findRating(std::string_view id);

}  // namespace haptics
