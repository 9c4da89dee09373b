// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/servo/lead.h"

#include <algorithm>

namespace haptics {

Pose Lead::ahead(const Pose& X, std::int64_t time_ns) HAPTICS_RT {
  if (lead_ == 0.0 || !X.matrix().allFinite()) return X;
  const auto ago = [&](std::size_t n) HAPTICS_RT -> const Reading& {
    return readings_[(count_ - n) % readings_.size()];
  };
  if (count_ > 0) {
    const std::int64_t since = time_ns - ago(1).time_ns;
    if (since == 0) return X_ahead_;
    if (since < 0 || since > kGap_ns) forget();
  }
  X_ahead_ = X;
  for (std::size_t n = 1; n <= std::min(count_, readings_.size()); ++n) {
    const Reading& before = ago(n);
    const std::int64_t age_ns = time_ns - before.time_ns;
    if (age_ns < kWindow_ns) continue;
    const double share = lead_ / (1e-9 * double(age_ns));
    const Eigen::AngleAxisd turn{X.linear() * before.X.linear().transpose()};
    X_ahead_.translation() += share * (X.translation() - before.X.translation());
    X_ahead_.linear() =
        Eigen::AngleAxisd{share * turn.angle(), turn.axis()}.toRotationMatrix() * X.linear();
    break;
  }
  readings_[count_ % readings_.size()] = {X, time_ns};
  ++count_;
  return X_ahead_;
}

}  // namespace haptics
