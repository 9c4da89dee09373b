// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/cell_covers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/core/fixed_vector.h"

namespace haptics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kDeepest = 5;            // halvings of a cell
constexpr int kMostParts = 400;        // of a cell
constexpr std::int64_t kPartWork = 2;  // of a look at one

/// A part of the unit cell: a cube.
struct Part {
  std::array<double, 8> above;  ///< F less the level, in the corners
  double foot = 0.0;            ///< n · u in its lowest corner
  double size = 1.0;
  int depth = 0;
};

/// Halves the cube on each axis. F is linear along each, so the new corners are means of the old.
void halve(const Part& part, const std::array<double, 8>& corner_along,
           std::array<Part, 8>& halves) HAPTICS_RT {
  std::array<double, 27> at;  // 3^3 places
  const auto place = [](int x, int y, int z) {
    return static_cast<std::size_t>(x + 3 * y + 9 * z);
  };
  for (std::size_t c = 0; c < 8; ++c)
    at[place(2 * int(c & 1), 2 * int(c >> 1 & 1), 2 * int(c >> 2))] = part.above[c];
  for (int z = 0; z < 3; z += 2)
    for (int y = 0; y < 3; y += 2)
      at[place(1, y, z)] = 0.5 * (at[place(0, y, z)] + at[place(2, y, z)]);
  for (int z = 0; z < 3; z += 2)
    for (int x = 0; x < 3; ++x)
      at[place(x, 1, z)] = 0.5 * (at[place(x, 0, z)] + at[place(x, 2, z)]);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      at[place(x, y, 1)] = 0.5 * (at[place(x, y, 0)] + at[place(x, y, 2)]);
  const double size = 0.5 * part.size;
  for (int h = 0; h < 8; ++h) {
    Part& half = halves[static_cast<std::size_t>(h)];
    const int x = h & 1, y = h >> 1 & 1, z = h >> 2;
    for (int c = 0; c < 8; ++c)
      half.above[static_cast<std::size_t>(c)] =
          at[place(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))];
    half.foot = part.foot + size * corner_along[static_cast<std::size_t>(h)];
    half.size = size;
    half.depth = part.depth + 1;
  }
}

/// Height of the solid in a cell along the unit vector n: the greatest n · u with F >= level, from
/// the cell's lowest corner, and at most kTightness more.
///
/// In a cube F is linear along each axis. So for every factor >= 0 the greatest of
/// n · u + factor (F - level) over the corners bounds n · u where F >= level (weak duality). The
/// factor is one over the slope along n.
double heightAlong(const Cell& cell, const Vec3& n, double level, Budget& budget) HAPTICS_RT {
  std::array<double, 8> along;  // n · u in the corners of the unit cube
  Part whole;
  for (std::size_t c = 0; c < 8; ++c) {
    along[c] = n.dot(Vec3{double(c & 1), double(c >> 1 & 1), double(c >> 2)});
    whole.above[c] = cell.corner[c] - level;
  }
  int steepest = 0;
  n.cwiseAbs().maxCoeff(&steepest);
  const std::size_t up = std::size_t{1} << steepest;
  const double farthest = *std::max_element(along.begin(), along.end());
  double height = -kInfinity;  // of what needs no closer look
  double known = -kInfinity;   // of some place in the solid
  FixedVector<Part, 8 * (kDeepest + 1)> open;
  open.push(whole);
  for (int looked = 1; !open.empty(); ++looked) {
    const Part part = open[open.size() - 1];
    open.dropUnordered(open.size() - 1);
    budget.spend(kPartWork);
    const std::array<double, 8>& F = part.above;
    const double most = *std::max_element(F.begin(), F.end());
    if (most < 0.0) continue;
    const double slope = 0.25 / part.size *
                         (n.x() * (F[1] - F[0] + F[3] - F[2] + F[5] - F[4] + F[7] - F[6]) +
                          n.y() * (F[2] - F[0] + F[3] - F[1] + F[6] - F[4] + F[7] - F[5]) +
                          n.z() * (F[4] - F[0] + F[5] - F[1] + F[6] - F[2] + F[7] - F[3]));
    double bound = farthest * part.size;
    if (slope < 0.0) {
      double dual = -kInfinity;
      for (std::size_t c = 0; c < 8; ++c)
        dual = std::max(dual, part.size * along[c] - F[c] / slope);
      bound = std::min(bound, dual);
    }
    // the surface on the four edges that are steepest, and the corners inside
    for (std::size_t c = 0; c < 8; ++c) {
      if (F[c] < 0.0) continue;
      const std::size_t beside = c ^ up;
      double reach = along[c];
      if (along[beside] > along[c])
        reach += (along[beside] - along[c]) * (F[beside] < 0.0 ? F[c] / (F[c] - F[beside]) : 1.0);
      known = std::max(known, part.foot + part.size * reach);
    }
    bound += part.foot;
    if (bound <= std::max(height, known + CellCovers::kTightness) || part.depth == kDeepest ||
        looked + static_cast<int>(open.size()) >= kMostParts) {
      height = std::max(height, bound);
      continue;
    }
    std::array<Part, 8> halves;
    halve(part, along, halves);
    // the farthest along n is looked at first: what is known soon spares the others
    const unsigned mirror =
        (n.x() > 0.0 ? 0U : 1U) | (n.y() > 0.0 ? 0U : 2U) | (n.z() > 0.0 ? 0U : 4U);
    for (unsigned h = 0; h < 8; ++h) open.push(halves[h ^ mirror]);
  }
  return height;
}

/// The mean gradient of F over the cell and its 26 neighbours, but for a factor. Along a smoother
/// normal than its own, the covers of neighbouring cells differ less.
Vec3 slopeAround(const ScalarField& field, const std::array<std::int64_t, 3>& at,
                 Budget& budget) HAPTICS_RT {
  // of the four voxels along an axis: their share in a difference from end to end, and in a mean
  constexpr double kRise[4] = {-1.0, 0.0, 0.0, 1.0}, kShare[4] = {1.0, 2.0, 2.0, 1.0};
  Vec3 slope = Vec3::Zero();
  for (int c = 0; c < 8; ++c) {
    const int first[3] = {2 * (c & 1), 2 * (c >> 1 & 1), 2 * (c >> 2)};
    const Cell cell =
        field.cellAt({at[0] - 1 + first[0], at[1] - 1 + first[1], at[2] - 1 + first[2]});
    for (int k = 0; k < 8; ++k) {
      const int x = first[0] + (k & 1), y = first[1] + (k >> 1 & 1), z = first[2] + (k >> 2);
      slope += cell.corner[static_cast<std::size_t>(k)] * Vec3{kRise[x] * kShare[y] * kShare[z],
                                                               kShare[x] * kRise[y] * kShare[z],
                                                               kShare[x] * kShare[y] * kRise[z]};
    }
  }
  budget.spend(8 * field.work());
  budget.counts.samples += 8;
  return slope;
}

CellCover coverOf(const Isosurface& solid, const std::array<std::int64_t, 3>& at,
                  Budget& budget) HAPTICS_RT {
  budget.spend(solid.field.work());
  ++budget.counts.samples;
  const Cell cell = solid.field.cellAt(at);
  // a little below, so that rounding puts no point inside
  const double level = solid.ceiling() - 0.1 * solid.field.roundingMargin();
  if (*std::max_element(cell.corner.begin(), cell.corner.end()) < level)
    return {Vec3::Zero(), -kInfinity};
  const Vec3 low{double(at[0]), double(at[1]), double(at[2])};
  const Vec3 slope = slopeAround(solid.field, at, budget);
  const double steep = slope.norm();
  if (!(steep > 0.0) || !std::isfinite(steep)) return {Vec3::Zero(), kInfinity};
  const Vec3 n = -slope / steep;
  return {n, n.dot(low) + heightAlong(cell, n, level, budget)};
}

}  // namespace

const CellCover& CellCovers::at(const Isosurface& solid, const std::array<std::int64_t, 3>& at,
                                Budget& budget) HAPTICS_RT {
  constexpr std::int64_t kHalf = std::int64_t{1} << 20;
  const std::int64_t key = ((at[2] + kHalf) << 42) | ((at[1] + kHalf) << 21) | (at[0] + kHalf);
  // the high bits of a product with a large odd number: neighbours fall into different sets
  const std::uint64_t hash = static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15U;
  Entry* const set = entries_.data() + (hash >> 52) * kWays;
  ++calls_;
  Entry* oldest = set;
  for (Entry* entry = set; entry != set + kWays; ++entry) {
    if (entry->epoch == epoch_ && entry->key == key) {
      entry->used = calls_;
      return entry->cover;
    }
    if (entry->epoch != epoch_) entry->used = 0;
    if (entry->used < oldest->used) oldest = entry;
  }
  oldest->cover = coverOf(solid, at, budget);
  oldest->key = key;
  oldest->epoch = epoch_;
  oldest->used = calls_;
  return oldest->cover;
}

}  // namespace haptics
