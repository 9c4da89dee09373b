// SPDX-License-Identifier: BSD-3-Clause

// palpate-editing: how long the field of an edited volume takes, after a crop and after voxels were
// lowered, and what a private view costs.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

#include "haptics/core/voxel_memory.h"
#include "haptics/edit/edited.h"
#include "haptics/scene/scene.h"

namespace {

using haptics::Scene;
using haptics::Volume;
using haptics::VoxelBox;
using VolumePtr = std::shared_ptr<const Volume>;
using ScenePtr = std::shared_ptr<const Scene>;

constexpr int kRuns = 5;

/// ms of the clock and of all threads together, the least of some runs each.
struct Taken {
  double clock = 1e300, threads = 1e300;
};
template <class F>
Taken fastest(F&& f) {
  Taken least;
  for (int n = 0; n < kRuns; ++n) {
    const std::clock_t worked = std::clock();
    const auto begun = std::chrono::steady_clock::now();
    f();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
    least.clock = std::min(least.clock, took.count());
    least.threads =
        std::min(least.threads, double(std::clock() - worked) * 1e3 / double(CLOCKS_PER_SEC));
  }
  return least;
}
void tell(const char* what, const Taken& taken) {
  std::printf("  %-40s %8.1f %8.1f\n", what, taken.clock, taken.threads);
}

/// Noise of a scan with a ball in the middle.
VolumePtr scanOf(std::int64_t side) {
  haptics::Grid grid;
  grid.dims = {side, side, side};
  grid.spacing = haptics::Vec3::Constant(4e-4);
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16).value();
  auto* out = static_cast<std::int16_t*>(voxels.get());
  std::uint64_t noise = 1;
  const std::int64_t middle = side / 2, radius = side * 2 / 5;
  for (std::int64_t k = 0; k < side; ++k)
    for (std::int64_t j = 0; j < side; ++j)
      for (std::int64_t i = 0; i < side; ++i) {
        noise = noise * 6364136223846793005ULL + 1442695040888963407ULL;
        const std::int64_t x = i - middle, y = j - middle, z = k - middle;
        const bool solid = x * x + y * y + z * z < radius * radius;
        *out++ = static_cast<std::int16_t>((solid ? 1000 : -1000) + static_cast<int>(noise >> 58));
      }
  return std::make_shared<const Volume>(
      haptics::makeVolume(grid, haptics::ScalarType::Int16, std::move(voxels)).value());
}

VolumePtr after(const VolumePtr& before, Volume volume, std::vector<VoxelBox> changed) {
  auto edit = std::make_shared<haptics::Edited>();
  edit->scan = before->edited ? before->edited->scan : before;
  edit->neighbour = before;
  edit->changed = std::move(changed);
  volume.edited = std::move(edit);
  return std::make_shared<const Volume>(std::move(volume));
}

VolumePtr cropped(const VolumePtr& before, const VoxelBox& box) {
  Volume volume = *before;
  volume.crop = box;
  return after(before, std::move(volume), {});
}

VolumePtr lowered(const VolumePtr& before, const VoxelBox& box) {
  Volume volume = *before;
  const auto view = before->memory->privateView().value();
  auto* v = static_cast<std::int16_t*>(view.get());
  const auto& dims = volume.grid.dims;
  for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
    for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
      std::fill_n(v + (k * dims[1] + j) * dims[0] + box.first[0], box.end[0] - box.first[0],
                  static_cast<std::int16_t>(volume.least));
  volume.voxels = view;
  return after(before, std::move(volume), {box});
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t side = argc > 1 ? std::atoll(argv[1]) : 512;
  if (side < 64 || side > 2048) {
    std::fprintf(stderr, "palpate-editing [voxels along a side, 64 to 2048]\n");
    return 2;
  }
  const haptics::Tool tool{"point", {}, haptics::makeShell({haptics::Vec3::Zero()}).value()};
  for (const auto kind : {haptics::FieldKind::Trilinear, haptics::FieldKind::CubicSpline}) {
    const haptics::SceneOptions options{.field = kind};
    const auto make = [&](const VolumePtr& volume, const Scene* previous) {
      return haptics::makeScene(volume, tool, options, previous).value();
    };
    const VolumePtr scan = scanOf(side);
    std::printf(
        "%s field, %lld^3 voxels, int16; ms of the clock and of all threads, the least of %d\n",
        kind == haptics::FieldKind::Trilinear ? "trilinear" : "spline",
        static_cast<long long>(side), kRuns);
    const ScenePtr first = make(scan, nullptr);
    const auto at = [side](double share) {
      return static_cast<std::int64_t>(share * static_cast<double>(side));
    };
    const auto box = [&](double from, double to) {
      return VoxelBox{{at(from), at(from), at(from)}, {at(to), at(to), at(to)}};
    };
    const auto step = [&](const char* what, const VolumePtr& from, const VolumePtr& to) {
      // as in the window, where each scene follows from the scan's
      const ScenePtr before = from == scan ? first : make(from, first.get());
      tell(what, fastest([&] { make(to, before.get()); }));
    };
    tell("private view", fastest([&] { static_cast<void>(scan->memory->privateView().value()); }));
    tell("scene anew", fastest([&] { make(scan, nullptr); }));
    const VolumePtr wide = cropped(scan, box(0.1, 0.9)), narrow = cropped(wide, box(0.3, 0.7));
    const VolumePtr half = cropped(scan, {{0, 0, 0}, {side / 2, side, side}});
    step("crop to 0.8 of each side", scan, wide);
    step("crop from there to 0.4", wide, narrow);
    step("crop to a half", scan, half);
    step("crop to 0.8 taken back", wide, scan);
    step("crop to 0.4 taken back", narrow, wide);
    step("crop to a half taken back", half, scan);
    step("0.2 of each side lowered", scan, lowered(scan, box(0.4, 0.6)));
    step("0.5 of each side lowered", scan, lowered(scan, box(0.25, 0.75)));
  }
  return 0;
}
