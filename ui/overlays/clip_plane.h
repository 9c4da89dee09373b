// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "ui/overlays/projection.h"

namespace ui {

/// The clip plane. It is placed by three clicks, or by place(). Its two handles shift it along its
/// normal and turn it. What lies on the side of the normal goes.
///
/// Three clicks on the surface give the plane through them, and what is nearer to the viewer goes.
/// Three clicks in one slice give the plane through the first two, upright on the slice; the third
/// tells the side that goes.
///
/// In 3-D the handle that turns stands on the plane's normal. Where that points at the viewer, the
/// handle lies beside the other one, and the plane tilts to where it is dragged.
class ClipPlane : public Overlay {
  Q_OBJECT
 public:
  using Overlay::Overlay;

  /// Waits for three clicks. `within`: the voxels over which the plane is drawn.
  void begin(const haptics::Grid& grid, const haptics::VoxelBox& within);
  void place(const Eigen::Vector3d& point_W_mm, const Eigen::Vector3d& normal_W);
  void hide();
  bool isShown() const { return shown_; }
  bool isPlaced() const { return placed_; }
  std::size_t clicks() const { return clicks_.size(); }
  const Eigen::Vector3d& point_mm() const { return point_; }
  const Eigen::Vector3d& normal() const { return normal_; }

  void paint(QPainter& painter, const ViewGeometry& view) const override;
  bool press(const ViewGeometry& view, const QMouseEvent& event) override;
  bool drag(const ViewGeometry& view, const QMouseEvent& event) override;
  bool release(const ViewGeometry& view, const QMouseEvent& event) override;
  bool hover(const ViewGeometry& view, const QMouseEvent& event) override;
  QString hint() const override;
  Qt::CursorShape cursor() const override { return placed_ ? Qt::SizeAllCursor : Qt::CrossCursor; }

  /// The handles in a view, mm of W; none where the plane does not meet the slice.
  struct Handles {
    Eigen::Vector3d shift, turn;
    bool beside = false;  ///< the one that turns does not stand on the normal
  };
  std::optional<Handles> handlesIn(const ViewGeometry& view) const;

 signals:
  /// It was placed, shifted or turned with the mouse, or a click was set.
  void moved();
  /// The clicks give no plane; `why`: a sentence.
  void refused(const QString& why);

 private:
  struct Click {
    Eigen::Vector3d place;
    const QWidget* slice = nullptr;  ///< null: in 3-D
    double offset_mm = 0.0;
  };
  void setClick(const ViewGeometry& view, const Eigen::Vector3d& at_mm);
  std::vector<Eigen::Vector3d> outline() const;

  bool shown_ = false, placed_ = false;
  BoxCorners corners_{};
  std::vector<Click> clicks_;
  Eigen::Vector3d point_ = Eigen::Vector3d::Zero(), normal_ = Eigen::Vector3d::UnitZ();
  enum class Held { None, Shift, Turn } held_ = Held::None;
  Handles taken_{};  ///< the handles when one was taken
  Eigen::Vector3d point_taken_ = Eigen::Vector3d::Zero(), normal_taken_ = Eigen::Vector3d::UnitZ();
  QPointF pressed_, dragged_;  ///< where the pointer took the handle, and where it is
  double grip_mm_ = 0.0;
};

}  // namespace ui
