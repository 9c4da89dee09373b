// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/projection.h"

#include <algorithm>
#include <cmath>

#include "app/study/accuracy/work_precision.h"
#include "app/study/reference/projection.h"
#include "datasets/phantoms/making.h"
#include "haptics/core/budget.h"

namespace study::accuracy {
namespace {

using datasets::Random;
using haptics::Mat3;
using haptics::MotionRow;
using haptics::Twist;
using haptics::Vec3;
using Real = long double;
using Vector = Eigen::Matrix<Real, 6, 1>;
using Rows = Eigen::Matrix<Real, Eigen::Dynamic, 6>;

constexpr double kReach = 0.03;  // m: size of the made tools

Twist someTwist(Random& random, double size) {
  return {size * random.in(0.0, 1.0) * random.direction(),
          size / kReach * random.in(0.0, 1.0) * random.direction()};
}

ProjectionProblem someProblem(Random& random, int count, bool coplanar) {
  ProjectionProblem p;
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.push_back(Vec3{1, 0.3, 0.5}.cwiseProduct(random.box(kReach)));
  p.metric = haptics::MassMetric{haptics::makeShell(points)->inertia};
  p.R_WP = random.rotation().toRotationMatrix();
  p.free = someTwist(random, 5e-3);
  const Vec3 n = random.direction();
  if (coplanar) p.free.linear -= 4e-3 * n;
  // rooms with which a common motion is allowed: some must leave, some may approach
  const Twist some = someTwist(random, 5e-4);
  for (int i = 0; i < count; ++i) {
    MotionRow row{coplanar ? (n + 1e-2 * random.direction()).normalized() : random.direction(),
                  random.box(kReach), 0.0};
    row.room = random.in(0.0, 3e-4) - row.n_W.dot(some.linear + some.angular.cross(row.r_W));
    p.rows.push_back(row);
  }
  return p;
}

/// The problem in whitened coordinates, in long double: nearest y to y_free with A y >= b.
struct Whitened {
  Rows A;
  Eigen::Matrix<Real, Eigen::Dynamic, 1> b;
  Vector y_free;
  Eigen::Matrix<Real, 3, 3> back;  // from y's lower half to the turn
};

Whitened whitened(const ProjectionProblem& p) {
  using Mat = Eigen::Matrix<Real, 3, 3>;
  // I0 = L L^T by itself, not by the product's own factor
  const Mat L = p.metric.inertia().cast<Real>().llt().matrixL();
  const Mat R = p.R_WP.cast<Real>();
  const auto n = static_cast<Eigen::Index>(p.rows.size());
  Whitened w{Rows(n, 6), Eigen::Matrix<Real, Eigen::Dynamic, 1>(n), {}, {}};
  w.back = R * L.transpose().inverse();
  const Mat inverse = w.back.inverse();
  w.y_free.head<3>() = p.free.linear.cast<Real>();
  w.y_free.tail<3>() = inverse * p.free.angular.cast<Real>();
  for (Eigen::Index i = 0; i < n; ++i) {
    const MotionRow& row = p.rows[static_cast<std::size_t>(i)];
    const Eigen::Matrix<Real, 3, 1> normal = row.n_W.cast<Real>(),
                                    moment = row.r_W.cast<Real>().cross(normal);
    w.A.row(i).head<3>() = normal.transpose();
    w.A.row(i).tail<3>() = (w.back.transpose() * moment).transpose();
    w.b[i] = -Real(row.room);
  }
  return w;
}

Vector whitenedTwist(const Whitened& w, const Twist& V) {
  Vector y;
  y.head<3>() = V.linear.cast<Real>();
  y.tail<3>() = w.back.inverse() * V.angular.cast<Real>();
  return y;
}

}  // namespace

Twist byEnumeration(const ProjectionProblem& problem) {
  const Whitened w = whitened(problem);
  const int n = static_cast<int>(problem.rows.size());
  Vector best = Vector::Zero();
  Real least = INFINITY;
  std::vector<int> set;
  // the nearest point on the rows of a set, met with equality, if all rows allow it
  const auto attempt = [&] {
    Vector y = w.y_free;
    if (!set.empty()) {
      const auto k = static_cast<Eigen::Index>(set.size());
      Rows A(k, 6);
      Eigen::Matrix<Real, Eigen::Dynamic, 1> b(k);
      for (Eigen::Index i = 0; i < k; ++i) {
        A.row(i) = w.A.row(set[static_cast<std::size_t>(i)]);
        b[i] = w.b[set[static_cast<std::size_t>(i)]];
      }
      y += A.completeOrthogonalDecomposition().solve(
          (b - A * w.y_free).eval());  // the shortest way to them
      if (((A * y - b).array().abs() > 1e-14L).any()) return;
    }
    if (((w.A * y - w.b).array() < -1e-15L).any()) return;
    const Real distance = (y - w.y_free).squaredNorm();
    if (distance < least) {
      least = distance;
      best = y;
    }
  };
  const std::function<void(int)> from = [&](int first) {
    attempt();
    if (set.size() == 6) return;
    for (int i = first; i < n; ++i) {
      set.push_back(i);
      from(i + 1);
      set.pop_back();
    }
  };
  from(0);
  return {best.head<3>().cast<double>(), (w.back * best.tail<3>()).cast<double>()};
}

std::vector<Solver> solvers() {
  return {{"ours (Goldfarb-Idnani)",
           [](const ProjectionProblem& p, std::int64_t& pivots) {
             const auto motion = haptics::constrainedMotion(p.free, p.rows, p.metric, p.R_WP);
             pivots += motion.pivots;
             return motion.twist;
           }},
          {"reference (non-negative least squares)",
           [](const ProjectionProblem& p, std::int64_t& pivots) {
             std::vector<reference::Row> rows;
             for (const MotionRow& row : p.rows) rows.push_back({row.n_W, row.r_W, -row.room});
             const Mat3 inertia_W = p.R_WP * p.metric.inertia() * p.R_WP.transpose();
             return reference::constrainedMotion(p.free, rows, {1.0, inertia_W}, &pivots);
           }}};
}

Outcome projections(const std::vector<Solver>& all, int rows, bool coplanar, int count,
                    unsigned seed) {
  Outcome outcome;
  const std::string what = std::string{coplanar ? "nearly coplanar" : "general"};
  WorkPrecision work{"Projection onto " + std::to_string(rows) + " " + what + " contacts",
                     "Distance in the mass metric from the answer by enumeration, relative to the "
                     "free motion, against time.",
                     "CPU of a projection [us]", "relative error"};
  for (const Solver& solver : all)
    work.points.push_back({solver.name,
                           std::to_string(rows) + " rows",
                           {},
                           {},
                           comparison::MeanCounts{NAN, NAN, 0.0, NAN}});
  Random random{seed};
  double slowed = 0.0;
  for (int n = 0; n < count; ++n) {
    const ProjectionProblem problem = someProblem(random, rows, coplanar);
    const Whitened w = whitened(problem);
    const Vector exact = whitenedTwist(w, byEnumeration(problem));
    slowed += (exact - w.y_free).norm() > 1e-9L;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::int64_t begun = haptics::Budget::threadTime();
      std::int64_t pivots = 0;
      const Twist answer = all[k].solve(problem, pivots);
      work.points[k].cost.push_back(1e-3 * double(haptics::Budget::threadTime() - begun));
      work.points[k].counts->pivots += double(pivots) / count;
      work.points[k].error.push_back(
          double((whitenedTwist(w, answer) - exact).norm() / w.y_free.norm()));
    }
  }
  double worst = 0.0;
  for (const double error : work.points.front().error) worst = worse(worst, error);
  outcome.cases.push_back({"projection onto " + std::to_string(rows) + " " + what + " contacts",
                           worst, 1e-13, "", Case::Sense::AtMost,
                           "Relative to the free motion. Rounding, 1e-16, times what whitening and "
                           "normals a hundredth apart may do to it; measured: 2e-14."});
  outcome.cases.push_back(
      {"projections onto " + std::to_string(rows) + " " + what + " contacts that bear",
       slowed / count, 0.3, "of all", Case::Sense::AtLeast,
       "Else the one above would say nothing."});
  addTo(outcome, work);
  return outcome;
}

}  // namespace study::accuracy
