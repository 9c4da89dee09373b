// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlay_stack.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWidget>
#include <ranges>

namespace ui {

void OverlayStack::add(Overlay& overlay) {
  overlays_.emplace_back(&overlay);
  QObject::connect(&overlay, &Overlay::changed, &view_, qOverload<>(&QWidget::update));
}

void OverlayStack::paint(QPainter& painter, const ViewGeometry& geometry) const {
  for (const QPointer<Overlay>& overlay : overlays_) {
    if (!overlay) continue;
    painter.save();
    overlay->paint(painter, geometry);
    painter.restore();
  }
}

bool OverlayStack::press(const ViewGeometry& geometry, const QMouseEvent& event) {
  dragged_.clear();
  for (const QPointer<Overlay>& overlay : overlays_ | std::views::reverse)
    if (overlay && overlay->press(geometry, event)) {
      dragged_ = overlay;
      return true;
    }
  return false;
}

bool OverlayStack::move(const ViewGeometry& geometry, const QMouseEvent& event) {
  if (dragged_) return dragged_->drag(geometry, event);
  if (event.buttons() != Qt::NoButton) return false;
  for (const QPointer<Overlay>& overlay : overlays_ | std::views::reverse)
    if (overlay && overlay->hover(geometry, event)) {
      view_.setCursor(overlay->cursor());
      cursor_set_ = true;
      return true;
    }
  if (cursor_set_) view_.unsetCursor();
  cursor_set_ = false;
  return false;
}

bool OverlayStack::release(const ViewGeometry& geometry, const QMouseEvent& event) {
  if (!dragged_) return false;
  const QPointer<Overlay> overlay = dragged_;
  if (event.buttons() == Qt::NoButton) dragged_.clear();
  return overlay->release(geometry, event);
}

bool OverlayStack::doubleClick(const ViewGeometry& geometry, const QMouseEvent& event) {
  for (const QPointer<Overlay>& overlay : overlays_ | std::views::reverse)
    if (overlay && overlay->doubleClick(geometry, event)) return true;
  return false;
}

bool OverlayStack::key(const ViewGeometry& geometry, const QKeyEvent& event) {
  for (const QPointer<Overlay>& overlay : overlays_ | std::views::reverse)
    if (overlay && overlay->key(geometry, event)) return true;
  return false;
}

}  // namespace ui
