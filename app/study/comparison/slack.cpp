// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/slack.h"

#include <algorithm>
#include <cmath>

#include "app/study/reference/motion.h"

namespace comparison {

Pose Nudge::operator()(const Pose& X, double linear, double angular) {
  const Vec3 turn = angular * triple();
  Pose out = X;
  out.translation() += linear * triple();
  if (turn.norm() > 0.0)
    out.linear() = Eigen::AngleAxisd{turn.norm(), turn.normalized()} * X.linear();
  return out;
}

std::optional<double> localSlack(const Pose& X_WP, const Pose& X_WD,
                                 const haptics::PointShell& shell, const Judge& judge, int trials,
                                 std::uint32_t seed) {
  constexpr int kWaysOut = 4;
  constexpr double kMargin = 1e-8;  // m
  if (!judge.legal(X_WP)) return {};
  const double gyration = std::sqrt(shell.inertia.trace() / 3.0);
  const double first = massDistance(X_WP, X_WD, shell);
  Nudge nudge{seed};
  Pose X = X_WP;
  double best = first, size = 5e-5;
  for (int n = 0; n < trials && best > 0.0; ++n) {
    Pose X_next = nudge(X, size, size / gyration);
    if (n % 2 == 1) X_next = between(X_next, X_WD, std::min(1.0, 3.0 * size / best));
    for (int way = 0; way < kWaysOut; ++way) {
      const haptics::Twist out = judge.wayOut(X_next, kMargin);
      if (out.linear.isZero(0.0) && out.angular.isZero(0.0)) break;
      X_next = reference::moved(X_next, out, 1.0);
    }
    const double distance = massDistance(X_next, X_WD, shell);
    const bool better = distance < best && massDistance(X_WP, X_next, shell) < kSlackWithin &&
                        judge.legal(X_next) && judge.passages(X, X_next, false) == 0;
    if (better) {
      X = X_next;
      best = distance;
    }
    size = std::clamp(better ? 1.6 * size : 0.93 * size, 1e-7, 2e-4);
  }
  return first - best;
}

}  // namespace comparison
