// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/solver/friction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/core/fixed_vector.h"

namespace haptics {
namespace {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

constexpr std::size_t kMostBearing = 12;  // six at first, and what friction tips the tool onto
constexpr int kSweeps = 60;
constexpr int kRounds = 4;
constexpr std::int64_t kBearingWork = 6;  // of one bearing in one sweep
constexpr double kConverged = 1e-5;  // of the free motion: change in a sweep that ends the sweeps
constexpr double kSettled = 1e-6;    // of its square: work that counts as none

/// A row that bears, in whitened coordinates, with its reactions.
struct BearingRow {
  int row = 0;
  double room = 0.0;
  Vector6 n, t1, t2;
  double nn = 0.0;                 ///< n·n: how much a unit normal reaction moves the point
  Mat2 tt = Mat2::Zero();          ///< the same along the surface
  double normal = 0.0;             ///< reaction, >= 0
  Vec2 tangential = Vec2::Zero();  ///< at most mu times that
};
using Bearings = FixedVector<BearingRow, kMostBearing>;

BearingRow bearingOf(int index, const MotionRow& row, const MassMetric& metric,
                     const Mat3& R_WP) HAPTICS_RT {
  BearingRow b;
  b.row = index;
  b.room = row.room;
  const Vec3 t1 = row.n_W.unitOrthogonal();
  b.n = metric.row(row.n_W, row.r_W, R_WP);
  b.t1 = metric.row(t1, row.r_W, R_WP);
  b.t2 = metric.row(row.n_W.cross(t1), row.r_W, R_WP);
  b.nn = b.n.squaredNorm();
  b.tt << b.t1.squaredNorm(), b.t1.dot(b.t2), b.t1.dot(b.t2), b.t2.squaredNorm();
  return b;
}

/// The f with |f| <= radius that makes A f + g vanish, or slide against f: the minimum of
/// 1/2 f·A f + g·f over a disc. A is symmetric and positive definite.
Vec2 reactionInDisc(const Mat2& A, const Vec2& g, double radius) HAPTICS_RT {
  if (!(radius > 0.0)) return Vec2::Zero();
  const Vec2 sticking = -A.inverse() * g;
  if (sticking.squaredNorm() <= radius * radius) return sticking;
  // (A + s 1) f = -g with |f| = radius: 1 / |f| is nearly linear in s, so Newton on it converges
  double s = 0.0;
  Vec2 f = sticking;
  for (int step = 0; step < 20; ++step) {
    const Mat2 B = (A + s * Mat2::Identity()).inverse();
    f = -B * g;
    const double size = f.norm();
    if (std::abs(size - radius) <= 1e-12 * radius) break;
    const double rate = f.dot(B * f) / size;  // -d|f|/ds
    s = std::max(0.0, s + (size - radius) / rate * (size / radius));
  }
  return f * (radius / f.norm());
}

/// Sweeps until the motion y settles: every bearing in turn gets the reactions that its own point
/// asks for.
void sweepBearings(Bearings& bearings, double mu, double scale, Vector6& y,
                   Budget& budget) HAPTICS_RT {
  for (int sweep = 0; sweep < kSweeps && budget.left(); ++sweep) {
    double change = 0.0;
    budget.spend(kBearingWork * static_cast<std::int64_t>(bearings.size()));
    for (BearingRow& b : bearings) {
      const double normal = std::max(0.0, b.normal - (b.n.dot(y) + b.room) / b.nn);
      y += (normal - b.normal) * b.n;
      change = std::max(change, std::abs(normal - b.normal) * std::sqrt(b.nn));
      b.normal = normal;
      const Vec2 slip{b.t1.dot(y), b.t2.dot(y)};
      const Vec2 tangential = reactionInDisc(b.tt, slip - b.tt * b.tangential, mu * normal);
      const Vec2 more = tangential - b.tangential;
      y += more.x() * b.t1 + more.y() * b.t2;
      change = std::max(change, more.norm() * std::sqrt(b.tt.trace()));
      b.tangential = tangential;
    }
    if (change <= kConverged * scale) return;
  }
}

double workOf(const BearingRow& b, const Vector6& y) HAPTICS_RT {
  return b.tangential.dot(Vec2{b.t1.dot(y), b.t2.dot(y)});
}

/// The motion nearest to y at which no friction drives its point: those points rest, and every
/// bearing keeps its motion along its normal.
Vector6 rested(const Bearings& bearings, const Vector6& y) HAPTICS_RT {
  Vector6 result = y;
  FixedVector<Vector6, 6> basis;
  const auto require = [&](const Vector6& a, double target) {
    Vector6 z = a;
    for (int pass = 0; pass < 2; ++pass)
      for (const Vector6& q : basis) z -= q.dot(z) * q;
    const double size = z.norm();
    if (size <= 1e-8 * a.norm() || basis.full()) return;
    const Vector6 q = z / size;
    // q is across all that was required before
    result += (target - a.dot(result)) / size * q;
    basis.push(q);
  };
  for (const BearingRow& b : bearings) require(b.n, b.n.dot(y));
  for (const BearingRow& b : bearings)
    if (workOf(b, y) > 0.0) {
      require(b.t1, 0.0);
      require(b.t2, 0.0);
    }
  return result;
}

}  // namespace

ConstrainedMotion withFriction(const Twist& free, std::span<const MotionRow> rows,
                               const MassMetric& metric, const Mat3& R_WP, double mu,
                               const ConstrainedMotion& frictionless, Budget& budget) HAPTICS_RT {
  if (!(mu > 0.0) || frictionless.active == 0) return frictionless;
  const Vector6 y_free = metric.whitened(free, R_WP);
  const double scale = y_free.norm();
  Bearings bearings;
  const auto bear = [&](const ConstrainedMotion& motion) {
    bool added = false;
    for (int j = 0; j < motion.active; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const int row = motion.bearing[at];
      const auto same = std::find_if(bearings.begin(), bearings.end(),
                                     [&](const BearingRow& b) { return b.row == row; });
      if (same != bearings.end()) continue;
      BearingRow b = bearingOf(row, rows[static_cast<std::size_t>(row)], metric, R_WP);
      // rows that contradict each other may not push
      if (motion.status == ConstrainedMotion::Status::Relaxed) b.room = std::max(b.room, 0.0);
      b.normal = motion.reaction[at];
      added = bearings.push(b) || added;
    }
    return added;
  };
  bear(frictionless);

  ConstrainedMotion held;
  for (int round = 0; round < kRounds; ++round) {
    Vector6 y = y_free;
    for (const BearingRow& b : bearings)
      y += b.normal * b.n + b.tangential.x() * b.t1 + b.tangential.y() * b.t2;
    sweepBearings(bearings, mu, scale, y, budget);

    // with this friction the normal problem is exact again, and over all rows
    Vector6 y_held = y_free;
    for (const BearingRow& b : bearings)
      y_held += b.tangential.x() * b.t1 + b.tangential.y() * b.t2;
    held = constrainedMotion(metric.twist(y_held, R_WP), rows, metric, R_WP);
    budget.counts.pivots += held.pivots;
    budget.spend(held.work);
    if (held.status == ConstrainedMotion::Status::Infeasible) return frictionless;
    if (!bear(held)) break;
  }

  // what friction does to the motion must be work against it
  double work = 0.0;
  for (const BearingRow& b : bearings) work += workOf(b, held.whitened);
  if (work <= kSettled * scale * scale) return held;
  const Vector6 y = rested(bearings, held.whitened);
  bool allowed = y.dot(y_free - y) >= 0.0;
  for (const MotionRow& row : rows) {
    const Vector6 a = metric.row(row.n_W, row.r_W, R_WP);
    allowed = allowed && a.dot(y) >= -std::max(row.room, 0.0) - 1e-9 * scale * a.norm();
  }
  if (allowed) {
    held.whitened = y;
    held.twist = metric.twist(y, R_WP);
    return held;
  }
  held.twist = {};
  held.whitened.setZero();
  return held;
}

}  // namespace haptics
