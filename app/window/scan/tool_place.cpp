// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/tool_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/window/scan/touched_surface.h"
#include "haptics/core/budget.h"
#include "haptics/scene/legal_pose.h"

namespace app {
namespace {

using haptics::Pose;
using haptics::Vec3;

constexpr double kSearch = 0.030;  // m: how far the nearest surface is sought
constexpr int kSearchDirections = 64;
constexpr double kLeastStandOff = 0.0005;  // m between surface and tip
constexpr double kMostStandOff = 0.030;    // m
constexpr double kFarther = 1.25;          // stand-off, from one try to the next
constexpr double kLean_deg = 15.0;         // from one ring of directions to the next
constexpr double kMostLean_deg = 75.0;
constexpr int kAround = 12;

/// Evenly over the sphere.
Vec3 directionNumber(int n, int count) {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double z = 1.0 - (2.0 * n + 1.0) / count, r = std::sqrt(1.0 - z * z);
  return {r * std::cos(golden * n), r * std::sin(golden * n), z};
}

/// The pose with the tool along `away`, turned as little as possible, and the tip at `p_W`.
Pose poseWithTip(const Vec3& p_W, const Vec3& away, const Vec3& tip_T, const Pose& X_now) {
  Pose X = Pose::Identity();
  X.linear() =
      (haptics::Quat::FromTwoVectors(X_now.linear().col(2), away) * haptics::rotationOf(X_now))
          .normalized()
          .toRotationMatrix();
  X.translation() = p_W - X.linear() * tip_T;
  return X;
}

}  // namespace

std::optional<ui::SurfacePlace> nearestSurface(const haptics::Scene& scene, double isovalue,
                                               const Vec3& p_W) {
  // the scene outlives this call
  const ui::TouchedSurface touched =
      touchedSurfaceOf({std::shared_ptr<const haptics::Scene>{}, &scene});
  const bool inside = touched.value(p_W) >= isovalue;
  const double step = 0.5 * scene.field.voxel();
  std::optional<ui::SurfacePlace> nearest;
  double distance = kSearch;
  for (int n = 0; n < kSearchDirections; ++n) {
    const Vec3 way = directionNumber(n, kSearchDirections);
    std::optional<ui::SurfacePlace> met;
    if (!inside) {
      met = touched.firstMet(p_W, p_W + distance * way, isovalue);
    } else {
      // the first place outside, and from there back
      double out = step;
      while (out < distance && touched.value(p_W + out * way) >= isovalue) out += step;
      if (out < distance)
        met = touched.firstMet(p_W + out * way, p_W + (out - step) * way, isovalue);
    }
    if (!met) continue;
    const double away = (met->p_W - p_W).norm();
    if (away >= distance && nearest) continue;
    nearest = met;
    distance = std::min(distance, away);
  }
  return nearest;
}

std::optional<Pose> poseAt(const haptics::Scene& scene, double isovalue,
                           const ui::SurfacePlace& place, const Pose& X_now) {
  const ui::TouchedSurface touched =
      touchedSurfaceOf({std::shared_ptr<const haptics::Scene>{}, &scene});
  const haptics::Isosurface solid{scene.field, isovalue};
  const Vec3 tip_T = scene.tool.shell.tip;
  const double voxel = scene.field.voxel();
  const Vec3 aside = place.normal_W.unitOrthogonal();
  for (double lean_deg = 0.0; lean_deg <= kMostLean_deg; lean_deg += kLean_deg)
    for (int n = 0; n < (lean_deg > 0.0 ? kAround : 1); ++n) {
      const Vec3 axis =
          Eigen::AngleAxisd{2.0 * std::numbers::pi * n / kAround, place.normal_W} * aside;
      const Vec3 away =
          Eigen::AngleAxisd{lean_deg * std::numbers::pi / 180.0, axis} * place.normal_W;
      // how far the tip can be from the surface before something else is in its way
      const Vec3 off_W = place.p_W + 0.25 * voxel * place.normal_W;
      double room = kMostStandOff;
      if (const auto wall = touched.firstMet(off_W, off_W + kMostStandOff * away, isovalue))
        room = (wall->p_W - off_W).norm();
      for (double off = std::max(kLeastStandOff, voxel); off < room; off *= kFarther) {
        const Pose X = poseWithTip(place.p_W + off * away, away, tip_T, X_now);
        haptics::Budget unlimited =
            haptics::Budget::counted(std::numeric_limits<std::int64_t>::max());
        if (haptics::legal(solid, scene.tool.shell, X, unlimited)) return X;
      }
    }
  return {};
}

}  // namespace app
