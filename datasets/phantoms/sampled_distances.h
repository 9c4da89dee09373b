// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "haptics/structures/distance_map.h"

namespace datasets {

/// The map of a signed distance, distance(p_W) in metres, sampled on a grid.
template <class Distance>
haptics::DistanceMap distanceMap(const haptics::Grid& grid, const Distance& distance,
                                 double most = 0.030) {
  haptics::DistanceMap map;
  map.grid = grid;
  map.most = most;
  map.step = most / std::numeric_limits<std::int16_t>::max();
  std::shared_ptr<std::int16_t[]> samples(new std::int16_t[std::size_t(grid.voxelCount())]);
  std::int16_t* at = samples.get();
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i)
        *at++ = std::int16_t(std::lround(
            std::clamp(distance(grid.worldOf({double(i), double(j), double(k)})), -most, most) /
            map.step));
  map.samples = std::move(samples);
  haptics::boundSlopes(map);
  return map;
}

}  // namespace datasets
