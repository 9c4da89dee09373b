// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "datasets/phantoms/making.h"
#include "haptics/core/volume.h"
#include "haptics/process/process_limits.h"
#include "haptics/scene/scene.h"
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

/// A sanitizer looks at what is done with memory and threads, which does not depend on how often it
/// is done, or with how many devices of a kind.
using haptics::kSanitized;

/// Whether a test takes fewer devices of a kind than there are: under a sanitizer, unless the run
/// is to prove a release (packaging/test --all).
inline bool fewDevices() { return kSanitized && std::getenv("PALPATE_TEST_ALL") == nullptr; }

/// How often a random test repeats: a tenth under a sanitizer.
constexpr int trials(int n) { return kSanitized ? n / 10 : n; }

using datasets::at;

inline std::shared_ptr<const Volume> shared(Volume volume) {
  return std::make_shared<const Volume>(std::move(volume));
}

inline haptics::Tool tool(std::vector<Vec3> points) {
  return {"made", {}, haptics::makeShell(std::move(points)).value()};
}
inline haptics::Tool point() { return tool({Vec3::Zero()}); }

inline std::shared_ptr<const haptics::Scene> scene(Volume volume, haptics::Tool tool) {
  return haptics::makeScene(shared(std::move(volume)), std::move(tool)).value();
}

/// A rotation, an anisotropy and a handedness for the k-th of some grids.
inline Grid oddGrid(int k, std::array<std::int64_t, 3> dims, datasets::Random& random) {
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
inline Volume randomVolume(const Grid& grid, ScalarType type, datasets::Random& random) {
  const double span[] = {255, 127, 65535, 32767, 4294967295.0, 2147483647.0, 3000.0};
  const double top = span[static_cast<int>(type)];
  const bool is_signed = type == ScalarType::Int8 || type == ScalarType::Int16 ||
                         type == ScalarType::Int32 || type == ScalarType::Float32;
  return datasets::filled(
      grid, type, [&](auto, auto, auto) { return random.in(is_signed ? -top - 1.0 : 0.0, top); });
}

/// A box of voxels within the grid, at random: often at its faces, sometimes one voxel thick.
inline haptics::VoxelBox randomBox(const Grid& grid, datasets::Random& random) {
  haptics::VoxelBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto n = static_cast<int>(grid.dims[axis]);
    box.first[axis] = random.below(4) == 0 ? 0 : random.below(n);
    box.end[axis] = random.below(4) == 0
                        ? n
                        : box.first[axis] + 1 + random.below(n - static_cast<int>(box.first[axis]));
  }
  return box;
}

/// The volume without the voxels outside a box, which it still has in memory.
inline Volume cropped(Volume volume, const haptics::VoxelBox& box) {
  volume.crop = box;
  return volume;
}

}  // namespace made
