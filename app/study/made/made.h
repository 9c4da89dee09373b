// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "haptics/core/volume.h"
#include "haptics/scene.h"
#include "haptics/tool/point_shell.h"

/// Volumes, tools and poses that the tests make for themselves.
namespace made {

using haptics::Grid;
using haptics::Mat3;
using haptics::Pose;
using haptics::Quat;
using haptics::ScalarType;
using haptics::Vec3;
using haptics::Volume;

/// How often a random test repeats: a tenth under a sanitizer.
constexpr int trials(int n) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return n / 10;
#else
  return n;
#endif
}

/// Random numbers of one seed, in the shapes the tests ask for.
class Random {
 public:
  explicit Random(unsigned seed) : engine_{seed} {}
  double in(double from, double to) {
    return std::uniform_real_distribution<double>{from, to}(engine_);
  }
  int below(int n) { return std::uniform_int_distribution<int>{0, n - 1}(engine_); }
  Vec3 box(double half) { return {in(-half, half), in(-half, half), in(-half, half)}; }
  Vec3 direction() {
    std::normal_distribution<double> normal;
    return Vec3{normal(engine_), normal(engine_), normal(engine_)}.normalized();
  }
  Quat rotation() {
    std::normal_distribution<double> normal;
    return Quat{normal(engine_), normal(engine_), normal(engine_), normal(engine_)}.normalized();
  }
  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_;
};

inline Pose at(const Vec3& p, const Quat& q = Quat::Identity()) { return haptics::poseOf(p, q); }
inline Pose at(double x, double y, double z) { return at(Vec3{x, y, z}); }

/// A grid of cubes of side `spacing` [m] whose middle is the origin of W.
inline Grid centred(std::int64_t n, double spacing) {
  Grid grid;
  grid.dims = {n, n, n};
  grid.spacing.setConstant(spacing);
  grid.origin.setConstant(-0.5 * spacing * double(n - 1));
  return grid;
}

/// Voxels of type T from f(i, j, k), clamped and rounded to what T holds.
template <class F>
Volume filled(const Grid& grid, ScalarType type, F&& f) {
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
Volume sampled(const Grid& grid, F&& f) {
  return filled(grid, ScalarType::Float32, [&](auto i, auto j, auto k) {
    return f(grid.worldOf(Vec3{double(i), double(j), double(k)}));
  });
}

/// F = 1000 - 4000 · distance / voxel, held from `reach` voxels on: isovalue 1000 is the surface.
template <class Distance>
Volume solid(const Grid& grid, Distance&& distance, double reach = 3.0) {
  const double h = grid.spacing.minCoeff();
  return sampled(grid, [&](const Vec3& p) {
    return 1000.0 - 4000.0 * std::fmin(reach, std::fmax(-reach, distance(p) / h));
  });
}
inline constexpr double kIso = 1000.0;

/// White noise: mean 0, standard deviation 100.
inline Volume noise(const Grid& grid, unsigned seed) {
  std::mt19937 engine{seed};
  std::normal_distribution<double> grain{0.0, 100.0};
  return filled(grid, ScalarType::Float32, [&](auto, auto, auto) { return grain(engine); });
}

inline std::shared_ptr<const Volume> shared(Volume volume) {
  return std::make_shared<const Volume>(std::move(volume));
}

/// Points spread over a ball's surface along a spiral.
inline std::vector<Vec3> ballPoints(int count, double radius) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, side = std::sqrt(1.0 - z * z);
    const double turn = i * M_PI * (3.0 - std::sqrt(5.0));
    points.push_back(radius * Vec3{side * std::cos(turn), side * std::sin(turn), z});
  }
  return points;
}

inline haptics::Tool tool(std::vector<Vec3> points) {
  return {"made", {}, haptics::makeShell(std::move(points)).value()};
}
inline haptics::Tool point() { return tool({Vec3::Zero()}); }

inline std::shared_ptr<const haptics::Scene> scene(Volume volume, haptics::Tool tool) {
  return haptics::makeScene(shared(std::move(volume)), std::move(tool)).value();
}

/// A rotation, an anisotropy and a handedness for the k-th of some grids.
inline Grid oddGrid(int k, std::array<std::int64_t, 3> dims, Random& random) {
  Grid grid;
  grid.dims = dims;
  grid.spacing = k % 2 == 0 ? Vec3{4e-4, 7e-4, 2e-3} : Vec3{1e-3, 3e-4, 5e-4};
  grid.direction = random.rotation().toRotationMatrix();
  if (k % 3 == 1) grid.direction.col(k % 2) *= -1.0;  // left-handed
  grid.origin = random.box(0.3);
  return grid;
}

inline constexpr ScalarType kTypes[] = {ScalarType::UInt8,  ScalarType::Int8,   ScalarType::UInt16,
                                        ScalarType::Int16,  ScalarType::UInt32, ScalarType::Int32,
                                        ScalarType::Float32};

/// The full range of a type, at random.
inline Volume randomVolume(const Grid& grid, ScalarType type, Random& random) {
  const double span[] = {255, 127, 65535, 32767, 4294967295.0, 2147483647.0, 3000.0};
  const double top = span[static_cast<int>(type)];
  const bool is_signed = type == ScalarType::Int8 || type == ScalarType::Int16 ||
                         type == ScalarType::Int32 || type == ScalarType::Float32;
  return filled(grid, type,
                [&](auto, auto, auto) { return random.in(is_signed ? -top - 1.0 : 0.0, top); });
}

}  // namespace made
