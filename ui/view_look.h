// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

namespace ui {

/// The part of a slice that is seen.
struct SliceFrame {
  double zoom = 1.0;                                   ///< 1: the whole slice
  Eigen::Vector2d shift_mm = Eigen::Vector2d::Zero();  ///< of the middle, right and up
};

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
  std::array<SliceFrame, 3> slices = {};  ///< axial, coronal, sagittal
  std::string layout = {};                ///< a word of the window's own; empty: as it is
};

}  // namespace ui
