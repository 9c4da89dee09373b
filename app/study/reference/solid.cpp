// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/solid.h"

#include <array>
#include <cmath>
#include <limits>

namespace reference {
namespace {

/// Trilinear at a continuous index, from voxels of one type.
template <class T>
double trilinear(const T* voxels, const std::array<std::int64_t, 3>& dims, double background,
                 const Vec3& index) {
  const Vec3 low = index.array().floor();
  const Vec3 t = index - low;
  const auto i = static_cast<std::int64_t>(low.x());
  const auto j = static_cast<std::int64_t>(low.y());
  const auto k = static_cast<std::int64_t>(low.z());

  // the eight corners: straight from memory within the grid, else one at a time
  std::array<double, 8> corner;
  if (i >= 0 && j >= 0 && k >= 0 && i + 1 < dims[0] && j + 1 < dims[1] && k + 1 < dims[2]) {
    const T* at = voxels + i + dims[0] * (j + dims[1] * k);
    const std::int64_t row = dims[0], slice = dims[0] * dims[1];
    corner = {double(at[0]),           double(at[1]),
              double(at[row]),         double(at[row + 1]),
              double(at[slice]),       double(at[slice + 1]),
              double(at[slice + row]), double(at[slice + row + 1])};
  } else {
    for (int c = 0; c < 8; ++c) {
      const std::int64_t x = i + (c & 1), y = j + (c >> 1 & 1), z = k + (c >> 2);
      const bool within = x >= 0 && y >= 0 && z >= 0 && x < dims[0] && y < dims[1] && z < dims[2];
      corner[c] = within ? double(voxels[x + dims[0] * (y + dims[1] * z)]) : background;
    }
  }

  // along i, then j, then k
  const auto mix = [](double a, double b, double s) { return a + (b - a) * s; };
  const double bottom =
      mix(mix(corner[0], corner[1], t.x()), mix(corner[2], corner[3], t.x()), t.y());
  const double top = mix(mix(corner[4], corner[5], t.x()), mix(corner[6], corner[7], t.x()), t.y());
  return mix(bottom, top, t.z());
}

}  // namespace

Solid::Solid(const haptics::Volume& volume, double isovalue, const Choices& choices)
    : volume_{volume}, isovalue_{isovalue}, choices_{choices} {
  const Vec3 slope =
      Vec3::Constant(volume_.greatest - volume_.least).cwiseQuotient(2.0 * volume_.grid.spacing);
  steepest_ = slope.norm();
}

double Solid::value(const Vec3& p_W) const {
  ++samples_;
  const Vec3 index = volume_.grid.indexOf(p_W);
  // beyond one voxel outside there is only background; it also keeps the index in range
  for (int axis = 0; axis < 3; ++axis)
    if (!(index[axis] > -1.0 && index[axis] < static_cast<double>(volume_.grid.dims[axis])))
      return volume_.least;
  return haptics::visitVoxels(volume_.type, volume_.voxels.get(), [&](const auto* voxels) {
    return trilinear(voxels, volume_.grid.dims, volume_.least, index);
  });
}

Vec3 Solid::differences(const Vec3& p_W) const {
  ++gradients_;
  // (1), with delta one voxel along each axis of the grid
  Vec3 difference;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 delta_W = volume_.grid.direction.col(axis) * volume_.grid.spacing[axis];
    difference[axis] = value(p_W + delta_W) - value(p_W - delta_W);
  }
  return difference;
}

Vec3 Solid::gradient(const Vec3& p_W) const {
  return volume_.grid.direction * differences(p_W).cwiseQuotient(2.0 * volume_.grid.spacing);
}

Vec3 Solid::normal(const Vec3& p_W) const {
  const Vec3 gradient_W =
      choices_.divided_gradient ? gradient(p_W) : Vec3{volume_.grid.direction * differences(p_W)};
  const double size = gradient_W.norm();
  return size > 0.0 ? Vec3{-gradient_W / size} : Vec3::Zero();
}

bool Solid::isInside(double F) const {
  return choices_.inside_includes_equal ? F >= isovalue_ : F > isovalue_;
}

double Solid::gap(const Vec3& p_W) const {
  const double room = isovalue_ - value(p_W);
  const double slope = gradient(p_W).norm();
  if (slope > 0.0) return room / slope;
  return std::copysign(std::numeric_limits<double>::infinity(), room);
}

}  // namespace reference
