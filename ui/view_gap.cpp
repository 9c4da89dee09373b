// SPDX-License-Identifier: BSD-3-Clause
#include "ui/view_gap.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr int kKeyStep = 16;  // px

}  // namespace

ViewGap::ViewGap(QWidget* parent) : QWidget(parent) {
  setObjectName("viewGap");
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(tr("Border between views"));
  setToolTip(tr("Drag, or move with the arrow keys. Home or a double-click: first sizes"));
}

void ViewGap::setUpright(bool upright) {
  upright_ = upright;
  setCursor(upright ? Qt::SplitHCursor : Qt::SplitVCursor);
}

void ViewGap::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(rect(), hasFocus() ? style::kViewFocus : style::kBetweenViews);
}

void ViewGap::mousePressEvent(QMouseEvent* event) { pressed_ = event->position().toPoint(); }

void ViewGap::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  const QPoint by = event->position().toPoint() - pressed_;
  emit moved(upright_ ? by.x() : by.y());
}

void ViewGap::mouseDoubleClickEvent(QMouseEvent*) { emit resetWanted(); }

void ViewGap::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Home) return emit resetWanted();
  if (key == (upright_ ? Qt::Key_Left : Qt::Key_Up)) return emit moved(-kKeyStep);
  if (key == (upright_ ? Qt::Key_Right : Qt::Key_Down)) return emit moved(kKeyStep);
  QWidget::keyPressEvent(event);
}

}  // namespace ui
