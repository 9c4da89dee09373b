// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace haptics {

/// v >= isovalue, for voxels of this type, is v >= this. None: no value is.
template <class T>
std::optional<T> thresholdOf(double isovalue) {
  if constexpr (std::is_floating_point_v<T>) {
    const T near = static_cast<T>(isovalue);
    return static_cast<double>(near) >= isovalue
               ? near
               : std::nextafter(near, std::numeric_limits<T>::infinity());
  } else {
    const double up = std::ceil(isovalue);
    if (up > static_cast<double>(std::numeric_limits<T>::max())) return {};
    if (up <= static_cast<double>(std::numeric_limits<T>::lowest()))
      return std::numeric_limits<T>::lowest();
    return static_cast<T>(up);
  }
}

}  // namespace haptics
