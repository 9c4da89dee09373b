// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/core/fixed_vector.h"

namespace haptics {

inline constexpr std::size_t kMostWatched = 12;  ///< structures at a time

/// How near the tool is to a watched structure: signed distances [m], negative inside. What is
/// farther away than DistanceMap::told() is told as that.
struct Nearness {
  std::uint8_t structure = 0;  ///< its number in the label map
  float tip = 0.0F;            ///< of the tool's tip
  float nearest = 0.0F;        ///< of the shell point that is nearest to it

  bool operator==(const Nearness&) const = default;
};

/// To each watched structure, in the order in which they are watched.
using Nearnesses = FixedVector<Nearness, kMostWatched>;

}  // namespace haptics
