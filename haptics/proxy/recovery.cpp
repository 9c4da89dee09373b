// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/recovery.h"

#include <algorithm>
#include <cmath>

#include "haptics/collision/motion.h"
#include "haptics/proxy/touch_constants.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/solver/constrained_motion.h"

namespace haptics {
namespace {

constexpr std::size_t kRows = 48;

/// Moves the trial pose by the least motion that takes its deepest points out, to first order.
void push(const Scene& scene, const Isosurface& solid, Pose& X_WT, Budget& budget) HAPTICS_RT {
  const ScalarField& field = solid.field;
  const double h = field.voxel();
  FixedVector<MotionRow, kRows> rows;
  FixedVector<double, kRows> depths;
  for (const Vec3& p : scene.tool.shell.points) {
    if (!budget.left()) break;
    const Vec3 r = X_WT.linear() * p;
    const Vec3 u = field.indexOf(X_WT.translation() + r);
    budget.spend(field.work());
    ++budget.counts.samples;
    const double value = field.value(u);
    if (value < solid.ceiling()) continue;
    budget.spend(6 * field.work());
    budget.counts.samples += 6;
    ++budget.counts.gradients;
    const Vec3 gradient = field.centralGradient(u);
    const double slope = gradient.norm();
    if (!(slope > 0.0)) continue;
    const double depth = std::min((value - solid.ceiling()) / slope + 0.05 * h, 2.0 * h);
    const MotionRow row{-gradient / slope, r, -depth};
    if (rows.push(row)) {
      depths.push(depth);
      continue;
    }
    // the deepest are kept
    const auto shallowest = std::min_element(depths.begin(), depths.end()) - depths.begin();
    if (depths[static_cast<std::size_t>(shallowest)] < depth) {
      depths[static_cast<std::size_t>(shallowest)] = depth;
      rows[static_cast<std::size_t>(shallowest)] = row;
    }
  }
  if (rows.empty()) return;
  const ConstrainedMotion out =
      constrainedMotion({}, {rows.begin(), rows.size()}, scene.metric, X_WT.linear());
  budget.counts.pivots += out.pivots;
  budget.spend(out.work);
  if (out.status == ConstrainedMotion::Status::Exact) {
    const double size = out.whitened.norm();
    X_WT = moved(X_WT, out.twist, size > 4.0 * h ? 4.0 * h / size : 1.0);
    return;
  }
  // pushed from both sides: the mean way out
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < rows.size(); ++i) mean += depths[i] * rows[i].n_W;
  if (mean.norm() > 0.0) X_WT.translation() += mean.normalized() * h;
}

/// Translates the pose along the volume's nearest axis until the tool is clear of its voxels.
Pose outsideGrid(const Scene& scene, const Pose& X_WP) HAPTICS_RT {
  const Grid& grid = scene.volume->grid;
  const VoxelBox& box = scene.field.bounds();
  const double radius = scene.tool.shell.radius + 2.0 * grid.spacing.maxCoeff();
  const Vec3 u = grid.indexOf(X_WP.translation());
  double least = INFINITY;
  Vec3 way = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const double far =
          sign < 0.0 ? u[axis] - double(box.first[axis]) : double(box.end[axis] - 1) - u[axis];
      const double distance = far * grid.spacing[axis] + radius;
      if (distance < least) {
        least = distance;
        way = sign * distance * grid.direction.col(axis);
      }
    }
  Pose X = X_WP;
  X.translation() += way;
  return X;
}

}  // namespace

bool recover(const Scene& scene, const Isosurface& solid, Proxy& proxy, double period,
             Budget& budget) HAPTICS_RT {
  Recovery& recovery = proxy.recovery;
  const PointShell& shell = scene.tool.shell;
  if (!recovery.active) {
    recovery = {};
    recovery.active = true;
    recovery.X_WT = proxy.X_WP;
  }
  const double time = recovery.time + 0.5 * period;  // a sum of periods is never quite what it is
  recovery.time += period;
  bool found = false;
  Pose X = recovery.X_WT;
  if (time < TouchConstants::kPushTime) {
    for (int i = 0; i < TouchConstants::kPushes && !found && budget.left(); ++i) {
      push(scene, solid, recovery.X_WT, budget);
      X = recovery.X_WT;
      found = legal(solid, shell, X, budget);
    }
  } else if (time < TouchConstants::kLongestRecovery) {
    while (!found && budget.left()) {
      placeAround(proxy.X_WP, solid.field.voxel(), recovery.candidate++, X);
      found = legal(solid, shell, X, budget);
    }
  } else {
    X = outsideGrid(scene, proxy.X_WP);
    found = true;
  }
  if (!found) return false;
  proxy.X_WP = X;
  proxy.contacts.clear();
  proxy.clearance.forget();
  proxy.following.filter.forget();
  recovery.active = false;
  return true;
}

}  // namespace haptics
