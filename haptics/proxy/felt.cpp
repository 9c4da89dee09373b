// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/felt.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptics {
namespace {

constexpr double kGiveTime = 0.005;   // s in which tissue gives way
constexpr double kRounding = 0.5e-3;  // m, of the least distance to what is guarded

/// m/N: how much what the proxy bears on gives way, by the share of the force on it.
double complianceUnder(const Watch& watch, const Scene& scene, const Proxy& proxy) HAPTICS_RT {
  double compliance = 0.0, pushes = 0.0;
  for (const BearingContact& contact : proxy.bearing) {
    pushes += contact.push;
    // what is touched lies half a voxel behind the surface
    const Vec3 p_W =
        proxy.X_WP.translation() + contact.r_W - 0.5 * scene.field.voxel() * contact.n_W;
    for (const Watch::Watched& watched : watch.structures) {
      if (watched.feel.kind != Feel::Kind::Softer || watched.distances.at(p_W) > 0.0) continue;
      compliance += contact.push / watched.feel.stiffness;
      break;
    }
  }
  return pushes > 0.0 ? compliance / pushes : 0.0;
}

}  // namespace

Vec3 YieldingSpring::pass(const Vec3& pull, double c, double period) HAPTICS_RT {
  if (std::isinf(c)) {
    rest_ = given_;
  } else {
    if (c > c_ && !std::isinf(c_)) rest_ = given_ - (given_ - rest_) * std::sqrt(c_ / c);
    const double damping = kGiveTime * (1.0 + c) / period;
    given_ = (damping * given_ + pull + c * rest_) / (damping + 1.0 + c);
  }
  c_ = c;
  // it pushes the hand out, and does not pull it back
  const double size = given_.squaredNorm();
  if (size > 0.0) {
    const double kept = std::clamp(pull.dot(given_) / size, 0.0, 1.0);
    given_ *= kept;
    rest_ *= kept;
  }
  return pull - given_;
}

Wrench guardAt(const Watch::Watched& guarded, const Scene& scene, const Pose& X_WD) HAPTICS_RT {
  const Feel& feel = guarded.feel;
  const DistanceMap& map = guarded.distances;
  const NearestPoint nearest = nearestPoint(map, scene, X_WD, feel.margin);
  if (nearest.index < 0) return {};
  const double rounding = std::min(kRounding, 0.25 * feel.margin);
  const RoundedLeast least = roundedLeast(map, scene, X_WD, nearest, rounding);
  // it lies below the nearest's distance by no more, so nothing is felt beyond the margin
  const double near = std::clamp(1.0 - least.distance / (feel.margin - rounding), 0.0, 1.0);
  const double size = feel.most / map.steepest * near;
  return {.force = size * least.slope.force, .torque = size * least.slope.torque};
}

Wrench Felt::shaped(const Watch& watch, const Scene& scene, const Proxy& proxy, const Pose& X_WD,
                    double stiffness, const Wrench& pulled, double period) HAPTICS_RT {
  Wrench felt = pulled;
  bool softer = false;
  for (const Watch::Watched& watched : watch.structures) {
    softer = softer || watched.feel.kind == Feel::Kind::Softer;
    if (watched.feel.kind != Feel::Kind::Guarded) continue;
    const Wrench guard = guardAt(watched, scene, X_WD);
    felt.force += guard.force;
    felt.torque += guard.torque;
  }
  if (!softer || !(stiffness > 0.0)) return felt;
  if (!proxy.bearing.empty()) compliance_ = complianceUnder(watch, scene, proxy);
  const double c =
      compliance_ > 0.0 ? 1.0 / (compliance_ * stiffness) : std::numeric_limits<double>::infinity();
  felt.force += force_.pass(pulled.force, c, period) - pulled.force;
  felt.torque += torque_.pass(pulled.torque, c, period) - pulled.torque;
  return felt;
}

}  // namespace haptics
