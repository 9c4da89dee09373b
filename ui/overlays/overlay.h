// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "haptics/core/geometry.h"
#include "ui/controls/bindings.h"

class QKeyEvent;
class QMouseEvent;
class QPainter;
class QWidget;

namespace ui {

/// The geometry of a view, for what is drawn over it. Millimetres of W, and widget coordinates.
class ViewGeometry {
 public:
  virtual ~ViewGeometry() = default;
  /// True: a planar view, which shows a plane of W. False: the 3-D view.
  virtual bool isSlice() const = 0;
  virtual QPointF projected(const Eigen::Vector3d& p_W_mm) const = 0;
  /// Columns: right, up, towards the viewer; in W.
  virtual Eigen::Matrix3d axes() const = 0;
  /// What lies under a pixel: in a slice the place in its plane, in 3-D the place on the touched
  /// surface; none where the surface is not met.
  virtual std::optional<Eigen::Vector3d> placeUnder(QPointF at) const = 0;
  /// The place under a pixel in the plane through `p_W_mm` that is parallel to the picture.
  virtual Eigen::Vector3d placeBeside(QPointF at, const Eigen::Vector3d& p_W_mm) const = 0;
  /// The line of sight through a pixel: a place on it and its unit direction away from the viewer.
  virtual void sight(QPointF at, Eigen::Vector3d& from_W_mm, Eigen::Vector3d& along_W) const = 0;
  virtual double mmPerPixel(const Eigen::Vector3d& p_W_mm) const = 0;
  /// Distance of a place from the viewed plane, towards the viewer, mm; 0 in 3-D.
  virtual double offset_mm(const Eigen::Vector3d& p_W_mm) const = 0;
  virtual const QWidget& widget() const = 0;
  /// The part of the widget in which handles are seen whole; the default is all of it.
  virtual QRectF room() const;
  /// Whether a box of the view shows some of the body, where nothing should be written.
  virtual bool showsBody(const QRectF& box) const = 0;
  /// Where other words stand, beside which nothing is written; the default is nowhere.
  virtual std::vector<QRectF> taken() const;
};

/// Something that is drawn over the views and may be dragged there: handles of a crop box, an
/// outline, a measure. One overlay can be in several views. Views ask the overlay that was added
/// last first. The default takes nothing and shows nothing.
class Overlay : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  virtual void paint(QPainter& painter, const ViewGeometry& view) const;
  // Each returns true if the overlay takes the event; the view then does nothing with it. An
  // overlay that takes a press gets the moves and the release that follow.
  virtual bool press(const ViewGeometry& view, const QMouseEvent& event);
  virtual bool drag(const ViewGeometry& view, const QMouseEvent& event);
  virtual bool release(const ViewGeometry& view, const QMouseEvent& event);
  virtual bool doubleClick(const ViewGeometry& view, const QMouseEvent& event);
  /// A move without a button. While an overlay takes it, the view shows its cursor().
  virtual bool hover(const ViewGeometry& view, const QMouseEvent& event);
  virtual bool key(const ViewGeometry& view, const QKeyEvent& event);
  /// What the key that stands for a click means to this overlay.
  virtual Action keyForClick() const { return Action::SetPlaceOfEdit; }
  /// Where handles of marks are in a view.
  virtual QPolygonF markHandlesIn(const ViewGeometry& view) const;
  /// What the mouse and Enter do over the views while this overlay takes them; empty: nothing.
  virtual QString hint() const;
  /// What a picture of one view says below it because of this overlay; empty: nothing.
  virtual QString note() const;
  /// The cursor while the mouse is over something of this overlay that can be dragged.
  virtual Qt::CursorShape cursor() const;

 signals:
  /// What is drawn has changed: the views paint again.
  void changed();
};

}  // namespace ui
