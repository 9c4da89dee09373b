// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/max_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "haptics/core/parallel.h"

namespace haptics {
namespace {

using BlockCounts = std::array<std::int64_t, 3>;

/// The next float at or above x, so that a rounded bound is still a bound.
float roundedUp(double x) {
  const auto f = static_cast<float>(x);
  return double{f} < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// A box of blocks, as VoxelBox is one of voxels.
using BlockBox = VoxelBox;

/// Calls f(bi, bj, bk) for the blocks of a box, bi fastest.
template <class F>
void forBlocks(const BlockBox& box, F&& f) {
  for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
    for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
      for (std::int64_t i = box.first[0]; i < box.end[0]; ++i) f(i, j, k);
}

/// Voxels, and the box of them that exists.
template <class T>
struct Blocked {
  const T* voxels;
  const BlockCounts& dims;
  const VoxelBox& box;
  double background;
  const Vec3& spacing;
};

/// Greatest value and greatest edge differences of n^3 voxels, i fastest.
template <int n, class T>
lanes::BlockBound boundOf(const std::array<T, n * n * n>& v, const Vec3& spacing) {
  // differences of 32-bit integers need more than 32 bits
  using Wide = std::conditional_t<sizeof(T) <= 2, int, double>;
  const auto rise = [](Wide most, T a, T b) {
    const Wide d = Wide(a) - Wide(b);
    return std::max(most, d < 0 ? -d : d);
  };
  T top = v[0], least = v[0];
  for (const T x : v) {
    top = std::max(top, x);
    least = std::min(least, x);
  }
  Wide dx = 0, dy = 0, dz = 0;
  if (least != top) {
    for (int at = 0; at + n * n < n * n * n; ++at) dz = rise(dz, v[at + n * n], v[at]);
    for (int k = 0; k < n; ++k)
      for (int at = k * n * n; at < (k + 1) * n * n - n; ++at) dy = rise(dy, v[at + n], v[at]);
    for (int row = 0; row < n * n; ++row)
      for (int at = row * n; at < row * n + n - 1; ++at) dx = rise(dx, v[at + 1], v[at]);
  }
  return {roundedUp(double(top)),
          roundedUp(Vec3{double(dx), double(dy), double(dz)}.cwiseQuotient(spacing).norm())};
}

/// Copies n^3 voxels from `corner` on.
template <int n, class T>
void copyVoxels(const T* corner, const BlockCounts& dims, std::array<T, n * n * n>& v) {
  T* out = v.data();
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j, out += n) {
      const T* row = corner + (k * dims[1] + j) * dims[0];
      for (int i = 0; i < n; ++i) out[i] = row[i];
    }
}

/// Whether n^3 voxels from (i, j, k) on are all in the box.
bool allIn(const VoxelBox& box, std::int64_t i, std::int64_t j, std::int64_t k, int n) {
  return i >= box.first[0] && j >= box.first[1] && k >= box.first[2] && i + n <= box.end[0] &&
         j + n <= box.end[1] && k + n <= box.end[2];
}

/// Bounds of blocks that lie side by side along i, each of n^3 voxels, from voxels that all exist.
template <int n, class T>
class RowBounds {
 public:
  /// `corner` is the first voxel of the first of `count` blocks.
  void find(const T* corner, std::int64_t count, const BlockCounts& dims, const Vec3& spacing,
            lanes::BlockBound* out) {
    const std::size_t length = static_cast<std::size_t>(4 * (count - 1) + n);
    top_.assign(corner, corner + length);
    for (std::vector<Rise>* rises : {&dx_, &dy_, &dz_}) rises->assign(length, Rise{});
    const std::int64_t row = dims[0], slice = dims[0] * dims[1];
    for (std::int64_t k = 0; k < n; ++k)
      for (std::int64_t j = 0; j < n; ++j) {
        const T* const v = corner + k * slice + j * row;
        for (std::size_t i = 0; i < length; ++i) top_[i] = std::max(top_[i], v[i]);
        extend(dx_, v + 1, v, length - 1);
        if (j + 1 < n) extend(dy_, v + row, v, length);
        if (k + 1 < n) extend(dz_, v + slice, v, length);
      }
    for (std::int64_t b = 0; b < count; ++b) {
      const auto greatest = [b](const auto& values, std::ptrdiff_t among) {
        return static_cast<double>(
            *std::max_element(values.begin() + 4 * b, values.begin() + 4 * b + among));
      };
      const Vec3 rise{greatest(dx_, n - 1), greatest(dy_, n), greatest(dz_, n)};
      out[b] = {roundedUp(greatest(top_, n)), roundedUp(rise.cwiseQuotient(spacing).norm())};
    }
  }

 private:
  // differences of 8 and 16 bits are whole numbers that fit; those of 32 need more
  static constexpr bool kNarrow = std::is_integral_v<T> && sizeof(T) <= 2;
  using Rise =
      typename std::conditional_t<kNarrow, std::make_unsigned<T>, std::type_identity<double>>::type;

  static Rise riseOf(T a, T b) {
    if constexpr (kNarrow)
      return static_cast<Rise>(std::max(a, b) - std::min(a, b));
    else
      return std::abs(static_cast<double>(a) - static_cast<double>(b));
  }
  static void extend(std::vector<Rise>& most, const T* a, const T* b, std::size_t length) {
    for (std::size_t i = 0; i < length; ++i) most[i] = std::max(most[i], riseOf(a[i], b[i]));
  }

  std::vector<T> top_;
  std::vector<Rise> dx_, dy_, dz_;
};

/// Greatest voxel and greatest edge difference of the finest block (bi, bj, bk).
template <class T>
lanes::BlockBound cellBound(const Blocked<T>& volume, std::int64_t bi, std::int64_t bj,
                            std::int64_t bk) {
  const auto& [voxels, dims, box, background, spacing] = volume;
  constexpr int n = 5;  // voxels along a side of a block of four cells
  const std::int64_t row = dims[0], slice = dims[0] * dims[1];
  const std::int64_t i0 = 4 * bi - 1, j0 = 4 * bj - 1, k0 = 4 * bk - 1;
  if (i0 + n <= box.first[0] || j0 + n <= box.first[1] || k0 + n <= box.first[2] ||
      i0 >= box.end[0] || j0 >= box.end[1] || k0 >= box.end[2])
    return {roundedUp(background), 0.0F};
  std::array<T, n * n * n> v;
  if (allIn(box, i0, j0, k0, n)) {
    copyVoxels<n>(voxels + k0 * slice + j0 * row + i0, dims, v);
    return boundOf<n>(v, spacing);
  }
  std::size_t at = 0;
  for (std::int64_t z = k0; z < k0 + n; ++z)
    for (std::int64_t y = j0; y < j0 + n; ++y)
      for (std::int64_t x = i0; x < i0 + n; ++x, ++at) {
        const bool within = x >= box.first[0] && y >= box.first[1] && z >= box.first[2] &&
                            x < box.end[0] && y < box.end[1] && z < box.end[2];
        v[at] = within ? voxels[z * slice + y * row + x] : static_cast<T>(background);
      }
  return boundOf<n>(v, spacing);
}

/// The same for the cubic spline: of the voxels that its cells are means of. In the ring the face
/// falls to the background, and the face is a mean of voxels too.
template <class T>
lanes::BlockBound splineBound(const Blocked<T>& volume, std::int64_t bi, std::int64_t bj,
                              std::int64_t bk) {
  const T* const voxels = volume.voxels;
  const BlockCounts& dims = volume.dims;
  const VoxelBox& box = volume.box;
  const double background = volume.background;
  const std::int64_t stride[3] = {1, dims[0], dims[0] * dims[1]};
  const std::int64_t b[3] = {bi, bj, bk};
  constexpr int n = 7;  // voxels along a side of what a block of four cells is a mean of
  if (allIn(box, 4 * bi - 2, 4 * bj - 2, 4 * bk - 2, n)) {
    std::array<T, n * n * n> v;
    copyVoxels<n>(voxels + (4 * bk - 2) * stride[2] + (4 * bj - 2) * stride[1] + 4 * bi - 2, dims,
                  v);
    return boundOf<n>(v, volume.spacing);
  }
  std::int64_t from[3], to[3];  // voxels in the box, both inclusive
  for (std::size_t axis = 0; axis < 3; ++axis) {
    from[axis] = std::max(box.first[axis], 4 * b[axis] - 2);
    to[axis] = std::min(box.end[axis] - 1, 4 * b[axis] + 4);
    if (from[axis] > to[axis]) return {roundedUp(background), 0.0F};
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
            steepest = std::max(steepest, std::abs(double(row[i + stride[axis]]) - double(row[i])));
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
    // the cells first - 1 and end - 1 are the ring
    if (b[axis] == box.first[axis] / 4) fallFrom(axis, box.first[axis]);
    if (b[axis] == box.end[axis] / 4) fallFrom(axis, box.end[axis] - 2);
  }
  return {roundedUp(double(top)), roundedUp(rise.cwiseQuotient(volume.spacing).norm())};
}

/// The bounds of the blocks of a row from (box.first[0], bj, bk) on. `one` is the bound of a single
/// block, which looks at n^3 voxels; those whose voxels all exist are found together.
template <int n, class T, class One>
lanes::BlockBound* scanRow(const Blocked<T>& volume, const BlockBox& box, std::int64_t bj,
                           std::int64_t bk, RowBounds<n, T>& together, One&& one,
                           lanes::BlockBound* out) {
  constexpr std::int64_t lead = (n - 3) / 2;  // voxels before the first cell, with its own
  const BlockCounts& dims = volume.dims;
  const std::int64_t j = 4 * bj - lead, k = 4 * bk - lead;
  std::int64_t from = std::max(box.first[0], (volume.box.first[0] + lead + 3) / 4);
  std::int64_t to = std::min(box.end[0], (volume.box.end[0] - n + lead + 4) / 4);
  if (from >= to || !allIn(volume.box, 4 * from - lead, j, k, n)) from = to = box.end[0];
  for (std::int64_t i = box.first[0]; i < from; ++i) *out++ = one(volume, i, bj, bk);
  if (from < to)
    together.find(volume.voxels + (k * dims[1] + j) * dims[0] + 4 * from - lead, to - from, dims,
                  volume.spacing, out);
  out += to - from;
  for (std::int64_t i = to; i < box.end[0]; ++i) *out++ = one(volume, i, bj, bk);
  return out;
}

/// The bounds of the blocks of a box, by themselves, in its order.
void scanBlocks(const Volume& volume, const VoxelBox& bounds, FieldKind kind, const BlockBox& box,
                lanes::BlockBound* out) {
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    using T = std::remove_cvref_t<decltype(*voxels)>;
    const Blocked<T> blocked{voxels, volume.grid.dims, bounds, volume.least, volume.grid.spacing};
    const auto scan = [&]<int n>(RowBounds<n, T> together, auto&& one) {
      for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
        for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
          out = scanRow(blocked, box, j, k, together, one, out);
    };
    if (kind == FieldKind::CubicSpline)
      scan(RowBounds<7, T>{}, splineBound<T>);
    else
      scan(RowBounds<5, T>{}, cellBound<T>);
  });
}

float greater(float a, float b) { return std::max(a, b); }

lanes::BlockBound greater(const lanes::BlockBound& a, const lanes::BlockBound& b) {
  return {std::max(a.greatest, b.greatest), std::max(a.lipschitz, b.lipschitz)};
}

/// Makes every block the greatest of itself and its two neighbours along one axis, for `width`
/// lines side by side of `count` blocks, `stride` apart. `before` is room for `width` blocks.
template <class Block>
void dilateLines(Block* layer, std::int64_t count, std::int64_t stride, std::int64_t width,
                 Block* before) {
  for (std::int64_t b = 0; b < count; ++b, layer += stride)
    for (std::int64_t i = 0; i < width; ++i) {
      const Block here = layer[i];
      if (b > 0) layer[i] = greater(layer[i], before[i]);
      if (b + 1 < count) layer[i] = greater(layer[i], layer[i + stride]);
      before[i] = here;
    }
}

/// Makes every block the greatest of itself and its 26 neighbours; beyond the grid nothing counts.
/// In place: of a large volume the blocks alone are a gigabyte.
template <class Block>
void dilate(std::vector<Block>& values, const BlockCounts& blocks, int threads) {
  const std::int64_t row = blocks[0], slice = row * blocks[1];
  inParallel(
      blocks[2],
      [&](std::int64_t k) {
        Block* const first = values.data() + k * slice;
        std::vector<Block> before(static_cast<std::size_t>(row));
        for (std::int64_t j = 0; j < blocks[1]; ++j)
          dilateLines(first + j * row, row, 1, 1, before.data());
        dilateLines(first, blocks[1], row, row, before.data());
      },
      threads);
  inParallel(
      blocks[1],
      [&](std::int64_t j) {
        std::vector<Block> before(static_cast<std::size_t>(row));
        dilateLines(values.data() + j * row, blocks[2], slice, row, before.data());
      },
      threads);
}

BlockCounts sidesOf(const BlockBox& box) {
  return {box.end[0] - box.first[0], box.end[1] - box.first[1], box.end[2] - box.first[2]};
}

std::int64_t countOf(const BlockBox& box) {
  const BlockCounts sides = sidesOf(box);
  return sides[0] * sides[1] * sides[2];
}

std::size_t placeOf(const BlockCounts& blocks, std::int64_t i, std::int64_t j, std::int64_t k) {
  return static_cast<std::size_t>((k * blocks[1] + j) * blocks[0] + i);
}

BlockBox grown(BlockBox box, std::int64_t by, const BlockCounts& blocks) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.first[axis] = std::max<std::int64_t>(box.first[axis] - by, 0);
    box.end[axis] = std::min(box.end[axis] + by, blocks[axis]);
  }
  return box;
}

/// The blocks of a level `up` levels above that hold those of a box.
BlockBox above(BlockBox box, int up) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.first[axis] >>= up;
    box.end[axis] = ((box.end[axis] - 1) >> up) + 1;
  }
  return box;
}

/// The greatest of up to eight blocks below block (i, j, k). The values below are those of a box
/// that holds them all.
template <class Block, class Greatest>
float greatestBelow(const std::vector<Block>& values, const BlockBox& box, std::int64_t i,
                    std::int64_t j, std::int64_t k, Greatest&& greatest) {
  float top = -std::numeric_limits<float>::infinity();
  const BlockCounts sides = sidesOf(box);
  const std::int64_t at[3] = {i, j, k};
  BlockBox below;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    below.first[axis] = 2 * at[axis] - box.first[axis];
    below.end[axis] = std::min(below.first[axis] + 2, sides[axis]);
  }
  forBlocks(below, [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    top = std::max(top, greatest(values[placeOf(sides, x, y, z)]));
  });
  return top;
}

/// Copies the blocks of `part` from values of the box `from` to values of the box `to`.
template <class Block>
void copyBlocks(const std::vector<Block>& values, const BlockBox& from, const BlockBox& part,
                std::vector<Block>& out, const BlockBox& to) {
  const BlockCounts source = sidesOf(from), target = sidesOf(to);
  for (std::int64_t k = part.first[2]; k < part.end[2]; ++k)
    for (std::int64_t j = part.first[1]; j < part.end[1]; ++j) {
      const auto row = values.begin() +
                       static_cast<std::ptrdiff_t>(placeOf(source, part.first[0] - from.first[0],
                                                           j - from.first[1], k - from.first[2]));
      std::copy(
          row, row + (part.end[0] - part.first[0]),
          out.begin() + static_cast<std::ptrdiff_t>(placeOf(target, part.first[0] - to.first[0],
                                                            j - to.first[1], k - to.first[2])));
    }
}

/// Adds the voxels of `box` that are not in `hole`, as boxes.
void addDifference(VoxelBox box, const VoxelBox& hole, std::vector<VoxelBox>& boxes) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t low = std::clamp(hole.first[axis], box.first[axis], box.end[axis]);
    const std::int64_t high = std::clamp(hole.end[axis], low, box.end[axis]);
    VoxelBox before = box, behind = box;
    before.end[axis] = low;
    behind.first[axis] = high;
    for (const VoxelBox& slab : {before, behind})
      if (slab.first[axis] < slab.end[axis]) boxes.push_back(slab);
    box.first[axis] = low;
    box.end[axis] = high;
    if (low == high) return;
  }
}

/// The finest blocks that look at a voxel of a box.
BlockBox blocksOver(const VoxelBox& box, FieldKind kind, const BlockCounts& blocks) {
  // a block b looks at the voxels from 4 b - 1 to 4 b + 3, that of a spline at one more each side
  const std::int64_t more = kind == FieldKind::CubicSpline ? 1 : 0;
  BlockBox over;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    over.first[axis] = std::max<std::int64_t>(0, box.first[axis] - more) / 4;
    over.end[axis] = std::min(blocks[axis], (box.end[axis] + more) / 4 + 1);
  }
  return over;
}

/// Boxes of finest blocks that look at a voxel that is not as it was.
std::vector<BlockBox> touchedBlocks(const VoxelBox& was, const VoxelBox& is,
                                    std::span<const VoxelBox> changed, FieldKind kind,
                                    const BlockCounts& blocks) {
  std::vector<VoxelBox> boxes;
  addDifference(was, is, boxes);
  addDifference(is, was, boxes);
  for (VoxelBox box : changed) {
    bool any = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.first[axis] = std::max({box.first[axis], was.first[axis], is.first[axis]});
      box.end[axis] = std::min({box.end[axis], was.end[axis], is.end[axis]});
      any = any && box.first[axis] < box.end[axis];
    }
    if (any) boxes.push_back(box);
  }
  std::vector<BlockBox> touched;
  BlockBox around{blocks, {}};
  std::int64_t separately = 0;
  for (const VoxelBox& box : boxes) {
    touched.push_back(blocksOver(box, kind, blocks));
    separately += countOf(grown(touched.back(), 2, blocks));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      around.first[axis] = std::min(around.first[axis], touched.back().first[axis]);
      around.end[axis] = std::max(around.end[axis], touched.back().end[axis]);
    }
  }
  // each box is renewed with two blocks around it, so many small ones are dearer than a large one
  if (touched.size() > 1 && separately >= countOf(grown(around, 2, blocks))) touched = {around};
  return touched;
}

}  // namespace

MaxPyramid::MaxPyramid(const Volume& volume, FieldKind kind, const std::atomic<bool>* cancel,
                       int threads)
    : box_{volume.bounds()},
      smallest_spacing_{volume.grid.spacing.minCoeff()},
      per_spacing_{volume.grid.spacing.cwiseInverse()} {
  BlockCounts blocks;
  for (std::size_t axis = 0; axis < 3; ++axis)
    blocks[axis] = (volume.grid.dims[axis] + 1 + kCells - 1) / kCells;
  finest_.resize(static_cast<std::size_t>(blocks[0] * blocks[1] * blocks[2]));
  const auto isCancelled = [cancel] { return cancel != nullptr && *cancel; };

  // every block layer is independent of the others
  inParallel(
      blocks[2],
      [&](std::int64_t k) {
        if (isCancelled()) return;
        scanBlocks(volume, box_, kind, {{0, 0, k}, {blocks[0], blocks[1], k + 1}},
                   finest_.data() + k * blocks[0] * blocks[1]);
      },
      threads);
  if (isCancelled()) return;

  // each coarser level from the one below it, before that is dilated
  std::vector<float> own;
  for (int l = 0; l < kLevels && !isCancelled(); ++l) {
    levels_[l].blocks = blocks;
    BlockCounts coarser;
    for (std::size_t axis = 0; axis < 3; ++axis) coarser[axis] = (blocks[axis] + 1) / 2;
    std::vector<float> next(static_cast<std::size_t>(coarser[0] * coarser[1] * coarser[2]),
                            -std::numeric_limits<float>::infinity());
    inParallel(
        coarser[2],
        [&](std::int64_t above) {
          for (std::int64_t k = 2 * above; k < std::min(2 * above + 2, blocks[2]); ++k)
            for (std::int64_t j = 0; j < blocks[1]; ++j) {
              float* const row = next.data() + placeOf(coarser, 0, j / 2, above);
              const std::size_t at = placeOf(blocks, 0, j, k);
              for (std::size_t i = 0; i < static_cast<std::size_t>(blocks[0]); ++i)
                row[i / 2] = std::max(row[i / 2], l == 0 ? finest_[at + i].greatest : own[at + i]);
            }
        },
        threads);
    if (l == 0) {
      dilate(finest_, blocks, threads);
    } else {
      levels_[l].greatest = own;
      dilate(levels_[l].greatest, blocks, threads);
      levels_[l].own = std::move(own);
    }
    blocks = coarser;
    own = std::move(next);
  }
}

MaxPyramid::MaxPyramid(const MaxPyramid& before, const Volume& volume,
                       std::span<const VoxelBox> changed, FieldKind kind,
                       const std::atomic<bool>* cancel)
    : MaxPyramid{before} {
  const auto isCancelled = [cancel] { return cancel != nullptr && *cancel; };
  const VoxelBox was = box_;
  box_ = volume.bounds();
  const BlockCounts& blocks = levels_[0].blocks;
  const BlockBox all{{}, blocks};
  std::vector<BlockBox> renewed = touchedBlocks(was, box_, changed, kind, blocks);
  for (BlockBox& out : renewed) {
    // what a touched block reaches, in whole blocks of the next level
    out = grown(out, 1, blocks);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.first[axis] &= ~std::int64_t{1};
      out.end[axis] = std::min((out.end[axis] + 1) & ~std::int64_t{1}, blocks[axis]);
    }
    constexpr std::int64_t kLayers = 16;  // at once
    inParallel((out.end[2] - out.first[2] + kLayers - 1) / kLayers, [&](std::int64_t n) {
      if (isCancelled()) return;
      BlockBox part = out;
      part.first[2] = out.first[2] + n * kLayers;
      part.end[2] = std::min(part.first[2] + kLayers, out.end[2]);
      const BlockBox seen = grown(part, 1, blocks);
      std::vector<lanes::BlockBound> bounds(static_cast<std::size_t>(countOf(seen)));
      scanBlocks(volume, box_, kind, seen, bounds.data());
      forBlocks(above(part, 1), [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        levels_[1].own[placeOf(levels_[1].blocks, i, j, k)] = greatestBelow(
            bounds, seen, i, j, k, [](const lanes::BlockBound& bound) { return bound.greatest; });
      });
      dilate(bounds, sidesOf(seen), 1);
      copyBlocks(bounds, seen, part, finest_, all);
    });
  }
  for (int l = 1; l < kLevels && !isCancelled(); ++l) {
    Level& level = levels_[l];
    const BlockBox whole{{}, level.blocks};
    if (l > 1)
      for (const BlockBox& out : renewed)
        forBlocks(above(out, l), [&](std::int64_t i, std::int64_t j, std::int64_t k) {
          level.own[placeOf(level.blocks, i, j, k)] =
              greatestBelow(levels_[l - 1].own, {{}, levels_[l - 1].blocks}, i, j, k,
                            [](float greatest) { return greatest; });
        });
    for (const BlockBox& out : renewed) {
      const BlockBox part = grown(above(out, l), 1, level.blocks);
      const BlockBox seen = grown(part, 1, level.blocks);
      std::vector<float> values(static_cast<std::size_t>(countOf(seen)));
      copyBlocks(level.own, whole, seen, values, seen);
      dilate(values, sidesOf(seen), 1);
      copyBlocks(values, seen, part, level.greatest, whole);
    }
  }
}

VoxelBox MaxPyramid::blocksAround(const VoxelBox& voxels, FieldKind kind) const HAPTICS_RT {
  return grown(blocksOver(voxels, kind, levels_[0].blocks), 1, levels_[0].blocks);
}

bool MaxPyramid::raise(std::int64_t block, double steepest, float& raised) HAPTICS_RT {
  const float slope = roundedUp(steepest * per_spacing_.norm());
  const double before = raised;
  if (!(slope > raised)) return false;
  // Along each axis the greatest difference is now at most the greater of the two; the constant is
  // the norm of those of the axes, and not the greater of two norms.
  float& lipschitz = finest_[static_cast<std::size_t>(block)].lipschitz;
  lipschitz =
      roundedUp(std::sqrt(double{lipschitz} * lipschitz + double{slope} * slope - before * before));
  raised = slope;
  return true;
}

namespace {

/// Of n^3 voxels from `corner` on, without the memory that RowBounds has.
template <int n, class T>
lanes::BlockBound boundFrom(const T* corner, const BlockCounts& dims,
                            const Vec3& per_spacing) HAPTICS_RT {
  using Wide = std::conditional_t<sizeof(T) <= 2, int, double>;
  const std::int64_t row = dims[0], slice = dims[0] * dims[1];
  T top = *corner;
  Wide dx = 0, dy = 0, dz = 0;
  const auto rise = [](Wide most, T a, T b) {
    const Wide d = Wide(a) - Wide(b);
    return std::max(most, d < 0 ? -d : d);
  };
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j) {
      const T* const v = corner + k * slice + j * row;
      for (int i = 0; i < n; ++i) top = std::max(top, v[i]);
      for (int i = 0; i + 1 < n; ++i) dx = rise(dx, v[i + 1], v[i]);
      if (j + 1 < n)
        for (int i = 0; i < n; ++i) dy = rise(dy, v[i + row], v[i]);
      if (k + 1 < n)
        for (int i = 0; i < n; ++i) dz = rise(dz, v[i + slice], v[i]);
    }
  return {roundedUp(double(top)),
          roundedUp(Vec3{double(dx), double(dy), double(dz)}.cwiseProduct(per_spacing).norm() *
                    (1.0 + 1e-12))};
}

}  // namespace

bool MaxPyramid::renew(const Volume& volume, FieldKind kind, std::int64_t block) HAPTICS_RT {
  const BlockCounts& blocks = levels_[0].blocks;
  const std::int64_t more = kind == FieldKind::CubicSpline ? 1 : 0;
  // the voxels that the block and its 26 neighbours look at
  const std::int64_t i = 4 * (block % blocks[0]) - 5 - more,
                     j = 4 * (block / blocks[0] % blocks[1]) - 5 - more,
                     k = 4 * (block / (blocks[0] * blocks[1])) - 5 - more;
  const BlockCounts& dims = volume.grid.dims;
  return visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    lanes::BlockBound& bound = finest_[static_cast<std::size_t>(block)];
    const auto* corner = voxels + (k * dims[1] + j) * dims[0] + i;
    if (more == 1) {
      if (!allIn(box_, i, j, k, 15)) return false;
      bound = boundFrom<15>(corner, dims, per_spacing_);
    } else {
      if (!allIn(box_, i, j, k, 13)) return false;
      bound = boundFrom<13>(corner, dims, per_spacing_);
    }
    return true;
  });
}

std::array<std::int64_t, 3> MaxPyramid::blockOf(const Vec3& u, int level) const HAPTICS_RT {
  std::array<std::int64_t, 3> b;
  for (int axis = 0; axis < 3; ++axis) {
    // a place beyond the voxels is judged by the nearest block: nothing lies between
    const double cell =
        std::clamp(std::floor(u[axis]), double(box_.first[axis] - 1), double(box_.end[axis] - 1));
    b[axis] = (static_cast<std::int64_t>(cell) + 1) / (std::int64_t{kCells} << level);
  }
  return b;
}

MaxPyramid::Bound MaxPyramid::bound(const Vec3& u, double s) const HAPTICS_RT {
  // beyond the voxels there is only background, as far as they are away
  double outside = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    outside = std::max(
        {outside, double(box_.first[axis] - 1) - u[axis], u[axis] - double(box_.end[axis])});
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
  for (const Level& level : levels_) floats += level.greatest.size() + level.own.size();
  return floats * sizeof(float);
}

}  // namespace haptics
