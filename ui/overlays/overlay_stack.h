// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointer>
#include <vector>

#include "ui/overlays/overlay.h"

namespace ui {

/// The overlays of one view. The view passes its events on, and does what it does otherwise where
/// no overlay takes them.
class OverlayStack {
 public:
  explicit OverlayStack(QWidget& view) : view_(view) {}

  /// Puts an overlay above the others. It must not outlive the application; the view forgets it
  /// when it is destroyed, and paints again whenever it changes.
  void add(Overlay& overlay);
  void paint(QPainter& painter, const ViewGeometry& geometry) const;
  // True: an overlay took the event.
  bool press(const ViewGeometry& geometry, const QMouseEvent& event);
  /// A move, with or without a button.
  bool move(const ViewGeometry& geometry, const QMouseEvent& event);
  bool release(const ViewGeometry& geometry, const QMouseEvent& event);
  bool doubleClick(const ViewGeometry& geometry, const QMouseEvent& event);
  /// Enter clicks at `at`, the crosshair or the middle of the view, as the left button would.
  bool key(const ViewGeometry& geometry, const QKeyEvent& event, QPointF at);
  bool hasHandleIn(const ViewGeometry& geometry, const QRectF& part) const;
  /// That of the uppermost overlay that has one; else empty.
  QString hint() const;
  QString note() const;

 private:
  QWidget& view_;
  std::vector<QPointer<Overlay>> overlays_;  ///< the last is on top
  QPointer<Overlay> dragged_;                ///< took the press
  bool cursor_set_ = false;
};

}  // namespace ui
