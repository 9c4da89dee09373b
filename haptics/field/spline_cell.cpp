// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/spline_cell.h"

#include <algorithm>

namespace haptics {
namespace {

using Taps = std::array<double, 4>;

constexpr Taps kLowFace{0.0, 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
constexpr Taps kHighFace{1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0};

/// The four cubics of the uniform B-spline, as their blossom: equal to the weights at x where
/// a = b = c = x, and to Bernstein coefficients of them on [a, b] otherwise.
Taps weights(double a, double b, double c) HAPTICS_RT {
  const double d = 1.0 - a, e = 1.0 - b, f = 1.0 - c;
  return {d * e * f / 6.0, (3.0 * a * b * c - 2.0 * (a * b + b * c + c * a) + 4.0) / 6.0,
          (3.0 * d * e * f - 2.0 * (d * e + e * f + f * d) + 4.0) / 6.0, a * b * c / 6.0};
}
/// Their slopes at x.
Taps slopes(double x) HAPTICS_RT {
  const double y = 1.0 - x;
  return {-0.5 * y * y, x * (1.5 * x - 2.0), y * (2.0 - 1.5 * y), 0.5 * x * x};
}

/// The weights of one axis, and what of the field is left there: all of it within the grid.
struct Weights {
  Taps w;
  double left = 1.0;
};
Weights weightsOn(int face, double a, double b, double c) HAPTICS_RT {
  if (face == 0) return {weights(a, b, c), 1.0};
  const double mean = (a + b + c) / 3.0;
  const double left = face < 0 ? mean : 1.0 - mean;
  Weights result{face < 0 ? kLowFace : kHighFace, left};
  for (double& w : result.w) w *= left;
  return result;
}
Taps slopesOn(int face, double x, double& left) HAPTICS_RT {
  left = face < 0 ? 1.0 : face > 0 ? -1.0 : 0.0;
  if (face == 0) return slopes(x);
  Taps result = face < 0 ? kLowFace : kHighFace;
  for (double& w : result) w *= left;
  return result;
}

double dot(const Taps& w, const double* v) HAPTICS_RT {
  return w[0] * v[0] + w[1] * v[1] + w[2] * v[2] + w[3] * v[3];
}

/// Index i mirrored at the first and the last voxel; one voxel is its own mirror.
std::int64_t mirrored(std::int64_t i, std::int64_t first, std::int64_t last) HAPTICS_RT {
  if (i < first) i = 2 * first - i;
  if (i > last) i = 2 * last - i;
  return std::clamp(i, first, last);
}

template <class T>
void fetch(const T* voxels, const Grid& grid, const VoxelBox& box, SplineCell& cell) HAPTICS_RT {
  const std::int64_t row = grid.dims[0], slice = grid.dims[0] * grid.dims[1];
  const auto [i, j, k] = cell.at;
  double* out = cell.voxel.data();
  if (i > box.first[0] && j > box.first[1] && k > box.first[2] && i + 2 < box.end[0] &&
      j + 2 < box.end[1] && k + 2 < box.end[2]) {
    const T* corner = voxels + (k - 1) * slice + (j - 1) * row + (i - 1);
    for (int z = 0; z < 4; ++z)
      for (int y = 0; y < 4; ++y, out += 4) {
        const T* v = corner + z * slice + y * row;
        for (int x = 0; x < 4; ++x) out[x] = double(v[x]);
      }
    return;
  }
  std::array<std::array<std::int64_t, 4>, 3> index;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int tap = 0; tap < 4; ++tap)
      index[axis][static_cast<std::size_t>(tap)] =
          mirrored(cell.at[axis] - 1 + tap, box.first[axis], box.end[axis] - 1);
  for (const std::int64_t z : index[2])
    for (const std::int64_t y : index[1])
      for (const std::int64_t x : index[0]) *out++ = double(voxels[z * slice + y * row + x]);
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
    cell.voxel.fill(volume.least);
  else
    visitVoxels(volume.type, volume.voxels.get(),
                [&](const auto* voxels) { fetch(voxels, volume.grid, bounds, cell); });
  return cell;
}

double SplineCell::greatest() const HAPTICS_RT {
  double top = background;
  for (const double v : voxel) top = std::max(top, v);
  return top;
}

double SplineCell::value(const Vec3& u) const HAPTICS_RT {
  if (beyond) return background;
  std::array<Weights, 3> axis;
  for (int a = 0; a < 3; ++a) {
    const double x = u[a] - double(at[static_cast<std::size_t>(a)]);
    axis[static_cast<std::size_t>(a)] = weightsOn(face[static_cast<std::size_t>(a)], x, x, x);
  }
  double sum = 0.0;
  const double* v = voxel.data();
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 4; ++j, v += 4)
      sum += axis[2].w[k] * axis[1].w[j] * dot(axis[0].w, v);
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
    axis[n] = weightsOn(face[n], x, x, x);
    slope[n] = slopesOn(face[n], x, fall[a]);
  }
  double sum = 0.0;
  const double* v = voxel.data();
  for (std::size_t k = 0; k < 4; ++k) {
    double value_k = 0.0, dx_k = 0.0, dy_k = 0.0;
    for (std::size_t j = 0; j < 4; ++j, v += 4) {
      const double value_j = dot(axis[0].w, v);
      value_k += axis[1].w[j] * value_j;
      dy_k += slope[1][j] * value_j;
      dx_k += axis[1].w[j] * dot(slope[0], v);
    }
    sum += axis[2].w[k] * value_k;
    gradient += Vec3{axis[2].w[k] * dx_k, axis[2].w[k] * dy_k, slope[2][k] * value_k};
  }
  const double left = axis[0].left * axis[1].left * axis[2].left;
  if (left == 1.0 && fall.isZero(0.0)) return sum;
  gradient -= background * Vec3{fall.x() * axis[1].left * axis[2].left,
                                fall.y() * axis[0].left * axis[2].left,
                                fall.z() * axis[0].left * axis[1].left};
  return sum + (1.0 - left) * background;
}

SplineCell::Along SplineCell::alongSegment(const Vec3& a, const Vec3& b) const HAPTICS_RT {
  Along along;
  along.fill(background);
  if (beyond) return along;
  // the weights of each axis as cubics in the parameter: Bernstein coefficients times binomials
  constexpr Taps kBinomial{1.0, 3.0, 3.0, 1.0};
  constexpr Along kNinth{1.0, 9.0, 36.0, 84.0, 126.0, 126.0, 84.0, 36.0, 9.0, 1.0};
  std::array<std::array<Taps, 4>, 3> weight;  // [axis][tap][coefficient]
  std::array<Taps, 3> left;                   // [axis][coefficient]
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int n = static_cast<int>(axis);
    const double from = a[n] - double(at[axis]), to = b[n] - double(at[axis]);
    const Weights at_coefficient[4] = {
        weightsOn(face[axis], from, from, from), weightsOn(face[axis], from, from, to),
        weightsOn(face[axis], from, to, to), weightsOn(face[axis], to, to, to)};
    for (std::size_t c = 0; c < 4; ++c) {
      left[axis][c] = at_coefficient[c].left * kBinomial[c];
      for (std::size_t tap = 0; tap < 4; ++tap)
        weight[axis][tap][c] = at_coefficient[c].w[tap] * kBinomial[c];
    }
  }
  along.fill(0.0);
  const double* v = voxel.data();
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<double, 7> plane{};
    for (std::size_t j = 0; j < 4; ++j, v += 4) {
      Taps line{};
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t c = 0; c < 4; ++c) line[c] += v[i] * weight[0][i][c];
      addProduct(line, weight[1][j], plane);
    }
    addProduct(plane, weight[2][k], along);
  }
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
