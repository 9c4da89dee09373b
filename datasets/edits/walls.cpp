// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/edits/walls.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

#include "datasets/edits/operators.h"
#include "datasets/edits/view.h"
#include "haptics/carving/wall.h"
#include "haptics/core/parallel.h"

namespace datasets {
namespace {

using haptics::Vec3;
using haptics::Volume;
using haptics::VoxelBox;
using haptics::VoxelRun;
using haptics::WallProfile;

constexpr std::int64_t kSlab = 4;    // slices that one thread does at a time
constexpr std::int32_t kApart = 32;  // voxels between two runs, at least
constexpr double kFar = std::numeric_limits<double>::infinity();

/// The box of samples between which a distance may be below `reach` [m].
VoxelBox nearSamples(const haptics::DistanceMap& map, double reach) {
  const auto& dims = map.grid.dims;
  const auto below = std::int32_t(std::ceil(reach / map.step));
  std::vector<VoxelBox> of_slice(static_cast<std::size_t>(dims[2]), {dims, {}});
  haptics::inParallel(dims[2], [&](std::int64_t k) {
    VoxelBox& box = of_slice[std::size_t(k)];
    const std::int16_t* row = map.samples.get() + k * dims[0] * dims[1];
    for (std::int64_t j = 0; j < dims[1]; ++j, row += dims[0]) {
      const auto isNear = [below](std::int16_t sample) { return sample < below; };
      const std::int16_t* const first = std::find_if(row, row + dims[0], isNear);
      if (first == row + dims[0]) continue;
      const std::int16_t* last = row + dims[0] - 1;
      while (!isNear(*last)) --last;
      box.first = {std::min(box.first[0], first - row), std::min(box.first[1], j), k};
      box.end = {std::max(box.end[0], last - row + 1), j + 1, k + 1};
    }
  });
  VoxelBox all{dims, {}};
  for (const VoxelBox& box : of_slice)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all.first[axis] = std::min(all.first[axis], box.first[axis]);
      all.end[axis] = std::max(all.end[axis], box.end[axis]);
    }
  // one sample more on each side: what is linear between two
  for (std::size_t axis = 0; axis < 3; ++axis) {
    all.first[axis] = std::max<std::int64_t>(0, all.first[axis] - 1);
    all.end[axis] = std::min(dims[axis], all.end[axis] + 1);
  }
  return all;
}

/// A structure's distances along the rows of a scan, in its longest voxel sides.
class RowDistances {
 public:
  RowDistances(const StructureWall& wall, const haptics::Grid& scan, double side)
      : map_{wall.distances},
        solid_{wall.solid},
        side_{side},
        origin_{map_.grid.indexOf(scan.worldOf(Vec3::Zero()))} {
    for (int axis = 0; axis < 3; ++axis)
      step_.col(axis) = map_.grid.indexOf(scan.worldOf(Vec3::Unit(axis))) - origin_;
    const VoxelBox near = nearSamples(map_, WallProfile::kReach * side);
    const haptics::Mat3 to_scan = step_.inverse();
    Vec3 least = Vec3::Constant(kFar), most = -least;
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 at;
      for (int axis = 0; axis < 3; ++axis) {
        const auto of = std::size_t(axis);
        at[axis] = double((corner >> axis & 1) != 0 ? near.end[of] - 1 : near.first[of]);
      }
      const Vec3 there = to_scan * (at - origin_);
      least = least.cwiseMin(there);
      most = most.cwiseMax(there);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto of = std::size_t(axis);
      box_.first[of] =
          std::clamp(std::int64_t(std::floor(least[axis])), std::int64_t{0}, scan.dims[of]);
      box_.end[of] =
          std::clamp(std::int64_t(std::ceil(most[axis])) + 1, box_.first[of], scan.dims[of]);
    }
  }
  bool isSolid() const { return solid_; }
  const VoxelBox& box() const { return box_; }

  /// Lowers what stands in a row to the distances of its voxels.
  void lessen(std::int64_t j, std::int64_t k, std::vector<double>& row) const {
    if (j < box_.first[1] || j >= box_.end[1] || k < box_.first[2] || k >= box_.end[2]) return;
    const Vec3 begin = origin_ + step_ * Vec3(0.0, double(j), double(k));
    for (std::int64_t i = box_.first[0]; i < box_.end[0]; ++i) {
      double& least = row[std::size_t(i)];
      least = std::min(least, map_.atIndex(begin + double(i) * step_.col(0)) / side_);
    }
  }

 private:
  const haptics::DistanceMap& map_;
  bool solid_;
  double side_;
  Vec3 origin_;
  haptics::Mat3 step_;
  VoxelBox box_;
};

VoxelBox around(const std::vector<RowDistances>& walls, const haptics::Grid& grid) {
  VoxelBox all{grid.dims, {}};
  for (const RowDistances& wall : walls)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all.first[axis] = std::min(all.first[axis], wall.box().first[axis]);
      all.end[axis] = std::max(all.end[axis], wall.box().end[axis]);
    }
  return all;
}

template <class T>
T nearestOf(double value) {
  return std::is_floating_point_v<T> ? static_cast<T>(value) : static_cast<T>(std::lround(value));
}

/// Writes the walls into `written`, which has the volume's values, and lists the runs that changed.
/// None if it was cancelled.
std::optional<std::vector<VoxelRun>> writeWalls(const Volume& volume,
                                                const std::vector<RowDistances>& walls,
                                                double isovalue, void* written,
                                                const std::atomic<bool>* cancel) {
  const WallProfile profile{volume.least, volume.greatest, isovalue};
  const VoxelBox box = around(walls, volume.grid);
  const auto& dims = volume.grid.dims;
  const std::int64_t slabs =
      std::max<std::int64_t>(0, box.end[2] - box.first[2] + kSlab - 1) / kSlab;
  std::vector<std::vector<VoxelRun>> parts(static_cast<std::size_t>(slabs));
  haptics::inParallel(slabs, [&](std::int64_t n) {
    const auto length = static_cast<std::size_t>(dims[0]);
    std::vector<double> gone(length), solid(length);
    std::vector<VoxelRun>& runs = parts[std::size_t(n)];
    const std::int64_t first = box.first[2] + n * kSlab;
    for (std::int64_t k = first; k < std::min(first + kSlab, box.end[2]); ++k) {
      if (cancel != nullptr && *cancel) return;
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) {
        std::fill(gone.begin() + box.first[0], gone.begin() + box.end[0], kFar);
        std::fill(solid.begin() + box.first[0], solid.begin() + box.end[0], kFar);
        for (const RowDistances& wall : walls) wall.lessen(j, k, wall.isSolid() ? solid : gone);
        haptics::visitVoxels(volume.type, volume.voxels.get(), [&](const auto* values) {
          using T = std::remove_cvref_t<decltype(*values)>;
          const std::int64_t row = (k * dims[1] + j) * dims[0];
          bool open = false;  // whether the last run is of this row
          for (std::int64_t i = box.first[0]; i < box.end[0]; ++i) {
            const double away = gone[std::size_t(i)], near = solid[std::size_t(i)];
            if (std::min(away, near) >= WallProfile::kReach) continue;
            const T before = values[row + i];
            T value = before;
            if (away < WallProfile::kReach)
              value =
                  std::min(value, nearestOf<T>(std::min(profile.ceiling(away), volume.greatest)));
            if (near < WallProfile::kReach)
              value = std::max(value, nearestOf<T>(profile.floor(near)));
            if (value == before) continue;
            static_cast<T*>(written)[row + i] = value;
            const auto at = std::int32_t(i);
            if (open && at - (runs.back().i + runs.back().count) < kApart) {
              runs.back().count = at + 1 - runs.back().i;
            } else {
              runs.push_back({at, std::int32_t(j), std::int32_t(k), 1});
              open = true;
            }
          }
        });
      }
    }
  });
  if (cancel != nullptr && *cancel) return {};
  std::vector<VoxelRun> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// The blocks of a volume that differ from its scan.
TouchedBlocks touchedIn(const Volume& volume, const Volume& scan) {
  TouchedBlocks touched{scan};
  if (volume.voxels == scan.voxels) return touched;
  const auto* then = static_cast<const std::byte*>(scan.voxels.get());
  const auto* now = static_cast<const std::byte*>(volume.voxels.get());
  for (std::size_t block = 0; block < touched.blocks(); ++block) {
    const std::size_t begin = touched.begin(block), end = touched.end(block);
    if (std::memcmp(then + begin, now + begin, end - begin) != 0) touched.add(begin, end);
  }
  return touched;
}

/// Adds boxes that hold what differs between a new volume, whose own is in `made`, and the previous
/// one; false: they are not known.
bool addDifference(const Walled& made, const std::shared_ptr<const Volume>& previous,
                   std::vector<VoxelBox>& boxes) {
  boxes = made.written;
  const auto add = [&](const std::vector<VoxelBox>& more) {
    boxes.insert(boxes.end(), more.begin(), more.end());
  };
  if (const Walled* before = walledOf(*previous)) add(before->written);
  const auto seen = seenOf(previous);
  if (seen == made.seen) return true;
  const haptics::Derivation* edit = haptics::derivationBetween(made.seen, seen);
  if (edit != nullptr) add(edit->changed);
  return edit != nullptr;
}

haptics::Expected<std::shared_ptr<const Volume>> walledWith(
    const std::shared_ptr<const Volume>& seen, std::span<const StructureWall> walls,
    double isovalue, const std::shared_ptr<const Volume>& previous,
    const std::atomic<bool>* cancel) {
  const std::shared_ptr<const Volume> scan = seen->derivation ? seen->derivation->scan : seen;
  TouchedBlocks touched = touchedIn(*seen, *scan);
  auto view = viewOf(*scan, seen->voxels.get(), touched);
  if (!view) return tl::unexpected(view.error());
  std::vector<RowDistances> rows;
  for (const StructureWall& wall : walls)
    rows.emplace_back(wall, seen->grid, seen->grid.spacing.maxCoeff());
  const auto runs = writeWalls(*seen, rows, isovalue, view->get(), cancel);
  if (!runs) return tl::unexpected(editCancelled());
  if (runs->empty()) return seen;
  ChangedBoxes changed{seen->grid};
  changed.add(*runs);
  for (const VoxelRun& run : *runs) {
    const RunBytes bytes = bytesOfRun(*seen, run);
    touched.add(bytes.first, bytes.first + bytes.count);
  }
  auto made = std::make_shared<Walled>();
  if (const Edited* edited = editedOf(*seen)) {
    made->edits = edited->edits;
    made->digest = edited->digest;
  }
  made->scan = scan;
  made->seen = seen;
  for (const StructureWall& wall : walls) made->walls.push_back({wall.structure, wall.solid});
  made->isovalue = isovalue;
  made->digest_of_walls = digestOf(digestOfVoxels(*scan, view->get(), touched), seen->bounds());
  made->written = changed.boxes();
  made->bytes = touched.touched() * TouchedBlocks::kBytes;
  made->neighbour = seen;
  made->changed = made->written;
  std::vector<VoxelBox> between;
  if (previous && previous != seen && addDifference(*made, previous, between)) {
    made->neighbour = previous;
    made->changed = std::move(between);
  }
  Volume volume = *seen;
  volume.voxels = std::move(*view);
  volume.derivation = std::move(made);
  return std::make_shared<const Volume>(std::move(volume));
}

}  // namespace

std::shared_ptr<const Volume> seenOf(std::shared_ptr<const Volume> volume) {
  const Walled* made = volume ? walledOf(*volume) : nullptr;
  return made != nullptr ? made->seen : volume;
}

haptics::Expected<std::shared_ptr<const Volume>> walled(
    std::shared_ptr<const Volume> volume, std::span<const StructureWall> walls, double isovalue,
    const std::shared_ptr<const Volume>& previous, const std::atomic<bool>* cancel) {
  volume = seenOf(std::move(volume));
  if (walls.empty()) return volume;
  try {
    return walledWith(volume, walls, isovalue, previous, cancel);
  } catch (const std::bad_alloc&) {
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Unsupported, {"walls-memory", {}}, "too-large"});
  }
}

}  // namespace datasets
