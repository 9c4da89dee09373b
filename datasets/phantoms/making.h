// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include "haptics/core/volume.h"

/// What tests and studies make their volumes, tools and poses of.
namespace datasets {

inline haptics::Pose at(const haptics::Vec3& p,
                        const haptics::Quat& q = haptics::Quat::Identity()) {
  return haptics::poseOf(p, q);
}
inline haptics::Pose at(double x, double y, double z) { return at(haptics::Vec3{x, y, z}); }

/// Random numbers of one seed, in the shapes that are asked for.
class Random {
 public:
  explicit Random(unsigned seed) : engine_{seed} {}
  double in(double from, double to) {
    return std::uniform_real_distribution<double>{from, to}(engine_);
  }
  int below(int n) { return std::uniform_int_distribution<int>{0, n - 1}(engine_); }
  haptics::Vec3 box(double half) { return {in(-half, half), in(-half, half), in(-half, half)}; }
  haptics::Vec3 direction() {
    std::normal_distribution<double> normal;
    return haptics::Vec3{normal(engine_), normal(engine_), normal(engine_)}.normalized();
  }
  haptics::Quat rotation() {
    std::normal_distribution<double> normal;
    return haptics::Quat{normal(engine_), normal(engine_), normal(engine_), normal(engine_)}
        .normalized();
  }
  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_;
};

/// Voxels of a type from f(i, j, k), clamped and rounded to what it holds.
template <class F>
haptics::Volume filled(const haptics::Grid& grid, haptics::ScalarType type, F&& f) {
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), type).value();
  haptics::visitVoxels(type, static_cast<const void*>(voxels.get()), [&](const auto* first) {
    using T = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
    T* out = const_cast<T*>(first);
    for (std::int64_t k = 0; k < grid.dims[2]; ++k)
      for (std::int64_t j = 0; j < grid.dims[1]; ++j)
        for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
          const double value = f(i, j, k);
          if constexpr (std::is_floating_point_v<T>) {
            *out++ = static_cast<T>(value);
          } else {
            *out++ = static_cast<T>(std::fmin(
                double(std::numeric_limits<T>::max()),
                std::fmax(double(std::numeric_limits<T>::lowest()), std::nearbyint(value))));
          }
        }
  });
  return haptics::makeVolume(grid, type, std::move(voxels)).value();
}

/// A float volume from f(p_W).
template <class F>
haptics::Volume sampledFloat(const haptics::Grid& grid, F&& f) {
  return filled(grid, haptics::ScalarType::Float32, [&](auto i, auto j, auto k) {
    return f(grid.worldOf(haptics::Vec3{double(i), double(j), double(k)}));
  });
}

/// F = 1000 - 4000 · distance / voxel, held from `reach` voxels on: isovalue 1000 is the surface.
template <class Distance>
haptics::Volume solid(const haptics::Grid& grid, Distance&& distance, double reach = 3.0) {
  const double h = grid.spacing.minCoeff();
  return sampledFloat(grid, [&](const haptics::Vec3& p) {
    return 1000.0 - 4000.0 * std::fmin(reach, std::fmax(-reach, distance(p) / h));
  });
}
inline constexpr double kSolidIso = 1000.0;

/// A source of normal numbers: mean 0, standard deviation 1.
inline auto grains(unsigned seed) {
  return [engine = std::mt19937{seed}, normal = std::normal_distribution<double>{}]() mutable {
    return normal(engine);
  };
}

/// White noise: mean 0, standard deviation 100.
inline haptics::Volume whiteNoise(const haptics::Grid& grid, unsigned seed) {
  return filled(grid, haptics::ScalarType::Float32,
                [grain = grains(seed)](auto, auto, auto) mutable { return 100.0 * grain(); });
}

/// Points spread over a ball's surface along a spiral; `radius` [m].
inline std::vector<haptics::Vec3> ballPoints(int count, double radius) {
  std::vector<haptics::Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, side = std::sqrt(1.0 - z * z);
    const double turn = i * M_PI * (3.0 - std::sqrt(5.0));
    points.push_back(radius * haptics::Vec3{side * std::cos(turn), side * std::sin(turn), z});
  }
  return points;
}

/// The same over a rod along x; lengths [m].
inline std::vector<haptics::Vec3> rodPoints(int count, double length, double radius) {
  std::vector<haptics::Vec3> points;
  for (int n = 0; n < count; ++n) {
    const double turn = n * M_PI * (3.0 - std::sqrt(5.0));
    points.push_back(
        {length * ((n + 0.5) / count - 0.5), radius * std::cos(turn), radius * std::sin(turn)});
  }
  return points;
}

/// A flat square of side² points in z = 0; `width` [m].
inline std::vector<haptics::Vec3> platePoints(int side, double width) {
  std::vector<haptics::Vec3> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      points.push_back(
          {width * (double(i) / (side - 1) - 0.5), width * (double(j) / (side - 1) - 0.5), 0.0});
  return points;
}

}  // namespace datasets
