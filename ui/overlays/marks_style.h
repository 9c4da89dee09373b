// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QMouseEvent>
#include <QPainter>

#include "ui/style/scene_colours.h"

namespace ui {

// How the tools of the Edit panel are drawn.
inline constexpr double kHandleRadius = 5.5;  // pixels
inline constexpr double kHandleReach = 10.0;  // pixels from the middle of a handle
inline constexpr double kHandleRoom = 8.0;    // pixels from its middle to the border of the view

inline bool isPlainLeft(const QMouseEvent& event) {
  return event.button() == Qt::LeftButton && event.modifiers() == Qt::NoModifier;
}

inline bool isNear(QPointF a, QPointF b) {
  const QPointF by = a - b;
  return QPointF::dotProduct(by, by) <= kHandleReach * kHandleReach;
}

inline void drawHandle(QPainter& painter, QPointF at, QColor colour, bool held) {
  painter.setPen(QPen(style::kHandleRim, 1.5));
  painter.setBrush(held ? style::kHeldHandle : colour);
  painter.drawEllipse(at, kHandleRadius, kHandleRadius);
}

}  // namespace ui
