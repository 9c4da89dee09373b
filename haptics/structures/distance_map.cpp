// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/structures/distance_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/core/parallel.h"

namespace haptics {

void boundSlopes(DistanceMap& map) {
  const auto& dims = map.grid.dims;
  const std::int64_t row = dims[0], slice = dims[0] * dims[1];
  const Vec3 slope = map.step * map.grid.spacing.cwiseInverse();
  struct Squares {
    double all = 0.0, outside = 0.0;
  };
  std::vector<Squares> of_slice(std::size_t(dims[2] - 1));
  inParallel(dims[2] - 1, [&](std::int64_t k) {
    Squares most;
    for (std::int64_t j = 0; j + 1 < dims[1]; ++j) {
      const std::int16_t* at = map.samples.get() + k * slice + j * row;
      for (std::int64_t i = 0; i + 1 < dims[0]; ++i, ++at) {
        // In each coordinate the slope is linear and its norm convex, so the steepest place of a
        // cell is a corner: there it is that of the three edges.
        const auto square = [&](int axis, std::int64_t from, std::int64_t by) {
          const double rise = slope[axis] * double(at[from + by] - at[from]);
          return rise * rise;
        };
        double steepest = 0.0;
        int highest = at[0];
        for (const std::int64_t z : {std::int64_t{0}, slice})
          for (const std::int64_t y : {std::int64_t{0}, row})
            for (const std::int64_t x : {0, 1}) {
              steepest = std::max(
                  steepest, square(0, y + z, 1) + square(1, x + z, row) + square(2, x + y, slice));
              highest = std::max(highest, int(at[x + y + z]));
            }
        most.all = std::max(most.all, steepest);
        if (highest >= 0) most.outside = std::max(most.outside, steepest);
      }
    }
    of_slice[std::size_t(k)] = most;
  });
  Squares most;
  for (const Squares& one : of_slice) {
    most.all = std::max(most.all, one.all);
    most.outside = std::max(most.outside, one.outside);
  }
  map.steepest = (1.0 + 1e-9) * std::sqrt(most.all);  // of rounding, too
  map.steepest_outside = (1.0 + 1e-9) * std::sqrt(most.outside);
}

}  // namespace haptics
