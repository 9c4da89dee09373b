// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "haptics/core/geometry.h"

namespace datasets {

/// A part of the body that a phantom has by formula. Structures may overlap.
struct PhantomStructure {
  std::string name;
  std::array<double, 3> colour;  ///< red, green, blue, 0 to 1
  /// Signed distance to its surface [m] at a place in W, negative inside. Any thread.
  std::function<double(const haptics::Vec3& p_W)> distance;
  /// The distance is the true one everywhere. If not, only its sign and the surface are.
  bool exact = true;
};

/// The structures of a named phantom; none of one that has no such parts.
std::vector<PhantomStructure> phantomStructures(const std::string& phantom);

}  // namespace datasets
