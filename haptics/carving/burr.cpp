// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/carving/burr.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

namespace haptics {
namespace {

// A trilinear field between voxels on the profile lies inside a ball by this over its radius, all
// in voxels; so the ball that is written is larger by it.
constexpr double kBias = 0.165;
// A voxel that counts by its distance to the wall counts a ball's outermost layer in part. What a
// sphere has there more than a plane is the mean square of that distance, of a box of one voxel and
// another of kRounded, over its radius.
constexpr double kCounted = kBias + (1.0 + PartOfVoxel::kRounded * PartOfVoxel::kRounded) / 12.0;

/// Leaves voxels of a chunk, from one to another, as they were.
template <class Real>
void restore(lanes::RowOfVoxels<Real>& voxels, std::int64_t first, std::int64_t end) HAPTICS_RT {
  for (std::int64_t n = std::max<std::int64_t>(first, 0);
       n < std::min<std::int64_t>(end, lanes::kRowChunk); ++n) {
    if (voxels.after[n] == voxels.before[n]) continue;
    voxels.after[n] = voxels.before[n];
    voxels.parts &= ~(std::uint64_t{1} << n);
    --voxels.changed;
  }
}

}  // namespace

bool isPossible(const BurrCut& cut) {
  constexpr double kFarthest = 1e4;       // m: as far as any scan lies
  constexpr double kMostIsovalue = 1e38;  // a float
  // false for what is no number, too
  return cut.from_W.norm() < kFarthest && cut.to_W.norm() < kFarthest &&
         cut.radius >= kSmallestBurr && cut.radius < kLargestBurr &&
         (cut.to_W - cut.from_W).norm() < cut.radius && std::abs(cut.isovalue) <= kMostIsovalue;
}

PartOfVoxel::PartOfVoxel(const Volume& volume, const BurrCut& cut) HAPTICS_RT
    : isovalue{cut.isovalue},
      per_value{1.0 / WallProfile{volume.least, volume.greatest, cut.isovalue}.slope()},
      at_wall{kCounted * std::cbrt(volume.grid.spacing.prod()) / cut.radius} {}

BurrCarving::BurrCarving(const Volume& volume, const BurrCut& cut) HAPTICS_RT
    : dims_{volume.grid.dims},
      type_{volume.type},
      tissues_{volume.tissues.get()},
      spacing_{volume.grid.spacing},
      radius_{cut.radius},
      isovalue_{cut.isovalue},
      background_{volume.least} {
  a_ = volume.grid.indexOf(cut.from_W).cwiseProduct(spacing_);
  way_ = volume.grid.indexOf(cut.to_W).cwiseProduct(spacing_) - a_;
  middle_ = a_ + 0.5 * way_;
  const double least = spacing_.minCoeff(), most = spacing_.maxCoeff();
  reach_ = radius_ + (WallProfile::kReach + kBias * most / radius_) * most;
  const double around = reach_ + 0.5 * way_.norm();
  around_square_ = around * around;
  const WallProfile profile{volume.least, volume.greatest, cut.isovalue};
  // The distance rises by a voxel and no more from one to the next if voxels are cubes. If not, the
  // voxel's length along the normal turns with it.
  const double uneven = most * most / (least * least) - 1.0;
  const double grows = 1.0 + WallProfile::kReach * most / std::max(radius_ - most, least) * uneven;
  const double rounding = type_ == ScalarType::Float32 ? 1e-3 * profile.steepest() : 1.0;
  steepest_ = grows * profile.steepest() + rounding;
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
  // beside a voxel that is kept, one may be lowered to the background
  if (tissues_ != nullptr && rows_ > 0 && tissues_->mayKeep(box_))
    steepest_ = std::max(steepest_, volume.greatest - volume.least);
  // 32 bits of a whole number are more than a float has
  if (type_ == ScalarType::UInt32 || type_ == ScalarType::Int32)
    in_double_ = ball<double>(profile, {volume, cut});
  else
    in_float_ = ball<float>(profile, {volume, cut});
}

template <class Real>
lanes::BallAtRow<Real> BurrCarving::ball(const WallProfile& profile,
                                         const PartOfVoxel& part) const HAPTICS_RT {
  const auto real = [](double value) { return static_cast<Real>(value); };
  const double square = way_.squaredNorm();
  return {.x = 0,
          .y = 0,
          .z = 0,
          .spacing = {real(spacing_.x()), real(spacing_.y()), real(spacing_.z())},
          .cubes = spacing_.minCoeff() == spacing_.maxCoeff(),
          .way = {real(way_.x()), real(way_.y()), real(way_.z())},
          .per_way = real(square > 0.0 ? 1.0 / square : 0.0),
          .radius = real(radius_),
          .bias = real(kBias / radius_),
          .isovalue = real(isovalue_),
          .slope = real(profile.slope()),
          .rise = real(profile.rise()),
          .straight = real(WallProfile::kStraight),
          .background = real(background_),
          .back = real(-profile.back()),
          .whole = type_ != ScalarType::Float32,
          .per_value = real(part.per_value),
          .at_wall = real(part.at_wall),
          .part_straight = real(PartOfVoxel::kStraight),
          .part_rounded = real(PartOfVoxel::kRounded)};
}

template <class T>
Removed BurrCarving::lowerTyped(T* row, const T* scan, double y, double z,
                                std::span<const Tissues::Run> runs,
                                const Material& material) const HAPTICS_RT {
  Removed removed;
  const double dy = y - middle_.y(), dz = z - middle_.z();
  const double square = around_square_ - dy * dy - dz * dz;
  if (!(square > 0.0)) return removed;
  const double half = std::sqrt(square);
  const auto first =
      std::max(box_.first[0], static_cast<std::int64_t>((middle_.x() - half) / spacing_.x()));
  const auto end =
      std::min(box_.end[0], static_cast<std::int64_t>((middle_.x() + half) / spacing_.x()) + 1);
  const auto lower = [&](auto ball, auto real) {
    using Real = decltype(real);
    lanes::RowOfVoxels<Real> voxels;
    // from the way's beginning, so that floats are of small numbers
    ball.y = static_cast<Real>(y - a_.y());
    ball.z = static_cast<Real>(z - a_.z());
    for (std::int64_t i = first; i < end; i += lanes::kRowChunk) {
      const int count = static_cast<int>(std::min<std::int64_t>(lanes::kRowChunk, end - i));
      T* const v = row + i;
      std::transform(v, v + count, voxels.before, [](T value) { return static_cast<Real>(value); });
      std::fill(voxels.before + count, voxels.before + ((count + 15) & ~15), ball.background);
      ball.x = static_cast<Real>(static_cast<double>(i) * spacing_.x() - a_.x());
      lanes::lower(ball, count, voxels);
      if (voxels.changed == 0) continue;
      while (!runs.empty() && runs.front().end <= i) runs = runs.subspan(1);
      for (const Tissues::Run& run : runs) {
        if (run.first >= i + count) break;
        if (!run.mayBeCut()) restore(voxels, run.first - i, std::min(run.end - i, end - i));
      }
      if (voxels.changed == 0) continue;
      removed.voxels += voxels.changed;
      std::transform(voxels.after, voxels.after + count, v,
                     [](Real value) { return static_cast<T>(value); });
      for (std::uint64_t parts = voxels.parts; parts != 0; parts &= parts - 1) {
        const int n = std::countr_zero(parts);
        const double part = static_cast<double>(voxels.part[n]);
        removed.volume += part;
        while (!runs.empty() && runs.front().end <= i + n) runs = runs.subspan(1);
        const bool is_known = !runs.empty() && runs.front().first <= i + n;
        removed.energy += part * (is_known ? static_cast<double>(runs.front().energy)
                                           : material.energyAt(static_cast<double>(scan[i + n])));
      }
    }
  };
  if constexpr (std::is_integral_v<T> && sizeof(T) == 4)
    lower(in_double_, 0.0);
  else
    lower(in_float_, 0.0F);
  return removed;
}

Removed BurrCarving::lowerAll(void* voxels, const void* scan) {
  Removed removed;
  while (!isDone()) removed.add(lowerRow(voxels, scan, Material{}));
  return removed;
}

Removed BurrCarving::lowerRow(void* voxels, const void* scan, const Material& material) HAPTICS_RT {
  const std::int64_t across = box_.end[1] - box_.first[1];
  const std::int64_t j = box_.first[1] + next_ % across, k = box_.first[2] + next_ / across;
  ++next_;
  const std::int64_t at = (k * dims_[1] + j) * dims_[0];
  Removed removed = visitVoxels(type_, scan, [&](const auto* typed) {
    using T = std::remove_cvref_t<decltype(*typed)>;
    return lowerTyped(static_cast<T*>(voxels) + at, typed + at,
                      static_cast<double>(j) * spacing_.y(), static_cast<double>(k) * spacing_.z(),
                      tissues_ != nullptr ? tissues_->row(j, k) : std::span<const Tissues::Run>{},
                      material);
  });
  const double voxel = spacing_.prod();
  removed.volume *= voxel;
  removed.energy *= voxel;
  return removed;
}

}  // namespace haptics
