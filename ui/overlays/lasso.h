// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPolygonF>
#include <array>
#include <vector>

#include "ui/overlays/projection.h"

namespace ui {

/// A closed outline that was drawn on a view.
struct DrawnOutline {
  Projection camera;
  std::vector<std::array<double, 2>> corners;  ///< as Projection::acrossOf
  bool in_slice = false;
  /// In 3-D: places of the touched surface that were seen inside it, mm of W, at most 25.
  std::vector<Eigen::Vector3d> seen;
};

/// The scalpel: while it is on, the left button draws a closed outline on a view, in one go or
/// corner by corner: then a second click on the last corner closes it.
class Lasso : public Overlay {
  Q_OBJECT
 public:
  using Overlay::Overlay;

  void setActive(bool active);
  bool isActive() const { return active_; }
  /// Whether what an outline takes is shown: then the key that sets a corner confirms it.
  void setAsks(bool asks);

  void paint(QPainter& painter, const ViewGeometry& view) const override;
  bool press(const ViewGeometry& view, const QMouseEvent& event) override;
  bool drag(const ViewGeometry& view, const QMouseEvent& event) override;
  bool release(const ViewGeometry& view, const QMouseEvent& event) override;
  bool hover(const ViewGeometry& view, const QMouseEvent& event) override;
  /// Backspace takes the last corner back.
  bool key(const ViewGeometry& view, const QKeyEvent& event) override;
  Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  QString hint() const override;

 signals:
  void drawn(const ui::DrawnOutline& outline);
  void confirmed();

 private:
  void setCorner(const ViewGeometry& view, QPointF at);
  QPolygonF cornersIn(const ViewGeometry& view) const;
  void cut(const ViewGeometry& view, const QPolygonF& line);

  bool active_ = false;
  bool asks_ = false;
  const QWidget* on_ = nullptr;              ///< on which it is drawn; only compared
  QPolygonF line_;                           ///< of a drag, pixels
  std::vector<Eigen::Vector3d> corners_mm_;  ///< of clicks, in a plane parallel to the picture, W
};

/// While it is on, a click on the surface or in a slice picks a place.
class PlacePick : public Overlay {
  Q_OBJECT
 public:
  using Overlay::Overlay;

  void setActive(bool active);
  bool press(const ViewGeometry& view, const QMouseEvent& event) override;
  bool drag(const ViewGeometry& view, const QMouseEvent& event) override;
  bool release(const ViewGeometry& view, const QMouseEvent& event) override;
  bool hover(const ViewGeometry& view, const QMouseEvent& event) override;
  Qt::CursorShape cursor() const override { return Qt::PointingHandCursor; }
  QString hint() const override;

 signals:
  void picked(const Eigen::Vector3d& place_W_mm);

 private:
  bool active_ = false;
};

}  // namespace ui
