// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/carving/burr.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace haptics {
namespace {

// A trilinear field between voxels on the profile lies inside a ball by this over its radius, all
// in voxels; so the ball that is written is larger by it.
constexpr double kBias = 0.165;
// A voxel that counts by its distance to the wall counts a ball's outermost layer in part: what a
// sphere has there more than a plane is a 24th of its curvature twice.
constexpr double kCounted = kBias + 1.0 / 12.0;

/// The voxel that a value becomes. Rounding to the nearest, as edits do.
template <class T>
T asVoxel(double value) HAPTICS_RT {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    const double least = static_cast<double>(std::numeric_limits<T>::lowest());
    const double most = static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<T>(std::floor(std::clamp(value, least, most) + 0.5));
  }
}

}  // namespace

BurrCarving::BurrCarving(const Volume& volume, const BurrCut& cut) HAPTICS_RT
    : dims_{volume.grid.dims},
      type_{volume.type},
      spacing_{volume.grid.spacing},
      radius_{cut.radius},
      isovalue_{cut.isovalue},
      background_{volume.least},
      profile_{volume.least, volume.greatest, cut.isovalue} {
  a_ = volume.grid.indexOf(cut.from_W).cwiseProduct(spacing_);
  way_ = volume.grid.indexOf(cut.to_W).cwiseProduct(spacing_) - a_;
  way_square_ = way_.squaredNorm();
  const double least = spacing_.minCoeff(), most = spacing_.maxCoeff();
  reach_ = radius_ + (WallProfile::kReach + kBias * most / radius_) * most;
  per_value_ = 1.0 / profile_.slope();
  part_at_wall_ = 0.5 + kCounted * std::cbrt(spacing_.prod()) / radius_;
  // The distance rises by a voxel and no more from one to the next if voxels are cubes. If not, the
  // voxel's length along the normal turns with it.
  const double uneven = most * most / (least * least) - 1.0;
  const double grows = 1.0 + WallProfile::kReach * most / std::max(radius_ - most, least) * uneven;
  steepest_ = grows * profile_.steepest() + 1.0;  // and rounding
  const VoxelBox bounds = volume.bounds();
  rows_ = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto of = static_cast<std::size_t>(axis);
    const double low = std::min(a_[axis], a_[axis] + way_[axis]) - reach_;
    const double high = std::max(a_[axis], a_[axis] + way_[axis]) + reach_;
    const auto inGrid = [&](double at) {
      return static_cast<std::int64_t>(std::clamp(at, -1.0, static_cast<double>(dims_[of]) + 1.0));
    };
    box_.first[of] = std::max(bounds.first[of], inGrid(std::ceil(low / spacing_[axis])));
    box_.end[of] = std::min(bounds.end[of], inGrid(std::floor(high / spacing_[axis])) + 1);
    if (box_.end[of] <= box_.first[of]) rows_ = 0;
  }
  if (rows_ == 0)
    box_ = {};
  else
    rows_ = (box_.end[1] - box_.first[1]) * (box_.end[2] - box_.first[2]);
}

double BurrCarving::distanceAt(const Vec3& p) const HAPTICS_RT {
  Vec3 from = p - a_;
  if (way_square_ > 0.0) from -= std::clamp(from.dot(way_) / way_square_, 0.0, 1.0) * way_;
  const double square = from.squaredNorm();
  if (!(square > 0.0)) return -std::numeric_limits<double>::infinity();
  // the length of a voxel along the normal
  const double voxel = std::sqrt(from.cwiseProduct(spacing_).squaredNorm() / square);
  return (std::sqrt(square) - radius_) / voxel - kBias * voxel / radius_;
}

std::array<std::int64_t, 2> BurrCarving::nextRow() const HAPTICS_RT {
  const std::int64_t across = box_.end[1] - box_.first[1];
  return {box_.first[1] + next_ % across, box_.first[2] + next_ / across};
}

VoxelBox BurrCarving::changes(const void* voxels) const HAPTICS_RT {
  const auto [j, k] = nextRow();
  VoxelBox changed{{0, j, k}, {0, j + 1, k + 1}};
  // where along the row the reach can end: of the ball around the whole way
  const Vec3 middle = a_ + 0.5 * way_;
  const double across_j = static_cast<double>(j) * spacing_.y() - middle.y(),
               across_k = static_cast<double>(k) * spacing_.z() - middle.z(),
               around = reach_ + 0.5 * std::sqrt(way_square_);
  const double square = around * around - across_j * across_j - across_k * across_k;
  if (!(square > 0.0)) return changed;
  const double half = std::sqrt(square);
  const auto first = std::max(
      box_.first[0], static_cast<std::int64_t>(std::ceil((middle.x() - half) / spacing_.x())));
  const auto end = std::min(
      box_.end[0], static_cast<std::int64_t>(std::floor((middle.x() + half) / spacing_.x())) + 1);
  visitVoxels(type_, voxels, [&](const auto* typed) {
    using T = std::remove_cvref_t<decltype(*typed)>;
    const T* row = typed + (k * dims_[1] + j) * dims_[0];
    const T background = asVoxel<T>(background_);
    Vec3 p(0.0, static_cast<double>(j) * spacing_.y(), static_cast<double>(k) * spacing_.z());
    for (std::int64_t i = first; i < end; ++i) {
      if (!(row[i] > background)) continue;
      p.x() = static_cast<double>(i) * spacing_.x();
      if (!(asVoxel<T>(profile_.ceiling(distanceAt(p))) < row[i])) continue;
      if (changed.end[0] == 0) changed.first[0] = i;
      changed.end[0] = i + 1;
    }
  });
  return changed;
}

Removed BurrCarving::lower(void* voxels, const VoxelBox& changed) HAPTICS_RT {
  const auto [j, k] = nextRow();
  ++next_;
  Removed removed;
  visitVoxels(type_, voxels, [&](const auto* typed) {
    using T = std::remove_cvref_t<decltype(*typed)>;
    T* row = static_cast<T*>(voxels) + (k * dims_[1] + j) * dims_[0];
    const auto partOf = [&](T value) {
      return std::clamp(part_at_wall_ + (static_cast<double>(value) - isovalue_) * per_value_, 0.0,
                        1.0);
    };
    Vec3 p(0.0, static_cast<double>(j) * spacing_.y(), static_cast<double>(k) * spacing_.z());
    for (std::int64_t i = changed.first[0]; i < changed.end[0]; ++i) {
      p.x() = static_cast<double>(i) * spacing_.x();
      const T before = row[i], most = asVoxel<T>(profile_.ceiling(distanceAt(p)));
      if (!(most < before)) continue;
      row[i] = most;
      ++removed.voxels;
      removed.volume += partOf(before) - partOf(most);
    }
  });
  removed.volume *= spacing_.prod();
  return removed;
}

}  // namespace haptics
