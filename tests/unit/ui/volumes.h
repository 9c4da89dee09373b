// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "haptics/core/volume.h"

namespace volumes {

/// A volume whose voxels follow a formula of their index, rounded.
inline haptics::Volume made(const haptics::Grid& grid,
                            const std::function<double(const haptics::Vec3& index)>& intensity) {
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16).value();
  auto* out = static_cast<std::int16_t*>(voxels.get());
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i)
        *out++ = static_cast<std::int16_t>(std::lround(
            intensity({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)})));
  return haptics::makeVolume(grid, haptics::ScalarType::Int16, std::move(voxels)).value();
}

/// Voxels of unequal sides, turned against all axes of the patient, left-handed.
inline haptics::Grid turnedGrid(std::array<std::int64_t, 3> dims) {
  haptics::Grid grid;
  grid.dims = dims;
  grid.spacing = {0.5e-3, 0.7e-3, 1.1e-3};
  grid.direction =
      Eigen::AngleAxisd(0.6, haptics::Vec3{1.0, -0.4, 0.7}.normalized()).toRotationMatrix() *
      haptics::Vec3{1.0, -1.0, 1.0}.asDiagonal();
  grid.origin = {0.012, -0.020, 0.031};
  return grid;
}

}  // namespace volumes
