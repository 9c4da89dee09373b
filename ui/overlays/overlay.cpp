// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/overlay.h"

#include <QWidget>

namespace ui {

QRectF ViewGeometry::room() const { return widget().rect(); }
std::vector<QRectF> ViewGeometry::taken() const { return {}; }

void Overlay::paint(QPainter&, const ViewGeometry&) const {}
bool Overlay::press(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::drag(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::release(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::doubleClick(const ViewGeometry& view, const QMouseEvent& event) {
  // a press like the one before it, and without a drag
  const bool taken = press(view, event);
  if (taken) release(view, event);
  return taken;
}
bool Overlay::hover(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::key(const ViewGeometry&, const QKeyEvent&) { return false; }
QPolygonF Overlay::markHandlesIn(const ViewGeometry&) const { return {}; }
QString Overlay::hint() const { return {}; }
QString Overlay::note() const { return {}; }
Qt::CursorShape Overlay::cursor() const { return Qt::ArrowCursor; }

}  // namespace ui
