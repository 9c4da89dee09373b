// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <cmath>

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

// How measures are drawn: light on a dark rim, which is seen on bone and on air.

inline void drawLine(QPainter& painter, const QPolygonF& line, const QColor& ink, double width,
                     bool dashed) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style::kMeasureRim, width + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  QPen pen(ink, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (dashed) pen.setDashPattern({4.0, 3.5});
  painter.setPen(pen);
  painter.drawPolyline(line);
}

inline void drawLabel(QPainter& painter, const QRectF& box, const QString& text) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(style::kMeasureGround);
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.setPen(style::kChosenMeasure);
  painter.drawText(box, Qt::AlignCenter, text);
}

/// Of a text with the border of its label.
inline QSizeF labelSize(const QFont& font, const QString& text) {
  const QSizeF size = QFontMetricsF(font).size(0, text);
  return {std::ceil(size.width()) + 10.0, std::ceil(size.height()) + 4.0};
}

}  // namespace ui
