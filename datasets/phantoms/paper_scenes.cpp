// SPDX-License-Identifier: BSD-3-Clause
// Rebuilds of three scenes of [Chan 2011], Table 1, by formula.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>
#include <type_traits>
#include <vector>

#include "datasets/phantoms/analytic.h"
#include "datasets/phantoms/noise.h"
#include "datasets/phantoms/sampling.h"

namespace datasets {
namespace {

using haptics::Grid;
using haptics::Vec3;

/// How a signed distance becomes intensity: from `outside` to `inside` over three voxels, the
/// blur of a scanner, with white noise on top.
struct Scanner {
  double outside = 0.0, inside = 1000.0;
  double noise = 0.0;      ///< deviation
  double blur = 0.001;     ///< m on either side of the surface
  double lipschitz = 1.0;  ///< of the distance
  std::uint64_t seed = 1;
};

/// Samples a solid, `distance(p_W)` in metres and positive outside. Blocks that the distance at
/// their middle shows to be far from the surface are filled without asking again.
template <class T, class Distance>
haptics::Expected<haptics::Volume> scanned(const Grid& grid, const Scanner& scanner,
                                           haptics::ScalarType type,
                                           const std::atomic<bool>* cancel, Distance distance) {
  constexpr std::int64_t kBlockSide = 8;
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), type);
  if (!voxels) return tl::unexpected(voxels.error());
  T* const first = static_cast<T*>(voxels->get());
  const auto stopped = [cancel] { return cancel != nullptr && *cancel; };
  const double block_radius = 0.5 * kBlockSide * grid.spacing.norm();

  const auto fillBlock = [&](std::int64_t i0, std::int64_t j0, std::int64_t k0) {
    const std::int64_t i1 = std::min(i0 + kBlockSide, grid.dims[0]),
                       j1 = std::min(j0 + kBlockSide, grid.dims[1]),
                       k1 = std::min(k0 + kBlockSide, grid.dims[2]);
    const double middle =
        distance(grid.worldOf(0.5 * Vec3{double(i0 + i1), double(j0 + j1), double(k0 + k1)}));
    const bool far = std::abs(middle) > scanner.lipschitz * block_radius + scanner.blur;
    const auto intensity = [&](double d) {
      const double share = std::clamp(0.5 - 0.5 * d / scanner.blur, 0.0, 1.0);
      return static_cast<float>(scanner.outside + (scanner.inside - scanner.outside) * share *
                                                      share * (3.0 - 2.0 * share));
    };
    const float middle_value = intensity(middle);
    const auto noise_size = static_cast<float>(scanner.noise);
    for (std::int64_t k = k0; k < k1; ++k)
      for (std::int64_t j = j0; j < j1; ++j) {
        T* row = first + grid.dims[0] * (j + grid.dims[1] * k);
        for (std::int64_t i = i0; i < i1; ++i) {
          float value = middle_value;
          if (!far) value = intensity(distance(grid.worldOf({double(i), double(j), double(k)})));
          value += noise_size * noise::gaussian(noise::hashed(i, j, k, scanner.seed));
          if constexpr (std::is_unsigned_v<T>)
            value = std::clamp(value, 0.0f, float(std::numeric_limits<T>::max()));
          // to the nearest; the offset keeps it positive
          row[i] = static_cast<T>(static_cast<int>(value + 16384.5f) - 16384);
        }
      }
  };
  // slabs of blocks in turn to as many threads as there are
  const auto threads = static_cast<std::int64_t>(std::max(1u, std::thread::hardware_concurrency()));
  const auto fillSlabs = [&](std::int64_t turn) {
    for (std::int64_t k = turn * kBlockSide; k < grid.dims[2] && !stopped();
         k += threads * kBlockSide)
      for (std::int64_t j = 0; j < grid.dims[1]; j += kBlockSide)
        for (std::int64_t i = 0; i < grid.dims[0]; i += kBlockSide) fillBlock(i, j, k);
  };
  std::vector<std::jthread> pool;
  for (std::int64_t turn = 0; turn < threads; ++turn) pool.emplace_back(fillSlabs, turn);
  pool.clear();
  if (stopped())
    return tl::unexpected(haptics::Error{haptics::Error::Kind::Cancelled, {}, "cancelled"});
  return haptics::makeVolume(grid, type, std::move(*voxels));
}

// distances in millimetres, positive outside; exact, or at most the distance

double ball(const Vec3& p, const Vec3& centre, double radius) {
  return (p - centre).norm() - radius;
}
double capsule(const Vec3& p, const Vec3& a, const Vec3& b, double radius) {
  const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - along * (b - a)).norm() - radius;
}
double box(const Vec3& p, const Vec3& centre, const Vec3& half) {
  const Vec3 d = (p - centre).cwiseAbs() - half;
  return d.cwiseMax(0.0).norm() + std::min(d.maxCoeff(), 0.0);
}
/// A rod along an axis of the grid.
double rod(const Vec3& p, const Vec3& centre, int axis, double radius, double half_length) {
  const Vec3 d = p - centre;
  const double across = std::hypot(d[(axis + 1) % 3], d[(axis + 2) % 3]) - radius;
  return std::max(across, std::abs(d[axis]) - half_length);
}
/// The union, its crease rounded over `width`.
double blended(double a, double b, double width) {
  const double h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - 0.25 * h * h * width;
}
/// Bumps of that many millimetres, from -1 to 1.
double bumps(const Vec3& p, double size, std::uint64_t seed) {
  const Vec3 q = p / size;
  return double(noise::smooth(float(q.x()), float(q.y()), float(q.z()), seed));
}

/// A sitting animal of clay, hollow, its wall 5 mm thick, its coat a texture of 0.35 mm.
double bunnyDistance(const Vec3& p) {
  double d = capsule(p, {0, -8, -38}, {0, 26, -34}, 40);
  d = blended(d, capsule(p, {0, -22, 0}, {0, -34, 22}, 20), 18);
  d = blended(d, ball(p, {0, -38, 36}, 24), 12);
  for (const double side : {-1.0, 1.0}) {
    d = blended(d, capsule(p, {side * 12, -32, 54}, {side * 20, -18, 78}, 7), 6);
    d = blended(d, capsule(p, {side * 24, -48, -62}, {side * 26, -20, -66}, 13), 8);
  }
  d = blended(d, ball(p, {0, 68, -52}, 12), 6);
  if (std::abs(d) < 8.0) d += 0.35 * bumps(p, 4.0, 11);
  return std::abs(d + 2.5) - 2.5;
}

/// A cast block with four bores, ribs, pipes on its sides and bolts on its top.
double engineDistance(const Vec3& p) {
  double d = box(p, {0, 0, -4}, {58, 34, 20});
  for (int n = 0; n < 7; ++n) d = std::min(d, box(p, {-54.0 + 18.0 * n, -38, -4}, {2.0, 6, 16}));
  d = std::min(d, box(p, {0, 0, -21}, {66, 46, 4}));
  for (const double x : {-42.0, -14.0, 14.0, 42.0}) {
    d = blended(d, rod(p, {x, 40, 4}, 1, 8, 18), 4);
    for (const double y : {-28.0, 28.0}) d = std::min(d, rod(p, {x + 14, y, 14}, 2, 4, 8));
  }
  for (const double x : {-42.0, -14.0, 14.0, 42.0}) {
    d = std::max(d, -rod(p, {x, 0, 10}, 2, 11, 26));
    d = std::max(d, -rod(p, {x, 44, 4}, 1, 5, 26));
  }
  for (const double y : {-20.0, 20.0}) d = std::max(d, -rod(p, {0, y, -6}, 0, 5, 80));
  return d;
}

/// Air cells of a mastoid: one bubble in each cube of 3.2 mm, some of them joined, walls from
/// nothing to 2 mm.
double airCells(const Vec3& p) {
  constexpr double kSide = 3.2;  // mm
  const Vec3 q = p / kSide;
  const Vec3 low = (q - Vec3::Constant(0.5)).array().floor();
  double d = 0.3;  // in sides: enough for the blur
  for (int c = 0; c < 8; ++c) {
    const Vec3 cube = low + Vec3{double(c & 1), double(c >> 1 & 1), double(c >> 2)};
    const std::uint64_t bits =
        noise::hashed(std::int64_t(cube.x()), std::int64_t(cube.y()), std::int64_t(cube.z()), 31);
    const auto part = [&](int shift) { return double(bits >> shift & 0xffff) / 65536.0 - 0.5; };
    const Vec3 centre = cube + Vec3::Constant(0.5) + 0.4 * Vec3{part(0), part(16), part(32)};
    const double radius = 0.38 + 0.16 * part(48), square = (q - centre).squaredNorm();
    if (square < (radius + d) * (radius + d)) d = std::sqrt(square) - radius;
  }
  return d * kSide;
}

/// A temporal bone: a cortex of about 2 mm over air cells, an ear canal, and a cavity drilled into
/// it from the front.
double boneDistance(const Vec3& p) {
  double d = capsule(p, {-26, 4, -3}, {26, 8, 3}, 23);
  d = blended(d, capsule(p, {18, -4, -8}, {34, -22, -14}, 9), 8);
  if (std::abs(d) < 4.0) d += 0.15 * bumps(p, 1.5, 13);
  const double cortex = d + 1.2 + 0.6 * bumps(p, 9.0, 17);
  d = std::max(d, -capsule(p, {-70, -2, 0}, {-8, 4, 0}, 4));
  d = std::max(d, -blended(ball(p, {4, -20, 2}, 9), ball(p, {-2, -12, -1}, 7), 3));
  // far from the bone the bubbles decide nothing
  if (cortex < 4.0) d = std::max(d, -std::max(airCells(p), cortex));
  return d;
}

/// A scan with the isovalue of its surface and the tool that fits it.
haptics::Expected<Phantom> withTool(haptics::Expected<haptics::Volume> volume, double isovalue,
                                    const char* tool) {
  return std::move(volume).map([&](haptics::Volume&& made) {
    return Phantom{.volume = std::move(made), .isovalue = isovalue, .tool = tool};
  });
}

}  // namespace

haptics::Expected<Phantom> bunnyPhantom(const std::atomic<bool>* cancel) {
  const Grid grid = centredGrid(512, 512, 361, 1e-3 * Vec3{0.337891, 0.337891, 0.5});
  const Scanner scanner{.inside = 3100, .noise = 25, .blur = 0.0006, .lipschitz = 1.4, .seed = 3};
  return withTool(
      scanned<std::int16_t>(grid, scanner, haptics::ScalarType::Int16, cancel,
                            [](const Vec3& p) { return 1e-3 * bunnyDistance(1e3 * p); }),
      1500, "cane");
}

haptics::Expected<Phantom> enginePhantom(const std::atomic<bool>* cancel) {
  const Grid grid = centredGrid(256, 256, 110, 1e-3 * Vec3{0.6, 0.6, 0.6});
  const Scanner scanner{.outside = 8, .inside = 190, .noise = 2, .blur = 0.0009, .seed = 5};
  return withTool(
      scanned<std::uint8_t>(grid, scanner, haptics::ScalarType::UInt8, cancel,
                            [](const Vec3& p) { return 1e-3 * engineDistance(1e3 * p); }),
      90, "wrench");
}

haptics::Expected<Phantom> bonePhantom(const std::atomic<bool>* cancel) {
  const Grid grid = centredGrid(768, 768, 70, 1e-3 * Vec3{0.15, 0.15, 0.5});
  const Scanner scanner{.inside = 2800, .noise = 40, .blur = 0.00035, .lipschitz = 1.6, .seed = 7};
  return withTool(scanned<std::int16_t>(grid, scanner, haptics::ScalarType::Int16, cancel,
                                        [](const Vec3& p) { return 1e-3 * boneDistance(1e3 * p); }),
                  1400, "drill");
}

}  // namespace datasets
