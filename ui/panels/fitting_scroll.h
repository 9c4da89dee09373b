// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

namespace ui {

/// Scrolls panels up and down where the window is lower than they are. It is never narrower than
/// what is in it.
class FittingScroll : public QScrollArea {
 public:
  explicit FittingScroll(QWidget* inside) {
    setWidget(inside);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);  // it follows the control that has the focus
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  }
  QSize minimumSizeHint() const override {
    return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
            QScrollArea::minimumSizeHint().height()};
  }

 protected:
  bool eventFilter(QObject* of, QEvent* event) override {
    // what is in it became wider
    if (of == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(of, event);
  }
};

}  // namespace ui
