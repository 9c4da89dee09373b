// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/view_gap.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/controls/bindings.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr int kKeyStep = 16;  // px

}  // namespace

ViewGap::ViewGap(QWidget* parent) : QWidget(parent) {
  offerSpoken();
  setObjectName("viewGap");
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(tr("Border between views"));
  whenKeysChange(*this, [this] {
    setToolTip(tr("Drag, or move with the arrow keys. %1 or a double-click: first sizes")
                   .arg(keyOf(Action::FirstSizes)));
  });
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
  const Binding* meaning = meaningOf(Where::Border, *event);
  if (meaning != nullptr && meaning->action == Action::FirstSizes) return emit resetWanted();
  const QPoint way = meaning == nullptr ? QPoint{} : wayOf(*meaning);
  const int along = upright_ ? way.x() : way.y();
  if (along != 0) return emit moved(along * kKeyStep);
  QWidget::keyPressEvent(event);
}

}  // namespace ui
