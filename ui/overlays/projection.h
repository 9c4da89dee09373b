// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointF>
#include <array>
#include <optional>
#include <vector>

#include "haptics/core/volume.h"
#include "ui/overlays/overlay.h"

namespace ui {

/// The camera of a view as numbers, so that many places can be projected at little cost. mm, W.
struct Projection {
  bool parallel = false;
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();       ///< of a slice: the middle of its picture
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< right, up, towards the viewer
  QPointF centre;                                      ///< the pixel straight ahead of the eye
  double scale = 1.0;  ///< pixels per mm, or with perspective per tangent

  /// The distance of a place from the eye along the view.
  double depthOf(const Eigen::Vector3d& p_W_mm) const { return -axes.col(2).dot(p_W_mm - eye); }
  QPointF of(const Eigen::Vector3d& p_W_mm) const;
  /// x to the right and y up of a pixel in the camera's axes: mm, or with perspective tangents.
  std::array<double, 2> acrossOf(QPointF at) const;
  bool operator==(const Projection&) const = default;
};

Projection projectionOf(const ViewGeometry& view);

/// Where on the line through `p` along the unit direction `along`, in mm from `p`, the line of
/// sight through a pixel comes nearest; none if the two are nearly parallel.
std::optional<double> alongLine(const ViewGeometry& view, QPointF at, const Eigen::Vector3d& p,
                                const Eigen::Vector3d& along);

/// The corners of a box of voxels, mm of W, as the outer faces of its voxels bound it: bit a of the
/// number tells the side on axis a.
using BoxCorners = std::array<Eigen::Vector3d, 8>;
BoxCorners cornersOf_mm(const haptics::Grid& grid, const haptics::VoxelBox& box);

/// The convex polygon in which a plane cuts a box, in order around it; empty if it misses the box.
std::vector<Eigen::Vector3d> sectionOf(const BoxCorners& corners, const Eigen::Vector3d& point,
                                       const Eigen::Vector3d& normal);
/// The part of a convex polygon on the side to which the normal points.
std::vector<Eigen::Vector3d> clipped(const std::vector<Eigen::Vector3d>& polygon,
                                     const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

}  // namespace ui
