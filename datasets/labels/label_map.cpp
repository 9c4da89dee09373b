// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/label_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>

#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Expected;
using haptics::Mat3;
using haptics::Vec3;

namespace {

/// Whether the nearest voxel of an index is one of the grid's.
bool contains(const haptics::Grid& grid, const Vec3& index) {
  const Vec3 size(double(grid.dims[0]), double(grid.dims[1]), double(grid.dims[2]));
  const Vec3 nearest = index.array().round();
  return (nearest.array() >= 0.0).all() && (nearest.array() < size.array()).all();
}

}  // namespace

std::array<double, 3> colourFarFromOthers(std::size_t number) {
  constexpr double kGolden = 0.618033988749895, kPale = 0.35, kBright = 0.95;
  const double hue = 6.0 * std::fmod(0.02 + kGolden * double(number), 1.0);
  const auto channel = [&](double of) {
    const double away = std::abs(std::remainder(hue - of, 6.0));
    return kBright * (kPale + (1.0 - kPale) * std::clamp(2.0 - away, 0.0, 1.0));
  };
  return {channel(0.0), channel(2.0), channel(4.0)};
}

Expected<LabelMap> LabelMap::over(const haptics::Grid& scan) {
  if (auto room = checkRoom(scan.voxelCount(), 1); !room) return tl::unexpected(room.error());
  LabelMap map;
  map.grid_ = scan;
  map.codes_.reset(new (std::nothrow) std::uint8_t[std::size_t(scan.voxelCount())]{});
  if (!map.codes_) return unsupported("too-large", {"labels-no-memory", {}});
  return map;
}

std::uint8_t LabelMap::add(Structure structure) {
  structure.voxels = 0;
  structures_.push_back(std::move(structure));
  return std::uint8_t(structures_.size() - 1);
}

/// The code of a set with one structure more.
Expected<std::uint8_t> LabelMap::with(std::uint8_t code, std::uint8_t number) {
  std::vector<std::uint8_t> set = sets_[code];
  if (const auto at = std::ranges::lower_bound(set, number); at == set.end() || *at != number)
    set.insert(at, number);
  auto found = std::ranges::find(sets_, set);
  if (found == sets_.end()) {
    if (sets_.size() == 256) return unsupported("labels-too-many", {"labels-overlap-too-much", {}});
    found = sets_.insert(sets_.end(), std::move(set));
  }
  return std::uint8_t(found - sets_.begin());
}

Expected<void> LabelMap::mark(std::int64_t voxel, std::uint8_t number) {
  std::uint8_t& code = codes_[std::size_t(voxel)];
  std::int16_t& joined = joined_[std::size_t(256 * code + number)];
  if (joined < 0) {
    const auto made = with(code, number);
    if (!made) return tl::unexpected(made.error());
    joined = *made;
  }
  if (joined != code) ++structures_[number].voxels;
  code = std::uint8_t(joined);
  return {};
}

void LabelMap::count(const Vec3& centre_W, std::uint8_t number) {
  ++structures_[number].marked;
  if (!contains(grid_, grid_.indexOf(centre_W))) ++structures_[number].outside;
}

haptics::VoxelBox LabelMap::boxAround(std::span<const Vec3> places_W) const {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p_W : places_W) {
    const Vec3 index = grid_.indexOf(p_W);
    low = low.cwiseMin(index);
    high = high.cwiseMax(index);
  }
  haptics::VoxelBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto count = double(grid_.dims[a]);
    const auto axis = Eigen::Index(a);
    box.first[a] = std::int64_t(std::clamp(std::floor(low[axis]), 0.0, count));
    box.end[a] = std::int64_t(std::clamp(std::ceil(high[axis]) + 1.0, 0.0, count));
  }
  return box;
}

Expected<void> LabelMap::add(const haptics::Volume& labels,
                             const std::map<std::int64_t, std::uint8_t>& numbers,
                             const ReadProgress& progress) {
  const haptics::Grid& from = labels.grid;
  // an index of the scan as one of the labels
  const Mat3 turn = from.spacing.cwiseInverse().asDiagonal() * from.direction.transpose() *
                    grid_.direction * grid_.spacing.asDiagonal();
  const Vec3 origin = from.indexOf(grid_.origin);
  const Vec3 size(double(from.dims[0]), double(from.dims[1]), double(from.dims[2]));
  std::vector<Vec3> corners;
  for (const double i : {0.0, 1.0})
    for (const double j : {0.0, 1.0})
      for (const double k : {0.0, 1.0})
        corners.push_back(from.worldOf(size.cwiseProduct(Vec3{i, j, k}) - Vec3::Constant(0.5)));
  const haptics::VoxelBox box = boxAround(corners);
  bool reaches_beyond = false;
  for (const Vec3& corner_W : corners) {
    // of the voxel in the corner, the centre
    const Vec3 at = grid_.indexOf(
        from.worldOf(from.indexOf(corner_W).cwiseMax(0.0).cwiseMin(size - Vec3::Ones())));
    reaches_beyond = reaches_beyond || !contains(grid_, at);
  }
  return haptics::visitVoxels(
      labels.type, labels.voxels.get(), [&](const auto* voxels) -> Expected<void> {
        std::optional<std::int64_t> last_label;
        const std::uint8_t* last_number = nullptr;
        const auto numberOf = [&](auto voxel) {
          if (const auto label = std::int64_t(voxel); label != last_label) {
            const auto known = numbers.find(label);
            last_label = label;
            last_number = known == numbers.end() ? nullptr : &known->second;
          }
          return last_number;
        };
        for (std::int64_t k = box.first[2]; k < box.end[2]; ++k) {
          progress.advanced(double(k - box.first[2]) / double(box.end[2] - box.first[2]));
          if (progress.isCancelled()) return cancelled();
          for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) {
            const Vec3 row = origin + turn * Vec3{0.0, double(j), double(k)};
            for (std::int64_t i = box.first[0]; i < box.end[0]; ++i) {
              const Vec3 at = (row + turn.col(0) * double(i)).array().round();
              if ((at.array() < 0.0).any() || (at.array() >= size.array()).any()) continue;
              const std::uint8_t* number =
                  numberOf(voxels[(std::int64_t(at.z()) * from.dims[1] + std::int64_t(at.y())) *
                                      from.dims[0] +
                                  std::int64_t(at.x())]);
              if (number == nullptr) continue;
              if (auto marked = mark((k * grid_.dims[1] + j) * grid_.dims[0] + i, *number); !marked)
                return marked;
            }
          }
        }
        if (!reaches_beyond) return {};
        const auto* label = voxels;
        for (std::int64_t k = 0; k < from.dims[2]; ++k) {
          if (progress.isCancelled()) return cancelled();
          for (std::int64_t j = 0; j < from.dims[1]; ++j)
            for (std::int64_t i = 0; i < from.dims[0]; ++i, ++label) {
              if (const std::uint8_t* number = numberOf(*label))
                count(from.worldOf({double(i), double(j), double(k)}), *number);
            }
        }
        return {};
      });
}

}  // namespace datasets
