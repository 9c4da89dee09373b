// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/state_chip.h"

#include <QPainter>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kSide = 12, kMarkSide = 11, kBetween = 8;

void drawMark(QPainter& painter, Mark mark, const QRectF& at) {
  const style::Colours& c = style::colours();
  const auto line = [&](const QColor& colour) {
    painter.setPen(QPen(colour, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
  };
  const auto fill = [&](const QColor& colour) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
  };
  const QRectF thin = at.adjusted(1.0, 1.0, -1.0, -1.0);
  const QPointF middle = at.center();
  switch (mark) {
    case Mark::None:
      break;
    case Mark::On:
      fill(c.on);
      painter.drawEllipse(at);
      break;
    case Mark::Rising:
      line(c.on);
      painter.drawEllipse(thin);
      fill(c.on);
      painter.drawPie(at, 180 * 16, 180 * 16);
      break;
    case Mark::Held:
      line(c.attention);
      for (const double x : {at.left() + 3.0, at.right() - 3.0})
        painter.drawLine(QPointF{x, at.top() + 1.5}, QPointF{x, at.bottom() - 1.5});
      break;
    case Mark::Ready:
      line(c.accent);
      painter.drawEllipse(thin);
      break;
    case Mark::Off:
      line(c.dim);
      painter.drawLine(QPointF{at.left() + 1.0, middle.y()}, QPointF{at.right() - 1.0, middle.y()});
      break;
    case Mark::Fault:
      line(c.stop_words);
      painter.drawPolygon(
          QPolygonF({{middle.x(), thin.top()}, thin.bottomRight(), thin.bottomLeft()}));
      break;
    case Mark::Shown:
      line(c.accent);
      painter.drawPolygon(QPolygonF({{middle.x(), at.top()},
                                     {at.right(), middle.y()},
                                     {middle.x(), at.bottom()},
                                     {at.left(), middle.y()}}));
      break;
    case Mark::Replay:
      fill(c.accent);
      painter.drawPolygon(QPolygonF(
          {{at.left() + 2.0, at.top()}, {at.right(), middle.y()}, {at.left() + 2.0, at.bottom()}}));
      break;
    case Mark::Recording:
      line(c.attention);
      painter.drawEllipse(thin);
      fill(c.attention);
      painter.drawEllipse(middle, 2.6, 2.6);
      break;
  }
}

}  // namespace

StateChip::StateChip(QWidget* parent) : QLabel(parent) {
  offerSpoken();
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void StateChip::show(Mark mark, const QString& words) {
  if (mark == mark_ && words == text()) return;
  // the time of a recording runs on without being said
  const bool said = mark == mark_ && (words == text() || mark == Mark::Recording);
  mark_ = mark;
  setText(words);
  updateGeometry();
  update();
  if (!said) tellSpokenName(*this);
}

QString StateChip::spokenName() const {
  return accessibleName().isEmpty() ? text() : tr("%1: %2").arg(accessibleName(), text());
}

void StateChip::setDetail(const QString& detail) {
  if (detail == detail_) return;
  detail_ = detail;
  updateGeometry();
  update();
}

QSize StateChip::minimumSizeHint() const {
  return {2 * kSide + kMarkSide + kBetween + fontMetrics().horizontalAdvance(text()) + 2,
          style::kControlHeight};
}

QSize StateChip::sizeHint() const {
  const QSize least = minimumSizeHint();
  // no hand holds what is replayed
  if (detail_.isEmpty() || mark_ == Mark::Replay) return least;
  return {least.width() + kSide + fontMetrics().horizontalAdvance(detail_) + 2, least.height()};
}

void StateChip::paintEvent(QPaintEvent*) {
  const style::Colours& c = style::colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(c.line);
  painter.setBrush(c.control);
  const QRectF pill = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.drawRoundedRect(pill, 0.5 * pill.height(), 0.5 * pill.height());
  const int top = (height() - kMarkSide) / 2;
  drawMark(painter, mark_, QRectF(kSide, top, kMarkSide, kMarkSide));
  QRect room = rect().adjusted(kSide + kMarkSide + kBetween, 0, -kSide, 0);
  painter.setPen(c.text);
  QRect used;
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                   fontMetrics().elidedText(text(), Qt::ElideRight, room.width()), &used);
  room.setLeft(used.right() + kSide);
  if (detail_.isEmpty() || mark_ == Mark::Replay || room.width() < 3 * kSide) return;
  painter.setPen(c.dim);
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                   fontMetrics().elidedText(detail_, Qt::ElideRight, room.width()));
}

}  // namespace ui
