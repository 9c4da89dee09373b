// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace ui {

/// How the views look at a scan; millimetres of W.
struct ViewLook {
  // the 3-D view
  Eigen::Vector3d eye_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d focus_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  bool parallel = false;
  double half_height_mm = 1.0;  ///< of what a parallel view shows
  // the slices
  Eigen::Vector3d cross_mm = Eigen::Vector3d::Zero();
  double grey_level = 0.0, grey_width = 1.0;
};

}  // namespace ui
