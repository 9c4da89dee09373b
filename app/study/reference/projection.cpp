// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/reference/projection.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace reference {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Columns = Eigen::Matrix<double, 7, Eigen::Dynamic>;
using Vec7 = Eigen::Matrix<double, 7, 1>;

/// Least squares on the chosen columns: u_chosen, the others 0.
Eigen::VectorXd leastSquares(const Columns& E, const Vec7& e, const std::vector<int>& chosen) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(E.cols());
  if (chosen.empty()) return u;
  const Columns part = E(Eigen::all, chosen);
  u(chosen) = part.colPivHouseholderQr().solve(e);
  return u;
}

/// argmin |E u - e| over u >= 0, by an active set: columns enter one at a time where the residual
/// says it would shrink, and leave when their share would turn negative.
Eigen::VectorXd nonNegativeLeastSquares(const Columns& E, const Vec7& e, std::int64_t& pivots) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(E.cols());
  std::vector<int> chosen;
  std::vector<char> barred(static_cast<std::size_t>(E.cols()), 0);
  const double tiny = 1e-14;
  for (Eigen::Index step = 0; step < 30 * E.cols() + 60; ++step) {
    // the column that promises most; one that proved to lie in the span of the others is barred
    // until the residual has changed
    const Eigen::VectorXd promise = E.transpose() * (e - E * u);
    int entering = -1;
    for (int j = 0; j < E.cols(); ++j) {
      const bool in = std::find(chosen.begin(), chosen.end(), j) != chosen.end();
      if (in || barred[j] || promise[j] <= tiny * E.col(j).norm()) continue;
      if (entering < 0 || promise[j] > promise[entering]) entering = j;
    }
    if (entering < 0) break;
    chosen.push_back(entering);
    ++pivots;

    bool entered = true;
    for (;;) {
      const Eigen::VectorXd wish = leastSquares(E, e, chosen);
      if (entered && wish[entering] <= 0.0) {
        // rounding promised what arithmetic does not keep
        chosen.pop_back();
        ++pivots;
        barred[entering] = 1;
        break;
      }
      // go towards the wish until a share reaches zero, and let that column leave
      double share = 1.0;
      for (const int j : chosen)
        if (wish[j] <= 0.0) share = std::min(share, u[j] / (u[j] - wish[j]));
      u += share * (wish - u);
      if (entered) std::fill(barred.begin(), barred.end(), 0);
      entered = false;
      if (share == 1.0) break;
      pivots += std::ssize(chosen);
      std::erase_if(chosen, [&](int j) {
        if (u[j] > 1e-300 && !(wish[j] <= 0.0 && u[j] < 1e-15)) return false;
        u[j] = 0.0;
        return true;
      });
      pivots -= std::ssize(chosen);
    }
  }
  return u;
}

}  // namespace

MassMetric massMetric(const Pose& X_WP, const Mat3& inertia_P) {
  const Mat3 R = X_WP.linear();
  return {.mass = 1.0, .inertia_W = R * inertia_P * R.transpose()};
}

double excess(const Row& row, const Twist& motion) {
  return row.n_W.dot(motion.linear) + motion.angular.dot(row.r_W.cross(row.n_W)) - row.bias;
}

Twist constrainedMotion(const Twist& free, const std::vector<Row>& rows, const MassMetric& M,
                        std::int64_t* pivots) {
  const bool clear =
      std::all_of(rows.begin(), rows.end(), [&](const Row& row) { return excess(row, free) >= 0; });
  if (clear) return free;

  // coordinates in which the metric is Euclidean: y = L^T x
  const double root_mass = std::sqrt(M.mass);
  const Mat3 L = Eigen::LLT<Mat3>{M.inertia_W}.matrixL();
  Vec6 y_free;
  y_free << root_mass * free.linear, L.transpose() * free.angular;

  // unit rows, and what each still lacks; scaled so that lengths are about one
  double scale = y_free.norm();
  Columns E{7, static_cast<Eigen::Index>(rows.size())};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    Vec6 g;
    g << row.n_W / root_mass, L.triangularView<Eigen::Lower>().solve(row.r_W.cross(row.n_W));
    const double size = g.norm();
    E.col(i) << g / size, row.bias / size - g.dot(y_free) / size;
    scale = std::max(scale, row.bias / size);
  }
  E.row(6) /= scale;

  Vec7 e = Vec7::Zero();
  e[6] = 1.0;
  std::int64_t count = 0;
  const Eigen::VectorXd u = nonNegativeLeastSquares(E, e, count);
  if (pivots != nullptr) *pivots += count;
  const Vec7 residual = E * u - e;
  const double squared = residual.squaredNorm();
  if (squared < 1e-20) return {};  // nothing is allowed

  // back to metres and radians; what is left of a motion that is all forbidden is rounding
  const Vec6 y = y_free + residual.head<6>() * (scale / squared);
  if (y.norm() < 1e-13 * scale) return {};
  return {.linear = y.head<3>() / root_mass,
          .angular = L.transpose().triangularView<Eigen::Upper>().solve(y.tail<3>())};
}

}  // namespace reference
