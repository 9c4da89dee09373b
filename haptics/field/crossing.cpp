// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/field/scalar_field.h"
#include "haptics/field/spline_cell.h"

namespace haptics {
namespace {

/// A cubic on [0, 1] by its Bernstein coefficients; their hull contains it.
using Cubic = std::array<double, 4>;

/// The cell's field along the segment a→b of index coordinates. A trilinear function is its own
/// blossom in each coordinate, so the inner coefficients are means over the mixed corners of the
/// segment's box.
Cubic alongSegment(const Cell& cell, const Vec3& a, const Vec3& b) HAPTICS_RT {
  const double x[2] = {a.x() - double(cell.at[0]), b.x() - double(cell.at[0])};
  const double y[2] = {a.y() - double(cell.at[1]), b.y() - double(cell.at[1])};
  const double z[2] = {a.z() - double(cell.at[2]), b.z() - double(cell.at[2])};
  const auto& c = cell.corner;
  double f[2][2][2];  // [x][y][z]
  for (int ix = 0; ix < 2; ++ix) {
    const double c00 = c[0] + x[ix] * (c[1] - c[0]), c10 = c[2] + x[ix] * (c[3] - c[2]);
    const double c01 = c[4] + x[ix] * (c[5] - c[4]), c11 = c[6] + x[ix] * (c[7] - c[6]);
    for (int iy = 0; iy < 2; ++iy) {
      const double d0 = c00 + y[iy] * (c10 - c00), d1 = c01 + y[iy] * (c11 - c01);
      for (int iz = 0; iz < 2; ++iz) f[ix][iy][iz] = d0 + z[iz] * (d1 - d0);
    }
  }
  return {f[0][0][0], (f[1][0][0] + f[0][1][0] + f[0][0][1]) / 3.0,
          (f[1][1][0] + f[1][0][1] + f[0][1][1]) / 3.0, f[1][1][1]};
}

/// The left end of the first piece, no longer than `tolerance`, on which the polynomial's hull
/// reaches `level`; 2 if there is none. N Bernstein coefficients.
template <std::size_t N>
double firstReachOf(const std::array<double, N>& f, double level, double from, double to,
                    double tolerance) HAPTICS_RT {
  if (*std::max_element(f.begin(), f.end()) < level) return 2.0;
  if (f[0] >= level || to - from <= tolerance) return from;
  // de Casteljau at the middle; `right` is worked on in place
  std::array<double, N> left, right = f;
  for (std::size_t row = 0; row < N; ++row) {
    left[row] = right[0];
    for (std::size_t i = 0; i + 1 + row < N; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
  }
  const double half = 0.5 * (from + to);
  const double reach = firstReachOf(left, level, from, half, tolerance);
  if (reach <= 1.0) return reach;
  return firstReachOf(right, level, half, to, tolerance);
}

/// Walks the cells along the segment a→b of index coordinates, in order, until `visit(cell, from,
/// to)` returns a fraction up to 1; 2 if none does.
template <class Visit>
double walkCells(const Vec3& a, const Vec3& b, Visit&& visit) HAPTICS_RT {
  const Vec3 d = b - a;
  std::array<std::int64_t, 3> at;
  std::array<int, 3> step;
  Vec3 next, stride;
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::clamp(std::floor(a[axis]), -1e15, 1e15);
    at[axis] = static_cast<std::int64_t>(cell);
    step[axis] = d[axis] > 0.0 ? 1 : -1;
    if (d[axis] == 0.0) {
      next[axis] = stride[axis] = std::numeric_limits<double>::infinity();
      continue;
    }
    stride[axis] = 1.0 / std::abs(d[axis]);
    next[axis] = (d[axis] > 0.0 ? cell + 1.0 - a[axis] : a[axis] - cell) * stride[axis];
  }
  double from = 0.0;
  while (from < 1.0) {
    int axis = 0;
    if (next[1] < next[axis]) axis = 1;
    if (next[2] < next[axis]) axis = 2;
    const double to = std::min(1.0, next[axis]);
    if (to > from) {
      const double t = visit(at, from, to);
      if (t <= 1.0) return t;
      from = to;
    }
    if (next[axis] >= 1.0) break;
    at[axis] += step[axis];
    next[axis] += stride[axis];
  }
  return 2.0;
}

}  // namespace

double ScalarField::firstReach(const Vec3& a, const Vec3& b, double level, double tolerance,
                               Budget& budget) const HAPTICS_RT {
  const Vec3 d = b - a;
  if (kind_ == FieldKind::CubicSpline)
    return walkCells(a, b, [&](const std::array<std::int64_t, 3>& at, double from, double to) {
      budget.spend(kSplineWork);
      ++budget.counts.samples;
      const SplineCell cell = splineCellAt(*volume_, bounds_, at);
      if (cell.greatest() < level) return 2.0;
      budget.spend(kSplineSegmentWork);
      return firstReachOf(cell.alongSegment(a + from * d, a + to * d), level, from, to, tolerance);
    });
  return walkCells(a, b, [&](const std::array<std::int64_t, 3>& at, double from, double to) {
    budget.spend(kCellWork);
    ++budget.counts.samples;
    return firstReachOf(alongSegment(cellAt(at), a + from * d, a + to * d), level, from, to,
                        tolerance);
  });
}

}  // namespace haptics
