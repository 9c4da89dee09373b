// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

#include "haptics/core/volume.h"

namespace datasets {

/// A grid with voxels of this size [m] along the axes of W, its middle at W's origin.
inline haptics::Grid centredGrid(std::int64_t ni, std::int64_t nj, std::int64_t nk,
                                 const haptics::Vec3& spacing) {
  haptics::Grid grid;
  grid.dims = {ni, nj, nk};
  grid.spacing = spacing;
  grid.origin = -0.5 * spacing.cwiseProduct(haptics::Vec3(ni - 1.0, nj - 1.0, nk - 1.0));
  return grid;
}

/// The same of cubes of side `spacing` [m].
inline haptics::Grid centredGrid(std::int64_t ni, std::int64_t nj, std::int64_t nk,
                                 double spacing) {
  return centredGrid(ni, nj, nk, haptics::Vec3::Constant(spacing));
}

/// The same with `n` voxels along each axis.
inline haptics::Grid centredGrid(std::int64_t n, double spacing) {
  return centredGrid(n, n, n, spacing);
}

/// How a distance becomes a voxel: value = isovalue - slope · distance / spacing, held constant
/// beyond `reach` voxels on either side. Within the reach the voxels are the distance, so the
/// trilinear isosurface is the formula's surface: to the rounding of a voxel (1 / 2 slope of a
/// voxel's width) where that is flat, to second order in spacing over radius where it is curved.
/// Three voxels also keep a central difference over one voxel exact.
struct Ramp {
  double isovalue = 1000.0;
  double slope = 4000.0;  ///< intensity per voxel's width
  double reach = 3.0;     ///< voxels
};

/// Samples a signed distance, `distance(p_W)` in metres and positive outside, as voxels of
/// type T. The grid's spacing must be the same along its axes. Once `cancel` is true, no further
/// layer is sampled and the result is Error::Kind::Cancelled.
template <class T, class Distance>
haptics::Expected<haptics::Volume> sampled(const haptics::Grid& grid, const Ramp& ramp,
                                           Distance&& distance, haptics::VolumeFacts facts = {},
                                           const std::atomic<bool>* cancel = nullptr) {
  constexpr auto type = std::is_same_v<T, std::uint8_t> ? haptics::ScalarType::UInt8
                        : std::is_same_v<T, float>      ? haptics::ScalarType::Float32
                                                        : haptics::ScalarType::Int16;
  static_assert(std::is_same_v<T, std::uint8_t> || std::is_same_v<T, float> ||
                std::is_same_v<T, std::int16_t>);
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), type);
  if (!voxels) return tl::unexpected(voxels.error());
  T* next = static_cast<T*>(voxels->get());
  for (std::int64_t k = 0; k < grid.dims[2]; ++k) {
    if (cancel != nullptr && *cancel)
      return tl::unexpected(haptics::Error{haptics::Error::Kind::Cancelled, {}, "cancelled"});
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
        const haptics::Vec3 index(static_cast<double>(i), static_cast<double>(j),
                                  static_cast<double>(k));
        const double depth =
            std::clamp(distance(grid.worldOf(index)) / grid.spacing.x(), -ramp.reach, ramp.reach);
        const double value = ramp.isovalue - ramp.slope * depth;
        *next++ = static_cast<T>(std::is_same_v<T, float> ? value : std::floor(value + 0.5));
      }
  }
  return haptics::makeVolume(grid, type, std::move(*voxels), std::move(facts));
}

}  // namespace datasets
