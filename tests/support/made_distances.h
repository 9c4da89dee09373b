// SPDX-License-Identifier: BSD-3-Clause
// Distance maps from closed forms.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "haptics/structures/distance_map.h"

namespace made {

/// The map of a signed distance [m] in W, sampled on a grid.
template <class Distance>
haptics::DistanceMap distanceMap(const haptics::Grid& grid, const Distance& distance,
                                 double most = 0.030) {
  haptics::DistanceMap map;
  map.grid = grid;
  map.most = most;
  map.step = most / 32767.0;
  map.steepest =
      1.8;  // of what is linear between samples of a distance: the root of 3, and rounding
  std::shared_ptr<std::int16_t[]> samples(new std::int16_t[std::size_t(grid.voxelCount())]);
  std::int16_t* at = samples.get();
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i)
        *at++ = std::int16_t(std::lround(
            std::clamp(distance(grid.worldOf({double(i), double(j), double(k)})), -most, most) /
            map.step));
  map.samples = std::move(samples);
  return map;
}

}  // namespace made
