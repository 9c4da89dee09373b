// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "haptics/core/volume.h"
#include "haptics/tool/point_shell.h"

namespace reference_test {

using haptics::Vec3;

/// A float volume of n voxels a side, `spacing` m apart, whose middle is the origin of W, filled
/// with f(p_W).
template <class F>
haptics::Volume sampled(int n, const Vec3& spacing, F&& f,
                        const haptics::Mat3& direction = haptics::Mat3::Identity()) {
  haptics::Grid grid;
  grid.dims = {n, n, n};
  grid.spacing = spacing;
  grid.direction = direction;
  grid.origin = -(direction * (spacing * ((n - 1) / 2.0)));
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Float32).value();
  auto* out = static_cast<float*>(voxels.get());
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        *out++ = static_cast<float>(f(grid.worldOf({double(i), double(j), double(k)})));
  return haptics::makeVolume(grid, haptics::ScalarType::Float32, voxels).value();
}

/// F falls by 100 per mm of height and is 0 at z = 0: the half-space z <= 0 at isovalue 0.
/// Trilinear samples of it are exact.
inline haptics::Volume halfSpace(int n, double spacing) {
  return sampled(n, Vec3::Constant(spacing), [](const Vec3& p) { return -1e5 * p.z(); });
}

/// F is 100 times the depth in mm below a sphere's surface, held within ±300, with noise.
inline haptics::Volume sphere(int n, double spacing, double radius, double noise) {
  std::mt19937 random{11};
  std::normal_distribution<double> grain{0.0, 1.0};
  return sampled(n, Vec3::Constant(spacing), [&](const Vec3& p) {
    const double depth = radius - p.norm();
    return std::fmin(300.0, std::fmax(-300.0, 1e5 * depth)) + noise * 600.0 * grain(random);
  });
}

/// Points spread over a ball's surface along a spiral.
inline haptics::PointShell ball(int count, double radius) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double turn = i * M_PI * (3.0 - std::sqrt(5.0));
    const double side = std::sqrt(1.0 - z * z);
    points.push_back(radius * Vec3{side * std::cos(turn), side * std::sin(turn), z});
  }
  return haptics::makeShell(std::move(points)).value();
}

}  // namespace reference_test
