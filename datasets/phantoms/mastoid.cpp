// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/phantoms/mastoid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "datasets/phantoms/noise.h"
#include "datasets/phantoms/sampling.h"
#include "datasets/phantoms/shapes.h"
#include "datasets/phantoms/tube.h"
#include "haptics/core/parallel.h"

namespace datasets {
namespace mastoid {
namespace {

using haptics::Vec3;

constexpr double kSpacing = 0.0004;  // m
constexpr double kBlur = 0.4;        // mm on either side of a surface

// HU
constexpr double kAir = -1000, kBrain = 36, kNerve = 40, kBlood = 45, kDura = 60, kSheath = 0,
                 kFluid = 10, kSeptum = 900, kCortex = 1500;

/// A part of the bone: what it holds, and how thick the dense bone around it is.
struct Part {
  PhantomStructure structure;
  double value = 0.0;    ///< HU
  double wall_mm = 0.0;  ///< at least so much bone without air cells
};

// what follows is in mm: x towards the patient's left, so outwards, y back, z up

shapes::Tube tube(std::vector<Vec3> points, double radius, std::vector<double> bends = {}) {
  for (Vec3& point : points) point *= 1e-3;
  for (double& bend : bends) bend *= 1e-3;
  return {points, 1e-3 * radius, bends};
}

/// From a fundus inwards over the genu and along the cavity of the ear, and then down.
shapes::Tube alongTheNerve(double radius) {
  return tube({{-16, -13.5, 8.8}, {-12, -16, 8.3}, {-6.5, -5, 5}, {-4.5, -4, -10}}, radius,
              {1.5, 2.5});
}

/// A solid that stands about the origin, turned and put in its place.
template <class Shape>
auto placed(const Shape& shape, const Vec3& centre, const Vec3& up) {
  const haptics::Mat3 turn = haptics::Quat::FromTwoVectors(up, Vec3::UnitZ()).toRotationMatrix();
  return [shape, turn, centre = Vec3{1e-3 * centre}](const Vec3& p_W) {
    return shape.distance(turn * (p_W - centre));
  };
}

const Vec3 kPlateCentre{-1, 0, 15};
const Vec3 kPlateUp =
    Vec3{0.10, -0.05, 1.0}.normalized();  // it falls outwards and rises to the back

/// Later parts are laid over earlier ones.
std::vector<Part> makeParts() {
  const auto of = [](const shapes::Tube& shape) {
    return [shape](const Vec3& p_W) { return shape.distance(p_W); };
  };
  std::vector<Part> parts;
  parts.push_back({{"Dura plate",
                    {0.90, 0.72, 0.62},
                    placed(shapes::Box{{0.015, 0.017, 0.0005}}, kPlateCentre, kPlateUp)},
                   kDura,
                   1.0});
  parts.push_back({{"Sigmoid sinus",
                    {0.25, 0.42, 0.85},
                    of(tube({{9, 16, 8.5}, {7, 11, 0}, {-9, 9, -3}}, 4.5, {8}))},
                   kBlood,
                   1.0});
  parts.push_back(
      {{"Lateral semicircular canal",
        {0.36, 0.75, 0.72},
        placed(shapes::Torus{.ring = 0.0032, .tube = 0.0005}, {-10.5, -1.5, 8}, {0.0, 0.5, 0.87})},
       kFluid,
       2.5});
  parts.push_back({{"Facial canal", {0.93, 0.66, 0.32}, of(alongTheNerve(0.9))}, kSheath, 0.7});
  parts.push_back({{"Facial nerve", {0.96, 0.86, 0.20}, of(alongTheNerve(0.6))}, kNerve, 1.0});
  parts.push_back({{"Antrum", {0.66, 0.80, 0.93}, of(tube({{-1, 3, 9}}, 4))}, kAir, 0.6});
  parts.push_back(
      {{"Tympanic cavity", {0.55, 0.72, 0.90}, of(tube({{-4.2, -10.4, -2}, {-4.2, -9.8, 6}}, 2.7))},
       kAir,
       0.6});
  parts.push_back(
      {{"Ear canal", {0.43, 0.64, 0.87}, of(tube({{19.5, -8.5, 2}, {2.8, -10.3, 3}}, 3.75))},
       kAir,
       1.0});
  return parts;
}

const std::vector<Part>& parts() {
  static const std::vector<Part> all = makeParts();
  return all;
}

/// From 0 to 1 while x goes from a to b.
double eased(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
double mixed(double a, double b, double t) { return a + t * (b - a); }
double share(double distance) { return eased(kBlur, -kBlur, distance); }

/// To the outer surface: a block with round edges, and the mastoid process.
double outside(const Vec3& p) {
  constexpr double kRound = 6;
  const double block = shapes::Box{{13, 16.5, 10}}.distance(p - Vec3{-1, 0, 6}) - kRound;
  const Vec3 from{9, 6, -6}, to{9, 2, -16}, axis = to - from;
  const double t = std::clamp((p - from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return std::min(block, (p - from - t * axis).norm() - mixed(10, 6, t));
}

/// Cells of air between thin walls, where the bone is neither its surface nor a wall.
double boneValue(const Vec3& p, double depth, double beyond_walls) {
  const double porous = eased(2.0, 3.0, depth) * eased(0.0, 0.8, beyond_walls);
  if (porous <= 0.0) return kCortex;
  const auto at = [&](double size, std::uint64_t seed) {
    const Eigen::Vector3f q = (p / size).cast<float>();
    return double(noise::smooth(q.x(), q.y(), q.z(), seed));
  };
  const double from_septum = std::abs(at(2.4, 51) + 0.4 * at(1.1, 52));
  return mixed(kCortex, mixed(kSeptum, kAir, eased(0.06, 0.20, from_septum)), porous);
}

}  // namespace

double valueAt(const Vec3& p_W) {
  const Vec3 p = 1e3 * p_W;
  const double out = outside(p);
  if (out >= kBlur) return kAir;
  double beyond_walls = HUGE_VAL;
  std::array<double, 16> distances{};
  for (std::size_t n = 0; n < parts().size(); ++n) {
    distances[n] = 1e3 * parts()[n].structure.distance(p_W);
    beyond_walls = std::min(beyond_walls, distances[n] - parts()[n].wall_mm);
  }
  double value = boneValue(p, -out, beyond_walls);
  // the brain lies on the plate and reaches through the block's top, where it is cut
  static const auto brain =
      placed(shapes::Box{{0.0145, 0.0165, 0.005}}, kPlateCentre + 5.5 * kPlateUp, kPlateUp);
  value = mixed(value, kBrain, share(1e3 * brain(p_W)));
  for (std::size_t n = 0; n < parts().size(); ++n)
    value = mixed(value, parts()[n].value, share(distances[n]));
  return mixed(kAir, value, share(out));
}

std::vector<PhantomStructure> structures() {
  std::vector<PhantomStructure> all;
  for (const Part& part : parts()) all.push_back(part.structure);
  return all;
}

}  // namespace mastoid

haptics::Expected<Phantom> mastoidPhantom(const std::atomic<bool>* cancel) {
  const haptics::Grid grid = centredGrid(120, 128, 120, mastoid::kSpacing);
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16);
  if (!voxels) return tl::unexpected(voxels.error());
  auto* first = static_cast<std::int16_t*>(voxels->get());
  haptics::inParallel(grid.dims[2], [&](std::int64_t k) {
    if (cancel != nullptr && *cancel) return;
    std::int16_t* next = first + k * grid.dims[0] * grid.dims[1];
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i)
        *next++ = static_cast<std::int16_t>(
            std::lround(mastoid::valueAt(grid.worldOf({double(i), double(j), double(k)}))));
  });
  if (cancel != nullptr && *cancel)
    return tl::unexpected(haptics::Error{haptics::Error::Kind::Cancelled, {}, "cancelled"});
  return haptics::makeVolume(grid, haptics::ScalarType::Int16, std::move(*voxels),
                             {.unit = "HU", .modality = "CT"})
      .map([](haptics::Volume&& volume) {
        return Phantom{.volume = std::move(volume), .isovalue = 300.0, .tool = "burr-4"};
      });
}

}  // namespace datasets
