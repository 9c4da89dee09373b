// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/max_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <type_traits>

namespace haptics {
namespace {

using BlockCounts = std::array<std::int64_t, 3>;

/// The next float at or above x, so that a rounded bound is still a bound.
float roundedUp(double x) {
  const auto f = static_cast<float>(x);
  return double{f} < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// Voxels, and the finest blocks over them.
template <class T>
struct Blocked {
  const T* voxels;
  const BlockCounts& dims;
  double background;
  const Vec3& spacing;
  const BlockCounts& blocks;
};

/// Greatest voxel and greatest edge difference of each finest block of the layer `bk`.
template <class T>
void scanBlocks(const Blocked<T>& volume, std::int64_t bk, lanes::BlockBound* out) {
  const auto& [voxels, dims, background, spacing, blocks] = volume;
  constexpr int n = 5;  // voxels along a side of a block of four cells
  // differences of 32-bit integers need more than 32 bits
  using Wide = double;
  const std::int64_t row = dims[0], slice = dims[0] * dims[1];
  for (std::int64_t bj = 0; bj < blocks[1]; ++bj)
    for (std::int64_t bi = 0; bi < blocks[0]; ++bi) {
      const std::int64_t i0 = 4 * bi - 1, j0 = 4 * bj - 1, k0 = 4 * bk - 1;
      const bool interior = i0 >= 0 && j0 >= 0 && k0 >= 0 && i0 + n <= dims[0] &&
                            j0 + n <= dims[1] && k0 + n <= dims[2];
      T v[n][n][n];
      bool same = true;
      if (interior) {
        const T* corner = voxels + k0 * slice + j0 * row + i0;
        for (int k = 0; k < n; ++k)
          for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) v[k][j][i] = corner[k * slice + j * row + i];
      } else {
        for (int k = 0; k < n; ++k)
          for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
              const std::int64_t x = i0 + i, y = j0 + j, z = k0 + k;
              const bool within =
                  x >= 0 && y >= 0 && z >= 0 && x < dims[0] && y < dims[1] && z < dims[2];
              v[k][j][i] = within ? voxels[z * slice + y * row + x] : static_cast<T>(background);
            }
      }
      T top = v[0][0][0];
      for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i) {
            top = std::max(top, v[k][j][i]);
            same = same && v[k][j][i] == v[0][0][0];
          }
      Wide dx = 0, dy = 0, dz = 0;
      if (!same) {
        for (int k = 0; k < n; ++k)
          for (int j = 0; j < n; ++j)
            for (int i = 0; i + 1 < n; ++i) {
              dx = std::max(dx, std::abs(Wide(v[k][j][i + 1]) - Wide(v[k][j][i])));
              dy = std::max(dy, std::abs(Wide(v[k][i + 1][j]) - Wide(v[k][i][j])));
              dz = std::max(dz, std::abs(Wide(v[i + 1][k][j]) - Wide(v[i][k][j])));
            }
      }
      const std::int64_t at = (bk * blocks[1] + bj) * blocks[0] + bi;
      out[at] = {roundedUp(double(top)), roundedUp(Vec3{dx, dy, dz}.cwiseQuotient(spacing).norm())};
    }
}

/// The same for the cubic spline: of the voxels that its cells are means of. In the ring the face
/// falls to the background, and the face is a mean of voxels too.
template <class T>
void scanSplineBlocks(const Blocked<T>& volume, std::int64_t bk, lanes::BlockBound* out) {
  const T* const voxels = volume.voxels;
  const BlockCounts& dims = volume.dims;
  const double background = volume.background;
  const std::int64_t stride[3] = {1, dims[0], dims[0] * dims[1]};
  for (std::int64_t bj = 0; bj < volume.blocks[1]; ++bj)
    for (std::int64_t bi = 0; bi < volume.blocks[0]; ++bi) {
      const std::int64_t b[3] = {bi, bj, bk};
      std::int64_t from[3], to[3];  // voxels in the grid, both inclusive
      for (std::size_t axis = 0; axis < 3; ++axis) {
        from[axis] = std::max<std::int64_t>(0, 4 * b[axis] - 2);
        to[axis] = std::min(dims[axis] - 1, 4 * b[axis] + 4);
      }
      const T origin = voxels[from[2] * stride[2] + from[1] * stride[1] + from[0]];
      T least = origin, top = origin;
      for (std::int64_t k = from[2]; k <= to[2]; ++k)
        for (std::int64_t j = from[1]; j <= to[1]; ++j) {
          const T* row = voxels + k * stride[2] + j * stride[1];
          for (std::int64_t i = from[0]; i <= to[0]; ++i) {
            least = std::min(least, row[i]);
            top = std::max(top, row[i]);
          }
        }
      Vec3 rise = Vec3::Zero();
      if (least != top)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::int64_t end[3] = {to[0], to[1], to[2]};
          --end[axis];
          double& steepest = rise[static_cast<int>(axis)];
          for (std::int64_t k = from[2]; k <= end[2]; ++k)
            for (std::int64_t j = from[1]; j <= end[1]; ++j) {
              const T* row = voxels + k * stride[2] + j * stride[1];
              for (std::int64_t i = from[0]; i <= end[0]; ++i)
                steepest =
                    std::max(steepest, std::abs(double(row[i + stride[axis]]) - double(row[i])));
            }
        }
      // in the ring a face falls to the background: of the voxels that a face is a mean of
      const auto fallFrom = [&](std::size_t axis, std::int64_t layer) {
        std::int64_t begin[3] = {from[0], from[1], from[2]}, end[3] = {to[0], to[1], to[2]};
        begin[axis] = std::max(from[axis], layer);
        end[axis] = std::min(to[axis], layer + 1);
        T highest = origin;
        bool any = false;
        for (std::int64_t k = begin[2]; k <= end[2]; ++k)
          for (std::int64_t j = begin[1]; j <= end[1]; ++j)
            for (std::int64_t i = begin[0]; i <= end[0]; ++i) {
              const T v = voxels[k * stride[2] + j * stride[1] + i];
              highest = any ? std::max(highest, v) : v;
              any = true;
            }
        double& steepest = rise[static_cast<int>(axis)];
        steepest = std::max(steepest, double(highest) - background);
      };
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (b[axis] == 0) fallFrom(axis, 0);
        if (4 * b[axis] + 2 >= dims[axis] - 1) fallFrom(axis, dims[axis] - 2);
      }
      const std::int64_t at = (bk * volume.blocks[1] + bj) * volume.blocks[0] + bi;
      out[at] = {roundedUp(double(top)), roundedUp(rise.cwiseQuotient(volume.spacing).norm())};
    }
}

float greater(float a, float b) { return std::max(a, b); }

lanes::BlockBound greater(const lanes::BlockBound& a, const lanes::BlockBound& b) {
  return {std::max(a.greatest, b.greatest), std::max(a.lipschitz, b.lipschitz)};
}

/// Makes every block the greatest of itself and its 26 neighbours; beyond the grid nothing counts.
/// In place: of a large volume the blocks alone are a gigabyte.
template <class Block>
void dilate(std::vector<Block>& values, const BlockCounts& blocks) {
  std::int64_t stride = 1;
  for (int axis = 0; axis < 3; stride *= blocks[axis], ++axis) {
    const std::int64_t n = blocks[axis];
    std::vector<Block> before(static_cast<std::size_t>(stride));  // the layer below, as it was
    for (Block* layer = values.data(); layer != values.data() + values.size();)
      for (std::int64_t b = 0; b < n; ++b, layer += stride)
        for (std::int64_t i = 0; i < stride; ++i) {
          const Block here = layer[i];
          if (b > 0) layer[i] = greater(layer[i], before[static_cast<std::size_t>(i)]);
          if (b + 1 < n) layer[i] = greater(layer[i], layer[i + stride]);
          before[static_cast<std::size_t>(i)] = here;
        }
  }
}

}  // namespace

MaxPyramid::MaxPyramid(const Volume& volume, FieldKind kind, const std::atomic<bool>* cancel)
    : dims_{volume.grid.dims}, smallest_spacing_{volume.grid.spacing.minCoeff()} {
  BlockCounts blocks;
  for (int axis = 0; axis < 3; ++axis) blocks[axis] = (dims_[axis] + 1 + kCells - 1) / kCells;
  finest_.resize(static_cast<std::size_t>(blocks[0] * blocks[1] * blocks[2]));
  const auto isCancelled = [cancel] { return cancel != nullptr && *cancel; };

  // every block layer is independent of the others
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    const std::int64_t workers =
        std::clamp<std::int64_t>(std::thread::hardware_concurrency(), 1, blocks[2]);
    std::vector<std::thread> threads;
    for (std::int64_t w = 0; w < workers; ++w)
      threads.emplace_back([&, w] {
        const auto scan = [&](auto&& scanned) {
          for (std::int64_t k = blocks[2] * w / workers; k < blocks[2] * (w + 1) / workers; ++k) {
            if (isCancelled()) return;
            scanned({voxels, dims_, volume.least, volume.grid.spacing, blocks}, k, finest_.data());
          }
        };
        using T = std::remove_cvref_t<decltype(*voxels)>;
        if (kind == FieldKind::CubicSpline)
          scan(scanSplineBlocks<T>);
        else
          scan(scanBlocks<T>);
      });
    for (std::thread& thread : threads) thread.join();
  });
  if (isCancelled()) return;

  // each coarser level from the one below it, before that is dilated
  std::vector<float> greatest;
  for (int l = 0; l < kLevels && !isCancelled(); ++l) {
    levels_[l].blocks = blocks;
    BlockCounts coarser;
    for (int axis = 0; axis < 3; ++axis) coarser[axis] = (blocks[axis] + 1) / 2;
    std::vector<float> next(static_cast<std::size_t>(coarser[0] * coarser[1] * coarser[2]),
                            -std::numeric_limits<float>::infinity());
    std::size_t at = 0;
    for (std::int64_t k = 0; k < blocks[2]; ++k)
      for (std::int64_t j = 0; j < blocks[1]; ++j)
        for (std::int64_t i = 0; i < blocks[0]; ++i, ++at) {
          float& top = next[((k / 2) * coarser[1] + j / 2) * coarser[0] + i / 2];
          top = std::max(top, l == 0 ? finest_[at].greatest : greatest[at]);
        }
    if (l == 0) {
      dilate(finest_, blocks);
    } else {
      dilate(greatest, blocks);
      levels_[l].greatest = std::move(greatest);
    }
    blocks = coarser;
    greatest = std::move(next);
  }
}

std::array<std::int64_t, 3> MaxPyramid::blockOf(const Vec3& u, int level) const HAPTICS_RT {
  std::array<std::int64_t, 3> b;
  for (int axis = 0; axis < 3; ++axis) {
    // a place beyond the grid is judged by the nearest block: nothing lies between
    const double cell = std::clamp(std::floor(u[axis]), -1.0, double(dims_[axis] - 1));
    b[axis] = (static_cast<std::int64_t>(cell) + 1) / (std::int64_t{kCells} << level);
  }
  return b;
}

MaxPyramid::Bound MaxPyramid::bound(const Vec3& u, double s) const HAPTICS_RT {
  // beyond the grid there is only background, as far as the grid is away
  double outside = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    outside = std::max({outside, -1.0 - u[axis], u[axis] - double(dims_[axis])});
  const std::array<std::int64_t, 3> finest = blockOf(u, 0);
  const lanes::BlockBound& block = finest_[static_cast<std::size_t>(levels_[0].at(finest))];
  if (block.greatest >= s) {
    if (outside >= double{kCells}) return {outside * smallest_spacing_, 0.0};
    // a plateau at or above s has no slope, but is not empty: 0 says that only of what is below
    const double slope = block.lipschitz;
    return {finestRadius(), std::max(slope, std::numeric_limits<double>::min())};
  }
  int level = 0;
  std::array<std::int64_t, 3> b = finest;
  while (level + 1 < kLevels) {
    for (std::int64_t& x : b) x /= 2;
    if (levels_[level + 1].greatest[levels_[level + 1].at(b)] >= s) break;
    ++level;
  }
  return {std::max(double(kCells << level), outside) * smallest_spacing_, 0.0};
}

double MaxPyramid::lipschitz(const Vec3& u) const HAPTICS_RT {
  return finest_[static_cast<std::size_t>(levels_[0].at(blockOf(u, 0)))].lipschitz;
}

std::size_t MaxPyramid::bytes() const {
  std::size_t floats = 2 * finest_.size();
  for (const Level& level : levels_) floats += level.greatest.size();
  return floats * sizeof(float);
}

}  // namespace haptics
