// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

namespace haptics {

/// What a maker's device can do, as far as it is public. 0 where it has none of it; where nothing
/// is public a cautious value stands, and `source` says so.
struct DeviceRating {
  std::string_view id = {};        ///< as the command line calls it
  std::string_view name = {};      ///< as its maker calls it
  int sensed = 0, actuated = 0;    ///< degrees of freedom; a grip's opening counts as one
  double force = 0.0;              ///< N, norm
  double continuous_force = 0.0;   ///< N, norm, that its motors stand for hours
  double torque = 0.0;             ///< N·m, norm; 0 without torque motors
  double stiffness = 0.0;          ///< N/m, the most that may be rendered
  double angular_stiffness = 0.0;  ///< N·m/rad, likewise
  double damping = 0.0;            ///< N·s/m, the most that may be rendered
  double workspace = 0.0;          ///< m, radius
  double resolution = 0.0;         ///< m, of the handle's position
  double rate = 1000.0;            ///< Hz, the most that its link carries
  int delay = 0;                   ///< ticks of 1 ms that its force comes late: 1 over such a link
  std::string_view source = {};    ///< where the values are from, and which are not verified
};

/// What the user may own, one row a model.
std::span<const DeviceRating> deviceRatings();

/// The rating of a device by its id, or null.
const DeviceRating* findRating(std::string_view id);

}  // namespace haptics
