// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/cut_structures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/recording/replay.h"

namespace app::report {
namespace {

using haptics::Vec3;

/// Calls f(i, j, k) for each voxel of a box.
template <class F>
void forEachVoxel(const haptics::VoxelBox& box, F&& f) {
  for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
    for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
      for (std::int64_t i = box.first[0]; i < box.end[0]; ++i) f(i, j, k);
}

Vec3 placeOf(const haptics::Grid& grid, std::int64_t i, std::int64_t j, std::int64_t k) {
  return grid.worldOf(Vec3(double(i), double(j), double(k)));
}

}  // namespace

bool belongs(const haptics::DistanceMap& map, const Vec3& p_W) {
  return map.atIndex(map.grid.indexOf(p_W).array().round().matrix()) < 0.0;
}

CutStructures::CutStructures(const Recording& recording, const haptics::Watch& watch,
                             std::shared_ptr<const haptics::Volume> scan,
                             const std::optional<VolumeHash>& hash)
    : recording_{recording},
      watch_{watch},
      scan_{std::move(scan)},
      hash_{hash},
      taken_(watch.structures.size()) {
  if (recording.isCut() && scan_->voxels == nullptr) std::ranges::fill(taken_, Taken{kNone, kNone});
}

haptics::Expected<void> CutStructures::add(const haptics::Step& step) {
  if (!step.cut || scan_->voxels == nullptr || taken_.empty()) return {};
  if (step.scene != scene_) {
    const RecordedScene* then = recording_.scene(step.scene);
    if (then == nullptr || !isOf(*then, *scan_, hash_)) return {};
    endScene();
    auto volume = touchedAsRecorded(scan_, *then, &watch_);
    if (!volume) return tl::unexpected(volume.error());
    scene_ = step.scene;
    if (before_ == nullptr) before_ = *volume;
    copy_.emplace(std::move(*volume));
  }
  const auto done = copy_->carve(*step.cut);
  if (!done) return tl::unexpected(done.error());
  cut_ = joined(cut_, done->box);
  last_ = *step.cut;
  return {};
}

/// Adds what was removed in the scene, which its voxels say.
void CutStructures::endScene() {
  if (isEmpty(cut_)) return;
  for (std::size_t n = 0; n < taken_.size(); ++n)
    taken_[n].removed += removedOf(watch_.structures[n].distances);
  all_ = joined(all_, std::exchange(cut_, {}));
}

double CutStructures::removedOf(const haptics::DistanceMap& map) const {
  const haptics::Volume& volume = *copy_->uncut();
  const haptics::PartOfVoxel partOf{volume, last_};
  double sum = 0.0;
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* before) {
    const auto* after = static_cast<decltype(before)>(copy_->volume().voxels.get());
    const auto& dims = volume.grid.dims;
    forEachVoxel(cut_, [&](auto i, auto j, auto k) {
      const std::int64_t at = (k * dims[1] + j) * dims[0] + i;
      if (after[at] != before[at] && belongs(map, placeOf(volume.grid, i, j, k)))
        sum += partOf(double(before[at])) - partOf(double(after[at]));
    });
  });
  return sum * volume.grid.spacing.prod();
}

// A face between a voxel of the structure and one that is none counts as much of the surface as
// its axis is along the normal: over all faces, the squares of a unit vector's parts.
double CutStructures::exposedOf(const haptics::DistanceMap& map) const {
  const haptics::Grid& grid = before_->grid;
  haptics::VoxelBox box = all_;
  for (std::size_t a = 0; a < 3; ++a) {
    box.first[a] = std::max<std::int64_t>(0, box.first[a] - 1);
    box.end[a] = std::min(grid.dims[a] - 1, box.end[a]);  // there is a neighbour behind
  }
  const std::array<std::int64_t, 3> by{1, grid.dims[0], grid.dims[0] * grid.dims[1]};
  double sum = 0.0;
  visitVoxels(before_->type, before_->voxels.get(), [&](const auto* before) {
    const auto* after = static_cast<decltype(before)>(copy_->volume().voxels.get());
    const auto isBare = [&](std::int64_t at) {
      return double(before[at]) >= last_.isovalue && double(after[at]) < last_.isovalue;
    };
    forEachVoxel(box, [&](auto i, auto j, auto k) {
      const std::int64_t at = k * by[2] + j * by[1] + i;
      const Vec3 p_W = placeOf(grid, i, j, k);
      for (std::size_t a = 0; a < 3; ++a) {
        const bool bare = isBare(at), bare_behind = isBare(at + by[a]);
        if (!bare && !bare_behind) continue;
        const Vec3 axis = grid.direction.col(Eigen::Index(a));
        const double side = grid.spacing[Eigen::Index(a)];
        const bool is_of = belongs(map, p_W), is_behind = belongs(map, p_W + side * axis);
        if (is_of == is_behind || !(is_of ? bare_behind : bare)) continue;
        const Vec3 normal = map.gradientAt(p_W + 0.5 * side * axis).normalized();
        sum += grid.spacing.prod() / side * std::abs(normal.dot(axis));
      }
    });
  });
  return sum;
}

std::vector<CutStructures::Taken> CutStructures::taken() {
  endScene();
  if (before_ != nullptr && !isEmpty(all_))
    for (std::size_t n = 0; n < taken_.size(); ++n)
      taken_[n].exposed = exposedOf(watch_.structures[n].distances);
  return taken_;
}

}  // namespace app::report
