// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

namespace haptics {

/// What a maker's device can do, as far as it is public: the values of CHAI3D's device tables
/// (CDeltaDevices.cpp, CPhantomDevices.cpp), the makers' own pages for the rest.
struct DeviceRating {
  std::string_view name;  ///< as the command line calls it
  double force;           ///< N, norm
  double torque;          ///< N·m, norm; 0 without torque motors
  double stiffness;       ///< N/m
  double workspace;       ///< m, radius
  double damping;         ///< N·s/m, the most that may be rendered
};

std::span<const DeviceRating> deviceRatings();

/// The rating of a device by name, or null.
const DeviceRating* findRating(std::string_view name);

}  // namespace haptics
