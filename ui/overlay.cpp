// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlay.h"

namespace ui {

void Overlay::paint(QPainter&, const ViewGeometry&) const {}
bool Overlay::press(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::drag(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::release(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::doubleClick(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::hover(const ViewGeometry&, const QMouseEvent&) { return false; }
bool Overlay::key(const ViewGeometry&, const QKeyEvent&) { return false; }
Qt::CursorShape Overlay::cursor() const { return Qt::ArrowCursor; }

}  // namespace ui
