// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/drop_area.h"

#include <QPainter>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {

DropArea::DropArea(QWidget* parent) : QWidget(parent) {
  setObjectName("dropArea");
  setAccessibleName(tr("Drop to open"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFont(style::font(style::Type::Figure));
  hide();
}

void DropArea::cover(const QWidget& part) {
  setGeometry(QRect(part.mapTo(parentWidget(), QPoint{}), part.size()));
  raise();
  show();
}

void DropArea::paintEvent(QPaintEvent*) {
  const style::Colours& c = style::colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(c.accent, 3.0));
  painter.drawRoundedRect(QRectF(rect()).adjusted(4.0, 4.0, -4.0, -4.0), style::kLargeCorner,
                          style::kLargeCorner);
  const QString words = tr("Let go to open");
  QRectF pill(0.0, 0.0, fontMetrics().horizontalAdvance(words) + 4.0 * style::kEdge,
              fontMetrics().height() + 2.0 * style::kEdge);
  pill.moveCenter(QRectF(rect()).center());
  painter.setPen(QPen(c.accent, 1.5));
  painter.setBrush(c.panel);
  painter.drawRoundedRect(pill, style::kLargeCorner, style::kLargeCorner);
  painter.setPen(c.text);
  painter.drawText(pill, Qt::AlignCenter, words);
}

}  // namespace ui
