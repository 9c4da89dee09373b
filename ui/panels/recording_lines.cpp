// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/recording_lines.h"

#include <QApplication>
#include <QFontMetrics>
#include <QPainter>
#include <QStyle>
#include <algorithm>
#include <cmath>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kCellRim = style::kStep;  // px around what is in a cell

void drawCurve(QPainter& painter, const QRect& place, const QList<float>& forces) {
  const float greatest = greatestOf(forces);
  const style::Colours& c = style::colours();
  painter.setFont(style::font(style::Type::Small));
  const int line = painter.fontMetrics().height();
  painter.setPen(c.dim);
  painter.drawText(place, Qt::AlignRight | Qt::AlignTop,
                   RecordingLines::tr("%L1 N").arg(static_cast<double>(greatest), 0, 'f', 1));
  const QRectF area = QRectF(place).adjusted(0.0, line, 0.0, -1.0);
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  if (!(greatest > 0.0F)) return;
  painter.setPen(Qt::NoPen);
  const double width = area.width() / static_cast<double>(forces.size());
  for (qsizetype i = 0; i < forces.size(); ++i) {
    if (!std::isfinite(forces[i])) continue;
    const double height = static_cast<double>(forces[i] / greatest) * area.height();
    painter.fillRect(
        QRectF(area.left() + static_cast<double>(i) * width, area.bottom() - height, width, height),
        c.solid);
  }
}

}  // namespace

float greatestOf(const QList<float>& forces) {
  float greatest = 0.0F;
  for (const float force : forces)
    if (std::isfinite(force)) greatest = std::max(greatest, force);
  return greatest;
}

QSize RecordingLines::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int height = kLines * QFontMetrics(option.font).lineSpacing() + 2 * kCellRim;
  return {index.column() == 0 ? 160 : kCurveWidth + 2 * kCellRim, height};
}

void RecordingLines::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  QStyleOptionViewItem line = option;
  initStyleOption(&line, index);
  const QWidget* widget = option.widget;
  const QStyle* look = widget != nullptr ? widget->style() : QApplication::style();
  line.text.clear();
  look->drawControl(QStyle::CE_ItemViewItem, &line, painter, widget);
  painter->save();
  const QRect place = option.rect.adjusted(kCellRim, kCellRim, -kCellRim, -kCellRim);
  const QVariant curve = index.data(kCurve);
  if (curve.isValid()) {
    drawCurve(*painter, place, curve.value<QList<float>>());
  } else {
    const QStringList words = index.data(Qt::DisplayRole).toString().split('\n');
    painter->setFont(option.font);
    const QFontMetrics metrics(option.font);
    for (qsizetype i = 0; i < words.size(); ++i) {
      painter->setPen(i == 0 ? style::colours().text : style::colours().dim);
      const QRect row(place.left(), place.top() + static_cast<int>(i) * metrics.lineSpacing(),
                      place.width(), metrics.lineSpacing());
      painter->drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                        metrics.elidedText(words[i], Qt::ElideMiddle, place.width()));
    }
  }
  painter->restore();
}

}  // namespace ui
