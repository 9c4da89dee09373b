// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "haptics/core/realtime.h"

namespace haptics {

/// What it takes to remove a material, by the value that the scan has there.
struct Material {
  static constexpr std::size_t kBands = 4;
  /// From this value on it takes so much energy [J/m3]. By value, from the lowest band on; below
  /// the first, its energy.
  struct Band {
    double from = 0.0, energy = 1e9;
    bool operator==(const Band&) const = default;
  };
  std::array<Band, kBands> bands{};
  std::size_t count = 1;  ///< of bands, from 1

  bool operator==(const Material&) const = default;

  double energyAt(double value) const HAPTICS_RT {
    std::size_t band = 0;
    while (band + 1 < count && value >= bands[band + 1].from) ++band;
    return bands[band].energy;
  }
};

}  // namespace haptics
