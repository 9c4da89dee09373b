// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/pose_predictor.h"

#include <algorithm>

namespace haptics {

Pose PosePredictor::ahead(const Pose& X, std::int64_t time_ns) HAPTICS_RT {
  if (lead_ == 0.0 || !X.matrix().allFinite()) return X;
  if (count_ > 0) {
    const std::int64_t since = time_ns - ago(1).time_ns;
    if (since == 0) return X_ahead_;
    if (since < 0 || since > kGap_ns) forget();
  }
  X_ahead_ = X;
  if (const std::size_t n = beginOf(kWindow_ns, time_ns); n > 0) {
    const auto shareOf = [&](const Reading& since) HAPTICS_RT {
      return lead_ / (1e-9 * double(time_ns - since.time_ns));
    };
    const Eigen::AngleAxisd turn{X.linear() * ago(n).X.linear().transpose()};
    X_ahead_.linear() =
        Eigen::AngleAxisd{shareOf(ago(n)) * turn.angle(), turn.axis()}.toRotationMatrix() *
        X.linear();
    const std::size_t begin = straight_ > 0.0 ? beginOf(kLongWindow_ns, time_ns) : 0;
    const bool straight = begin > 0 && isStraight(begin, X.translation(), time_ns);
    const Reading& since = ago(straight ? begin : n);
    X_ahead_.translation() += shareOf(since) * (X.translation() - since.X.translation());
  }
  readings_[count_ % readings_.size()] = {X, time_ns};
  ++count_;
  return X_ahead_;
}

std::size_t PosePredictor::beginOf(std::int64_t window_ns, std::int64_t time_ns) const HAPTICS_RT {
  for (std::size_t n = 1; n <= std::min(count_, readings_.size()); ++n)
    if (time_ns - ago(n).time_ns >= window_ns - kEarly_ns) return n;
  return 0;
}

bool PosePredictor::isStraight(std::size_t n, const Vec3& p,
                               std::int64_t time_ns) const HAPTICS_RT {
  const Reading& begin = ago(n);
  const Vec3 way = p - begin.X.translation();
  const double duration = double(time_ns - begin.time_ns);
  for (std::size_t i = 1; i < n; ++i) {
    const Reading& between = ago(i);
    const double share = double(between.time_ns - begin.time_ns) / duration;
    const Vec3 off = between.X.translation() - begin.X.translation() - share * way;
    if (off.squaredNorm() > straight_ * straight_) return false;
  }
  return true;
}

}  // namespace haptics
