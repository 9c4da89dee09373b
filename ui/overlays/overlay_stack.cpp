// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/overlay_stack.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWidget>
#include <ranges>

#include "ui/controls/bindings.h"

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

bool OverlayStack::key(const ViewGeometry& geometry, const QKeyEvent& event, QPointF at) {
  for (const QPointer<Overlay>& overlay : overlays_ | std::views::reverse)
    if (overlay && overlay->key(geometry, event)) return true;
  const Binding* measuring = meaningOf(Where::View, event, Gesture::Key, Over::Measuring);
  const Binding* editing = meaningOf(Where::View, event, Gesture::Key, Over::Editing);
  if (measuring == nullptr && editing == nullptr) return false;
  const QPointF global = view_.mapToGlobal(at);
  const QMouseEvent down(QEvent::MouseButtonPress, at, global, Qt::LeftButton, Qt::LeftButton,
                         Qt::NoModifier);
  const auto isMeant = [&](const Overlay& overlay) {
    for (const Binding* meaning : {measuring, editing})
      if (meaning != nullptr && meaning->action == overlay.keyForClick()) return true;
    return false;
  };
  dragged_.clear();
  for (const QPointer<Overlay>& overlay : overlays_ | std::views::reverse)
    if (!dragged_ && overlay && isMeant(*overlay) && overlay->press(geometry, down))
      dragged_ = overlay;
  if (!dragged_) return false;
  const QMouseEvent up(QEvent::MouseButtonRelease, at, global, Qt::LeftButton, Qt::NoButton,
                       Qt::NoModifier);
  return release(geometry, up);
}

bool OverlayStack::hasHandleIn(const ViewGeometry& geometry, const QRectF& part) const {
  for (const QPointer<Overlay>& overlay : overlays_)
    if (overlay)
      for (const QPointF& at : overlay->markHandlesIn(geometry))
        if (part.contains(at)) return true;
  return false;
}

QString OverlayStack::hint() const {
  for (const QPointer<Overlay>& overlay : overlays_ | std::views::reverse)
    if (const QString hint = overlay ? overlay->hint() : QString(); !hint.isEmpty()) return hint;
  return {};
}

QString OverlayStack::note() const {
  for (const QPointer<Overlay>& overlay : overlays_)
    if (const QString note = overlay ? overlay->note() : QString(); !note.isEmpty()) return note;
  return {};
}

}  // namespace ui
