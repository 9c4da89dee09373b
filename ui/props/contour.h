// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLineF>
#include <functional>
#include <vector>

#include "haptics/core/geometry.h"

namespace ui {

/// A rectangle of a plane of W, mm. Places in it are given as mm from its corner, along `right` and
/// `up`.
struct Patch {
  Eigen::Vector3d corner_W_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();  ///< unit, W
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();     ///< unit, W, at a right angle to `right`
  double width_mm = 0.0, height_mm = 0.0;

  Eigen::Vector3d at(QPointF p_mm) const { return corner_W_mm + right * p_mm.x() + up * p_mm.y(); }
};

/// How finely a contour is followed.
struct ContourFineness {
  double step_mm = 1.0;   ///< between two samples; what is smaller may be missed
  double voxel_mm = 1.0;  ///< smallest voxel side, by which accuracy is measured
  bool bent = true;  ///< pieces are bent until they are within 0.05 voxel; false: only their ends
};

/// Pieces of the lines on which a field is at `level`, in places of the patch. The ends of each
/// piece are within 0.005 voxel of the field's surface. `field` is given places of W [m].
std::vector<QLineF> contourOf(const std::function<double(const haptics::Vec3& p_W)>& field,
                              double level, const Patch& patch, const ContourFineness& fineness);

}  // namespace ui
