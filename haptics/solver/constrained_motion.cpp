// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/solver/constrained_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/solver/row_lanes.h"

namespace haptics {
namespace {

using row_lanes::Rows;

// units of Budget, of some 10 ns: of a call, of two rows, and of a pivot with its search over all
// rows
constexpr std::int64_t kCallWork = 5, kTwoRowsWork = 1, kPivotWork = 18;

/// Rows that may enter or leave the active set before a solution is given up. More than 40 were
/// never seen (haptics/MEASURED.md, "Projection").
constexpr int kMostPivots = 128;

Vector6 rowOf(const Rows& rows, int i) HAPTICS_RT {
  Vector6 a;
  for (int c = 0; c < 6; ++c) a[c] = rows.a[c][i];
  return a;
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A row split by the active rows: its part outside their span, its coordinates in their basis, and
/// the coefficients with which they make up the part inside.
struct Split {
  Vector6 z, inside, r;
};

/// The active rows, an orthonormal basis of their span, and their multipliers. What lies beyond
/// `count` is zero, so that all loops are of six and none has to be predicted.
struct ActiveSet {
  std::array<int, 6> row{};
  Vector6 multiplier = Vector6::Zero();
  int count = 0;
  Matrix6 Q = Matrix6::Zero();  ///< basis, by columns
  Matrix6 R;                    ///< a_j = Q R e_j; of it only what is above the diagonal, and that
  Matrix6 N = Matrix6::Zero();  ///< R^-1

  /// Twice Gram-Schmidt: orthogonal to rounding even for nearly dependent rows.
  Split split(const Vector6& a) const HAPTICS_RT {
    if (count == 0) return {a, Vector6::Zero(), Vector6::Zero()};
    Split s;
    s.inside.noalias() = Q.transpose() * a;
    s.z = a;
    s.z.noalias() -= Q * s.inside;
    const Vector6 again = Q.transpose() * s.z;
    s.z.noalias() -= Q * again;
    s.inside += again;
    s.r.noalias() = N * s.inside;
    return s;
  }
  void append(const Split& split, double size, int i, double u) HAPTICS_RT {
    R.col(count) = split.inside;
    R(count, count) = size;
    N.col(count) = -split.r / size;
    N(count, count) = 1.0 / size;
    Q.col(count) = split.z / size;
    row[static_cast<std::size_t>(count)] = i;
    multiplier[count] = u;
    ++count;
  }
  /// The rows before row k keep their part of the basis; those behind it are appended again.
  void drop(const Rows& rows, int k) HAPTICS_RT {
    const std::array<int, 6> old_row = row;
    const Vector6 old_multiplier = multiplier;
    const int old_count = count;
    count = k;
    for (int j = k; j < old_count; ++j) {
      Q.col(j).setZero();
      N.col(j).setZero();
      multiplier[j] = 0.0;
    }
    for (int j = k + 1; j < old_count; ++j) {
      const int i = old_row[static_cast<std::size_t>(j)];
      const Split again = split(rowOf(rows, i));
      append(again, again.z.norm(), i, old_multiplier[j]);
    }
  }
};

/// Goldfarb and Idnani's dual method for min |y - free|² under the rows, of which `greatest` is the
/// greatest |b|. Returns false if the rows contradict each other (or, never seen, if it does not
/// settle).
bool solve(const Vector6& free, const Rows& rows, double greatest, Vector6& y,
           ConstrainedMotion& result) HAPTICS_RT {
  constexpr double kDependent = 1e-10;  // |part outside the span| of a unit row
  constexpr double kForEver = std::numeric_limits<double>::infinity();
  const double tolerance = 1e-13 * std::max(free.norm(), greatest);

  // those that are not active
  alignas(64) std::array<double, row_lanes::kMostRows> b;
  std::copy_n(rows.b, rows.count, b.begin());
  ActiveSet set;
  y = free;
  int left = kMostPivots;
  for (;;) {
    const int worst = row_lanes::mostViolated(rows, b.data(), y.data(), tolerance);
    if (worst < 0) break;
    const Vector6 a = rowOf(rows, worst);
    double u = 0.0;
    for (bool entered = false; !entered;) {
      if (left-- == 0) return false;
      const Split split = set.split(a);
      // as far as the multipliers of the active rows stay pushing
      double partial = kForEver;
      int leaving = -1;
      for (int j = 0; j < 6; ++j) {
        const double ratio = set.multiplier[j] / split.r[j];
        const bool sooner = (split.r[j] > 1e-14) & (ratio < partial);
        partial = sooner ? ratio : partial;
        leaving = sooner ? j : leaving;
      }
      const double zz = split.z.squaredNorm();
      const double slack = a.dot(y) - rows.b[worst];
      const bool independent = set.count < 6 && zz > kDependent * kDependent;
      const double full = independent ? -slack / zz : kForEver;
      const double t = std::min(partial, full);
      if (!std::isfinite(t)) return false;
      set.multiplier = (set.multiplier - t * split.r).cwiseMax(0.0);
      u += t;
      ++result.pivots;
      if (independent) y += t * split.z;
      entered = t == full;
      if (entered) {
        set.append(split, std::sqrt(zz), worst, u);
        b[static_cast<std::size_t>(worst)] = -kForEver;
      } else {
        const int row = set.row[static_cast<std::size_t>(leaving)];
        b[static_cast<std::size_t>(row)] = rows.b[row];
        set.drop(rows, leaving);
      }
    }
  }

  // once more from the multipliers' own rows, without what the steps accumulated
  if (set.count > 0) {
    Vector6 c = Vector6::Zero();
    for (int j = 0; j < set.count; ++j) {
      const int row = set.row[static_cast<std::size_t>(j)];
      double rest = rows.b[row] - rowOf(rows, row).dot(free);
      for (int i = 0; i < j; ++i) rest -= set.R(i, j) * c[i];
      c[j] = rest / set.R(j, j);
    }
    y = free;
    for (int j = 0; j < set.count; ++j) y += c[j] * set.Q.col(j);
  }
  result.active = set.count;
  for (int j = 0; j < set.count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    result.bearing[at] = set.row[at];
    result.reaction[at] = set.multiplier[j] / rows.size[set.row[at]];
  }
  return true;
}

/// Whitens the rows; returns the greatest |b|.
double whitened(std::span<const MotionRow> rows, const MassMetric& metric, const Mat3& R_WP,
                Rows& result) HAPTICS_RT {
  const int count = static_cast<int>(rows.size());
  result.count = (count + row_lanes::kWidest - 1) / row_lanes::kWidest * row_lanes::kWidest;
  for (int i = 0; i < result.count; ++i) {
    // what fills up the last vector has no direction
    static const MotionRow kNone{Vec3::Zero(), Vec3::Zero(), 0.0};
    const MotionRow& row = i < count ? rows[static_cast<std::size_t>(i)] : kNone;
    for (int c = 0; c < 3; ++c) {
      result.a[c][i] = row.n_W[c];
      result.a[3 + c][i] = row.r_W[c];
    }
    result.b[i] = row.room;
  }
  row_lanes::RowMap map;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      map.turn[i][j] = R_WP(j, i);
      map.shape[i][j] = metric.shape()(i, j);
    }
  return row_lanes::whiten(map, result);
}

}  // namespace

ConstrainedMotion constrainedMotion(const Twist& free, std::span<const MotionRow> rows,
                                    const MassMetric& metric, const Mat3& R_WP) HAPTICS_RT {
  ConstrainedMotion result;
  const Vector6 y_free = metric.whitened(free, R_WP);
  rows = rows.first(std::min<std::size_t>(rows.size(), row_lanes::kMostRows));
  Rows all;
  double greatest = whitened(rows, metric, R_WP, all);

  Vector6 y = y_free;
  bool solved = solve(y_free, all, greatest, y, result);
  const auto pushes = [](const MotionRow& row) HAPTICS_RT { return row.room < 0.0; };
  if (!solved && std::any_of(rows.begin(), rows.end(), pushes)) {
    // a slit narrower than two rest gaps: no row may push, none may be approached further
    result.status = ConstrainedMotion::Status::Relaxed;
    greatest = 0.0;
    for (int i = 0; i < all.count; ++i) {
      all.b[i] = std::min(all.b[i], 0.0);
      if (std::isfinite(all.b[i])) greatest = std::max(greatest, -all.b[i]);
    }
    solved = solve(y_free, all, greatest, y, result);
  }
  result.work =
      kCallWork + kTwoRowsWork * (all.count / 2) + kPivotWork * std::int64_t{result.pivots};
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
