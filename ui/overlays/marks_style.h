// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QMouseEvent>
#include <QPainter>

namespace ui {

// How the tools of the Edit panel are drawn: outlines and handles in one colour, what goes in
// another. Red is that of the stop button alone.
inline constexpr QColor kOutlineColour{77, 163, 255};
inline constexpr QColor kGoesColour{224, 166, 58};
inline constexpr double kHandleRadius = 5.5;  // pixels
inline constexpr double kHandleReach = 10.0;  // pixels from the middle of a handle

inline bool isPlainLeft(const QMouseEvent& event) {
  return event.button() == Qt::LeftButton && event.modifiers() == Qt::NoModifier;
}

inline bool isNear(QPointF a, QPointF b) {
  const QPointF by = a - b;
  return QPointF::dotProduct(by, by) <= kHandleReach * kHandleReach;
}

inline void drawHandle(QPainter& painter, QPointF at, QColor colour, bool held) {
  painter.setPen(QPen(QColor(12, 13, 17), 1.5));
  painter.setBrush(held ? QColor(Qt::white) : colour);
  painter.drawEllipse(at, kHandleRadius, kHandleRadius);
}

}  // namespace ui
