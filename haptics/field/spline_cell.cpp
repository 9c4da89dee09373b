// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/spline_cell.h"

#include <algorithm>

namespace haptics {
namespace {

using Taps = std::array<double, 4>;

constexpr Taps kLowFace{0.0, 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
constexpr Taps kHighFace{1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0};

/// The four cubics of the uniform B-spline at x.
Taps weights(double x) HAPTICS_RT {
  const double y = 1.0 - x, xx = x * x, yy = y * y;
  return {yy * y * (1.0 / 6.0), 4.0 / 6.0 - xx * (1.0 - 0.5 * x), 4.0 / 6.0 - yy * (1.0 - 0.5 * y),
          xx * x * (1.0 / 6.0)};
}
/// Six times their blossom, which is symmetric: the cubics at x where a = b = c = x, and otherwise
/// Bernstein coefficients of them on [a, b].
Taps blossom(double a, double b, double c) HAPTICS_RT {
  const double d = 1.0 - a, e = 1.0 - b, f = 1.0 - c;
  return {d * e * f, 3.0 * a * b * c - 2.0 * (a * b + b * c + c * a) + 4.0,
          3.0 * d * e * f - 2.0 * (d * e + e * f + f * d) + 4.0, a * b * c};
}
/// The slopes of the cubics at x.
Taps slopes(double x) HAPTICS_RT {
  const double y = 1.0 - x;
  return {-0.5 * y * y, x * (1.5 * x - 2.0), y * (2.0 - 1.5 * y), 0.5 * x * x};
}

Taps scaled(Taps w, double factor) HAPTICS_RT {
  for (double& weight : w) weight *= factor;
  return w;
}
const Taps& atFace(int face) HAPTICS_RT { return face < 0 ? kLowFace : kHighFace; }
/// What of the field is left at x: all of it within the box.
double leftAt(int face, double x) HAPTICS_RT { return face == 0 ? 1.0 : face < 0 ? x : 1.0 - x; }

/// The weights of one axis, and what of the field is left there.
struct Weights {
  Taps w;
  double left;
};
Weights weightsOn(int face, double x) HAPTICS_RT {
  const double left = leftAt(face, x);
  return {face == 0 ? weights(x) : scaled(atFace(face), left), left};
}
/// Six times the Bernstein coefficients.
Weights blossomOn(int face, double a, double b, double c) HAPTICS_RT {
  const double left = leftAt(face, (a + b + c) / 3.0);
  return {face == 0 ? blossom(a, b, c) : scaled(atFace(face), 6.0 * left), left};
}
Taps slopesOn(int face, double x, double& left) HAPTICS_RT {
  left = face < 0 ? 1.0 : face > 0 ? -1.0 : 0.0;
  return face == 0 ? slopes(x) : scaled(atFace(face), left);
}

// Sums of four, always in this order, which is that of the lanes: first along j, then k, then i.

double weighted(const Taps& w, const Taps& v) HAPTICS_RT {
  return w[0] * v[0] + w[1] * v[1] + w[2] * v[2] + w[3] * v[3];
}
/// For each of the four taps along i.
Taps weighted(const Taps& w, const Taps& a, const Taps& b, const Taps& c,
              const Taps& d) HAPTICS_RT {
  Taps sum;
  for (std::size_t i = 0; i < 4; ++i)
    sum[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
  return sum;
}
Taps weighted(const Taps& w, const std::array<Taps, 4>& v) HAPTICS_RT {
  return weighted(w, v[0], v[1], v[2], v[3]);
}

/// Index i mirrored at the first and the last voxel; one voxel is its own mirror.
std::int64_t mirrored(std::int64_t i, std::int64_t first, std::int64_t last) HAPTICS_RT {
  if (i < first) i = 2 * first - i;
  if (i > last) i = 2 * last - i;
  return std::clamp(i, first, last);
}

template <class T>
void fetch(const T* voxels, const Grid& grid, const VoxelBox& box, SplineCell& cell) HAPTICS_RT {
  const std::int64_t stride[3] = {1, grid.dims[0], grid.dims[0] * grid.dims[1]};
  std::array<std::array<std::int64_t, 4>, 3> offset;
  std::array<bool, 3> all;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t first = cell.at[axis] - 1, low = box.first[axis], high = box.end[axis] - 1;
    all[axis] = first >= low && first + 3 <= high;
    for (std::int64_t tap = 0; tap < 4; ++tap)
      offset[axis][static_cast<std::size_t>(tap)] =
          stride[axis] * (all[axis] ? first + tap : mirrored(first + tap, low, high));
  }
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 4; ++j) {
      const T* row = voxels + offset[2][k] + offset[1][j];
      Taps& out = cell.voxel[k][j];
      if (all[0]) {
        row += offset[0][0];
        for (std::size_t i = 0; i < 4; ++i) out[i] = double(row[i]);
      } else {
        for (std::size_t i = 0; i < 4; ++i) out[i] = double(row[offset[0][i]]);
      }
    }
}

/// out += p q, with Bernstein coefficients times their binomials: a plain convolution.
template <std::size_t P>
void addProduct(const std::array<double, P>& p, const Taps& q,
                std::array<double, P + 3>& out) HAPTICS_RT {
  for (std::size_t i = 0; i < P; ++i)
    for (std::size_t j = 0; j < 4; ++j) out[i + j] += p[i] * q[j];
}

}  // namespace

SplineCell splineCellAt(const Volume& volume, const VoxelBox& bounds,
                        const std::array<std::int64_t, 3>& at) HAPTICS_RT {
  SplineCell cell;
  cell.at = at;
  cell.background = volume.least;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t first = bounds.first[axis], last = bounds.end[axis] - 1;
    cell.beyond = cell.beyond || at[axis] < first - 1 || at[axis] > last;
    cell.face[axis] = at[axis] < first ? -1 : at[axis] >= last ? 1 : 0;
  }
  if (cell.beyond)
    for (auto& plane : cell.voxel)
      for (Taps& row : plane) row.fill(volume.least);
  else
    visitVoxels(volume.type, volume.voxels.get(),
                [&](const auto* voxels) { fetch(voxels, volume.grid, bounds, cell); });
  return cell;
}

double SplineCell::greatest() const HAPTICS_RT {
  Taps top = voxel[0][0];
  for (const auto& plane : voxel)
    for (const Taps& row : plane)
      for (std::size_t i = 0; i < 4; ++i) top[i] = std::max(top[i], row[i]);
  return std::max(background, std::max(std::max(top[0], top[1]), std::max(top[2], top[3])));
}

double SplineCell::value(const Vec3& u) const HAPTICS_RT {
  if (beyond) return background;
  std::array<Weights, 3> axis;
  for (int a = 0; a < 3; ++a) {
    const auto n = static_cast<std::size_t>(a);
    axis[n] = weightsOn(face[n], u[a] - double(at[n]));
  }
  std::array<Taps, 4> planes;
  for (std::size_t k = 0; k < 4; ++k) planes[k] = weighted(axis[1].w, voxel[k]);
  const double sum = weighted(axis[0].w, weighted(axis[2].w, planes));
  const double left = axis[0].left * axis[1].left * axis[2].left;
  return left == 1.0 ? sum : sum + (1.0 - left) * background;
}

double SplineCell::sample(const Vec3& u, Vec3& gradient) const HAPTICS_RT {
  gradient.setZero();
  if (beyond) return background;
  std::array<Weights, 3> axis;
  std::array<Taps, 3> slope;
  Vec3 fall;  // of what is left, per axis
  for (int a = 0; a < 3; ++a) {
    const auto n = static_cast<std::size_t>(a);
    const double x = u[a] - double(at[n]);
    axis[n] = weightsOn(face[n], x);
    slope[n] = slopesOn(face[n], x, fall[a]);
  }
  std::array<Taps, 4> planes, slopes_y;
  for (std::size_t k = 0; k < 4; ++k) {
    planes[k] = weighted(axis[1].w, voxel[k]);
    slopes_y[k] = weighted(slope[1], voxel[k]);
  }
  const Taps sums = weighted(axis[2].w, planes);
  const double sum = weighted(axis[0].w, sums);
  gradient = {weighted(slope[0], sums), weighted(axis[0].w, weighted(axis[2].w, slopes_y)),
              weighted(axis[0].w, weighted(slope[2], planes))};
  const double left = axis[0].left * axis[1].left * axis[2].left;
  if (left == 1.0 && fall.isZero(0.0)) return sum;
  gradient -= background * Vec3{fall.x() * axis[1].left * axis[2].left,
                                fall.y() * axis[0].left * axis[2].left,
                                fall.z() * axis[0].left * axis[1].left};
  return sum + (1.0 - left) * background;
}

Vec3 SplineCell::normalSlope(const Vec3& u) const HAPTICS_RT {
  Vec3 gradient = Vec3::Zero();
  if (beyond) return gradient;
  std::array<Weights, 3> axis;
  std::array<Taps, 3> slope;
  Vec3 fall;  // of what is left, per axis
  for (int a = 0; a < 3; ++a) {
    const auto n = static_cast<std::size_t>(a);
    const double x = u[a] - double(at[n]), left = leftAt(face[n], (x + x + x) / 3.0);
    axis[n] = {face[n] == 0 ? blossom(x, x, x) : scaled(atFace(face[n]), left), left};
    if (face[n] == 0)
      for (double& w : axis[n].w) w /= 6.0;
    slope[n] = slopesOn(face[n], x, fall[a]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    double value_k = 0.0, dx_k = 0.0, dy_k = 0.0;
    for (std::size_t j = 0; j < 4; ++j) {
      const double value_j = weighted(axis[0].w, voxel[k][j]);
      value_k += axis[1].w[j] * value_j;
      dy_k += slope[1][j] * value_j;
      dx_k += axis[1].w[j] * weighted(slope[0], voxel[k][j]);
    }
    gradient += Vec3{axis[2].w[k] * dx_k, axis[2].w[k] * dy_k, slope[2][k] * value_k};
  }
  if (axis[0].left * axis[1].left * axis[2].left == 1.0 && fall.isZero(0.0)) return gradient;
  return gradient - background * Vec3{fall.x() * axis[1].left * axis[2].left,
                                      fall.y() * axis[0].left * axis[2].left,
                                      fall.z() * axis[0].left * axis[1].left};
}

SplineCell::Along SplineCell::alongSegment(const Vec3& a, const Vec3& b) const HAPTICS_RT {
  Along along;
  along.fill(background);
  if (beyond) return along;
  // the weights of each axis as cubics in the parameter: Bernstein coefficients times binomials
  constexpr Taps kBinomial{1.0, 3.0, 3.0, 1.0};
  constexpr Along kNinth{1.0, 9.0, 36.0, 84.0, 126.0, 126.0, 84.0, 36.0, 9.0, 1.0};
  std::array<std::array<Taps, 4>, 3> weight;  // [axis][coefficient][tap]
  std::array<Taps, 3> left;                   // [axis][coefficient]
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int n = static_cast<int>(axis);
    const double from = a[n] - double(at[axis]), to = b[n] - double(at[axis]);
    const Weights at_coefficient[4] = {
        blossomOn(face[axis], from, from, from), blossomOn(face[axis], from, from, to),
        blossomOn(face[axis], from, to, to), blossomOn(face[axis], to, to, to)};
    for (std::size_t c = 0; c < 4; ++c) {
      left[axis][c] = at_coefficient[c].left * kBinomial[c];
      weight[axis][c] = scaled(at_coefficient[c].w, kBinomial[c] / 6.0);
    }
  }
  // the products of the weights of j and k, for each tap along i
  std::array<Taps, 7> sums{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t c = 0; c < 4; ++c) {
      const Taps plane = weighted(weight[1][c], voxel[k]);
      for (std::size_t e = 0; e < 4; ++e)
        for (std::size_t i = 0; i < 4; ++i) sums[c + e][i] += weight[2][e][k] * plane[i];
    }
  along.fill(0.0);
  for (std::size_t c = 0; c < 7; ++c)
    for (std::size_t e = 0; e < 4; ++e) along[c + e] += weighted(weight[0][e], sums[c]);
  if (face[0] != 0 || face[1] != 0 || face[2] != 0) {
    // what has fallen away is background
    std::array<double, 7> plane{};
    Along whole{};
    addProduct(left[0], left[1], plane);
    addProduct(plane, left[2], whole);
    for (std::size_t c = 0; c < 10; ++c) along[c] += (kNinth[c] - whole[c]) * background;
  }
  for (std::size_t c = 0; c < 10; ++c) along[c] /= kNinth[c];
  return along;
}

}  // namespace haptics
