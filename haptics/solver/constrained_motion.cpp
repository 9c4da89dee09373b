// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/solver/constrained_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace haptics {
namespace {

constexpr std::size_t kMostRows = 96;

/// Rows in whitened coordinates, normalised: a·y >= b.
struct Rows {
  std::array<Vector6, kMostRows> a;
  std::array<double, kMostRows> b;
  std::array<double, kMostRows> size;  ///< before they were normalised
  std::array<int, kMostRows> index;    ///< among the rows that were given
  int count = 0;
};

/// The active rows, an orthonormal basis of their span, and their multipliers.
struct ActiveSet {
  std::array<int, 6> row{};
  std::array<double, 6> multiplier{};
  int count = 0;
  Eigen::Matrix<double, 6, 6> Q = Eigen::Matrix<double, 6, 6>::Zero();  ///< basis, by columns
  Eigen::Matrix<double, 6, 6> R = Eigen::Matrix<double, 6, 6>::Zero();  ///< a_j = Q R e_j

  /// Splits a into its part outside the span (returned) and its coordinates in the basis. Twice
  /// Gram-Schmidt: orthogonal to rounding even for nearly dependent rows.
  Vector6 outside(const Vector6& a, Vector6& inside) const HAPTICS_RT {
    inside.setZero();
    Vector6 z = a;
    for (int pass = 0; pass < 2; ++pass)
      for (int j = 0; j < count; ++j) {
        const double c = Q.col(j).dot(z);
        z -= c * Q.col(j);
        inside[j] += c;
      }
    return z;
  }
  /// Coefficients r with sum r_j a_j = the part inside the span.
  Vector6 solved(const Vector6& inside) const HAPTICS_RT {
    Vector6 r = Vector6::Zero();
    for (int j = count - 1; j >= 0; --j) {
      double rest = inside[j];
      for (int i = j + 1; i < count; ++i) rest -= R(j, i) * r[i];
      r[j] = rest / R(j, j);
    }
    return r;
  }
  void append(const Rows& rows, int i, double u) HAPTICS_RT {
    Vector6 inside;
    const Vector6 z = outside(rows.a[i], inside);
    const double size = z.norm();
    R.col(count) = inside;
    R(count, count) = size;
    Q.col(count) = z / size;
    row[count] = i;
    multiplier[count] = u;
    ++count;
  }
  void drop(const Rows& rows, int k) HAPTICS_RT {
    const std::array<int, 6> old_row = row;
    const std::array<double, 6> old_multiplier = multiplier;
    const int old_count = count;
    count = 0;
    for (int j = 0; j < old_count; ++j)
      if (j != k) append(rows, old_row[j], old_multiplier[j]);
  }
};

/// Goldfarb and Idnani's dual method for min |y - free|² under the rows. Returns false if the
/// rows contradict each other (or, never seen, if it does not settle).
bool solve(const Vector6& free, const Rows& rows, Vector6& y,
           ConstrainedMotion& result) HAPTICS_RT {
  constexpr double kDependent = 1e-10;  // |part outside the span| of a unit row
  double scale = free.norm();
  for (int i = 0; i < rows.count; ++i) scale = std::max(scale, std::abs(rows.b[i]));
  const double tolerance = 1e-13 * scale;

  ActiveSet set;
  y = free;
  for (int round = 0; round < 4 * static_cast<int>(kMostRows); ++round) {
    // the row that is violated most
    int worst = -1;
    double violation = -tolerance;
    for (int i = 0; i < rows.count; ++i) {
      const double slack = rows.a[i].dot(y) - rows.b[i];
      if (slack < violation) {
        bool already = false;
        for (int j = 0; j < set.count; ++j) already = already || set.row[j] == i;
        if (already) continue;
        violation = slack;
        worst = i;
      }
    }
    if (worst < 0) {
      // once more from the multipliers' own rows, without what the steps accumulated
      if (set.count > 0) {
        Vector6 c = Vector6::Zero();
        for (int j = 0; j < set.count; ++j) {
          double rest = rows.b[set.row[j]] - rows.a[set.row[j]].dot(free);
          for (int i = 0; i < j; ++i) rest -= set.R(i, j) * c[i];
          c[j] = rest / set.R(j, j);
        }
        y = free;
        for (int j = 0; j < set.count; ++j) y += c[j] * set.Q.col(j);
      }
      result.active = set.count;
      for (int j = 0; j < set.count; ++j) {
        const auto at = static_cast<std::size_t>(j);
        result.bearing[at] = rows.index[set.row[j]];
        result.reaction[at] = set.multiplier[j] / rows.size[set.row[j]];
      }
      return true;
    }

    double u = 0.0;
    for (int step = 0; step < 64; ++step) {
      Vector6 inside;
      const Vector6 z = set.count < 6 ? set.outside(rows.a[worst], inside)
                                      : (set.outside(rows.a[worst], inside), Vector6::Zero());
      const Vector6 r = set.solved(inside);
      // as far as the multipliers of the active rows stay pushing
      double partial = std::numeric_limits<double>::infinity();
      int leaving = -1;
      for (int j = 0; j < set.count; ++j)
        if (r[j] > 1e-14 && set.multiplier[j] / r[j] < partial) {
          partial = set.multiplier[j] / r[j];
          leaving = j;
        }
      const double zz = z.squaredNorm();
      const double slack = rows.a[worst].dot(y) - rows.b[worst];
      const double full =
          zz > kDependent * kDependent ? -slack / zz : std::numeric_limits<double>::infinity();
      const double t = std::min(partial, full);
      if (!std::isfinite(t)) return false;
      for (int j = 0; j < set.count; ++j)
        set.multiplier[j] = std::max(0.0, set.multiplier[j] - t * r[j]);
      u += t;
      ++result.pivots;
      if (std::isfinite(full)) y += t * z;
      if (t == full) {
        set.append(rows, worst, u);
        break;
      }
      set.drop(rows, leaving);
      if (step == 63) return false;
    }
  }
  return false;
}

}  // namespace

ConstrainedMotion constrainedMotion(const Twist& free, std::span<const MotionRow> rows,
                                    const MassMetric& metric, const Mat3& R_WP) HAPTICS_RT {
  ConstrainedMotion result;
  const Vector6 y_free = metric.whitened(free, R_WP);
  Rows whitened;
  bool pushes = false;
  for (std::size_t i = 0; i < std::min(rows.size(), kMostRows); ++i) {
    const MotionRow& row = rows[i];
    const Vector6 a = metric.row(row.n_W, row.r_W, R_WP);
    const double size = a.norm();
    if (!(size > 0.0)) continue;
    whitened.a[whitened.count] = a / size;
    whitened.b[whitened.count] = -row.room / size;
    whitened.size[whitened.count] = size;
    whitened.index[whitened.count] = static_cast<int>(i);
    pushes = pushes || row.room < 0.0;
    ++whitened.count;
  }

  Vector6 y = y_free;
  bool solved = solve(y_free, whitened, y, result);
  if (!solved && pushes) {
    // a slit narrower than two rest gaps: no row may push, none may be approached further
    result.status = ConstrainedMotion::Status::Relaxed;
    for (int i = 0; i < whitened.count; ++i) whitened.b[i] = std::min(whitened.b[i], 0.0);
    solved = solve(y_free, whitened, y, result);
  }
  if (!solved || !y.allFinite()) {
    result.status = ConstrainedMotion::Status::Infeasible;
    result.active = 0;
    return result;
  }
  result.whitened = y;
  result.twist = result.active == 0 ? free : metric.twist(y, R_WP);
  return result;
}

}  // namespace haptics
