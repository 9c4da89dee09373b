// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "ui/overlay_stack.h"
#include "ui/props/slice.h"
#include "ui/touched_surface.h"

namespace ui {

/// One slice through the crosshair, with the crosshair, the proxy's projection and the letters of
/// the edges. The left button moves the crosshair, right drag changes the grey window, the wheel
/// changes the slice.
class SliceView : public QWidget {
  Q_OBJECT
 public:
  explicit SliceView(Plane plane, QWidget* parent = nullptr);
  ~SliceView() override;

  void show(const Picture& picture);
  /// The same grid with other voxels; everything else stays.
  void replace(const Picture& picture);
  void setCross(const Eigen::Vector3d& cross_W_mm);
  void setGrey(const GreyWindow& grey);
  /// Sets the proxy's position. Its mark is solid if it lies in this slice.
  void setProxy(const Eigen::Vector3d& proxy_W_mm);

  /// The surface that is touched; given with every scene.
  void setTouched(const TouchedSurface& touched) { touched_ = touched; }
  /// Draws this above the slice, and asks it first for mouse and keys.
  void addOverlay(Overlay& overlay) { overlays_.add(overlay); }

  Plane plane() const { return plane_; }
  const Eigen::Vector3d& cross_mm() const { return cross_mm_; }
  const GreyWindow& grey() const { return grey_; }
  /// Widget coordinates of a point of W, mm.
  QPointF projected(const Eigen::Vector3d& p_W_mm) const;
  QSize sizeHint() const override { return {300, 260}; }

 signals:
  void crossMoved(const Eigen::Vector3d& cross_W_mm);
  void greyChanged(const ui::GreyWindow& grey);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  class Geometry;

  double mmPerPixel() const;
  /// The place of W, mm, under a pixel, in the plane of the slice.
  Eigen::Vector3d placeUnder(QPointF at) const;
  void moveCrossTo(QPointF at);
  void drawLetters(QPainter& painter) const;

  Plane plane_;
  PlaneAxes axes_;
  Slice slice_;
  QImage image_;
  bool stale_ = true;
  bool letters_ = false;
  Eigen::AlignedBox3d box_mm_;
  double step_mm_ = 1.0;
  double full_width_ = 1.0;
  Eigen::Vector3d cross_mm_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> proxy_mm_;
  GreyWindow grey_;
  QPointF last_mouse_;
  TouchedSurface touched_;
  std::unique_ptr<Geometry> geometry_;
  OverlayStack overlays_{*this};
};

}  // namespace ui
