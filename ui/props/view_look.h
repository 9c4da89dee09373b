// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ui {

/// How the views share the room.
enum class Arrangement { One, FourUp, VolumeLarge, SlicesLarge };

/// Which views have a place, and how large it is. Views are counted from the 3-D view, then axial,
/// coronal, sagittal, and the one with the tool.
struct LayoutLook {
  static constexpr std::size_t kViews = 5;
  static constexpr double kLeastShare = 0.02, kMostShare = 10.0;

  Arrangement arrangement = Arrangement::VolumeLarge;
  bool tool_view = false;  ///< the view with the tool has a place
  std::size_t active = 0;  ///< the view that had the focus last
  bool alone = false;      ///< it has all the room for a while
  /// For each column its share of the width, then the shares of its views of the height. Empty: as
  /// the arrangement begins.
  std::vector<std::vector<double>> shares = {};
};

enum class Interpolation { Linear, Nearest };
enum class SlabKind { None, Maximum, Mean, Minimum };

/// How voxels become the picture of a slice.
struct SliceLook {
  static constexpr double kThinnest_mm = 0.1, kThickest_mm = 200.0;

  Interpolation interpolation = Interpolation::Linear;
  SlabKind slab = SlabKind::None;
  double thickness_mm = 5.0;  ///< of a slab, half of it on either side of the plane

  bool operator==(const SliceLook&) const = default;
};

/// The part of a slice that is seen.
struct SliceFrame {
  double zoom = 1.0;                                   ///< 1: the whole slice
  Eigen::Vector2d shift_mm = Eigen::Vector2d::Zero();  ///< of the middle, right and up
};

/// The plane of the view with the tool.
struct ToolPlane {
  bool along = false;     ///< it holds the tool's axis, else it is normal to it
  double depth_mm = 0.0;  ///< from the tip or the axis, along its normal
};

/// The colours of the surface: one, by tissue, or by tissue with vessels in red.
enum class SurfaceColours { Ivory, Tissue, Vessels };

/// Opacity of the second surface: at first, and the least that is still seen.
inline constexpr double kFirstOpacity = 0.38, kLeastOpacity = 0.05;

/// How the views look at a scan; millimetres of W.
struct ViewLook {
  // the 3-D view
  Eigen::Vector3d eye_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d focus_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  bool parallel = false;
  double half_height_mm = 1.0;  ///< of what a parallel view shows
  SurfaceColours colours = SurfaceColours::Ivory;
  std::optional<double> second = {};      ///< isovalue of the second surface; none: no second
  double second_opacity = kFirstOpacity;  ///< kLeastOpacity to 1
  // the slices
  Eigen::Vector3d cross_mm = Eigen::Vector3d::Zero();
  double grey_level = 0.0, grey_width = 1.0;
  std::array<SliceFrame, 4> slices = {};  ///< axial, coronal, sagittal, with the tool
  SliceLook voxels = {};
  ToolPlane tool_plane = {};
  LayoutLook layout = {};
};

}  // namespace ui
