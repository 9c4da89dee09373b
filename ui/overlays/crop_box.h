// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "ui/overlays/projection.h"

namespace ui {

/// The crop box: six faces, each with a handle that moves it along its axis of the grid, by whole
/// voxels. Slices show where they cut the box. A handle whose place lies at the border of the view,
/// or beyond it, is shown whole at the border.
class CropBox : public Overlay {
  Q_OBJECT
 public:
  using Overlay::Overlay;

  void show(const haptics::Grid& grid, const haptics::VoxelBox& box);
  void hide();
  bool isShown() const { return grid_.has_value(); }
  /// Whether a handle is being dragged.
  bool isHeld() const { return held_.has_value(); }
  const haptics::VoxelBox& box() const { return box_; }

  void paint(QPainter& painter, const ViewGeometry& view) const override;
  bool press(const ViewGeometry& view, const QMouseEvent& event) override;
  bool drag(const ViewGeometry& view, const QMouseEvent& event) override;
  bool release(const ViewGeometry& view, const QMouseEvent& event) override;
  bool hover(const ViewGeometry& view, const QMouseEvent& event) override;
  Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }
  QString hint() const override;

  /// Where the handle of a face is shown, mm of W; none if this view shows none.
  std::optional<Eigen::Vector3d> handleOf(const ViewGeometry& view, int axis, bool far_side) const;

 signals:
  /// A handle was dragged to another voxel.
  void moved();
  /// A handle was let go after it was moved.
  void released();

 private:
  struct Face {
    int axis = 0;
    bool far_side = false;  ///< the face of the greatest index
    bool operator==(const Face&) const = default;
  };
  std::optional<Face> faceAt(const ViewGeometry& view, QPointF at) const;
  std::int64_t& edgeOf(const Face& face);

  std::optional<haptics::Grid> grid_;
  haptics::VoxelBox box_;
  std::optional<Face> held_;
  Eigen::Vector3d held_at_ = Eigen::Vector3d::Zero();  ///< the handle when it was taken
  double grip_mm_ = 0.0;                               ///< of the pointer beside it, along the axis
  std::int64_t held_edge_ = 0;                         ///< the edge when it was taken
};

}  // namespace ui
