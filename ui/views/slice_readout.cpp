// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/slice_readout.h"

#include <QCoreApplication>
#include <cmath>

#include "ui/controls/lengths.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr int kTextPixels = 11, kLetterPixels = 17, kLettersPixels = 12;

QString sliceWords(const char* text) { return QCoreApplication::translate("ui::SliceView", text); }

QString placeWords(double mm) {
  return readoutLocale().toString(mm / mmPerLengthUnit(), 'f', lengthDecimals(1));
}

/// Text with a dark rim, so that it can be read on any anatomy.
void drawOver(QPainter& painter, QRect box, int flags, const QString& text, const QColor& colour) {
  painter.setPen(style::kRim);
  for (const int x : {-1, 0, 1})
    for (const int y : {-1, 0, 1})
      if (x != 0 || y != 0) painter.drawText(box.translated(x, y), flags, text);
  painter.setPen(colour);
  painter.drawText(box, flags, text);
}

}  // namespace

QLocale readoutLocale() {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

double rulerLength_mm(double longest_mm) {
  const double decade = std::pow(10.0, std::floor(std::log10(longest_mm)));
  for (const double times : {5.0, 2.0})
    if (times * decade <= longest_mm) return times * decade;
  return decade;
}

QString positionWords(const Eigen::Vector3d& p_W_mm, int axis, bool sides_known) {
  static constexpr std::array<const char*, 3> kUp{"L", "P", "S"}, kDown{"R", "A", "I"},
      kAxis{"x", "y", "z"};
  const auto a = static_cast<std::size_t>(axis);
  const double mm = p_W_mm[axis];
  if (!sides_known) return QStringLiteral("%1 %2").arg(kAxis[a], placeWords(mm));
  return QStringLiteral("%1 %2").arg(mm >= 0.0 ? kUp[a] : kDown[a], placeWords(std::abs(mm)));
}

QString positionWords(const Eigen::Vector3d& p_W_mm, bool sides_known) {
  QStringList parts;
  for (int a = 0; a < 3; ++a) parts << positionWords(p_W_mm, a, sides_known);
  return parts.join(QStringLiteral("  ")) + ' ' + lengthUnitName();
}

QString rulerWords(double mm) {
  const double shown = mm / mmPerLengthUnit();
  const int decimals = shown < 0.0095 ? 3 : shown < 0.095 ? 2 : shown < 0.95 ? 1 : 0;
  return readoutLocale().toString(shown, 'f', decimals) + ' ' + lengthUnitName();
}

void drawRuler(QPainter& painter, double mm_per_pixel, QRect picture) {
  QFont font = painter.font();
  font.setPixelSize(kTextPixels);
  painter.setFont(font);
  const double mm = rulerLength_mm(0.3 * picture.height() * mm_per_pixel);
  const int length = qRound(mm / mm_per_pixel);
  if (length < 12) return;
  const int x = picture.right() - 8, middle = picture.center().y() + 12;
  const int top = middle - length / 2, bottom = top + length;
  for (const bool rim : {true, false}) {
    painter.setPen(QPen(rim ? style::kRim : style::kReadout, rim ? 3.0 : 1.0));
    painter.drawLine(x, top, x, bottom);
    painter.drawLine(x - 4, top, x, top);
    painter.drawLine(x - 4, bottom, x, bottom);
  }
  drawOver(painter, QRect(x - 90, middle - 10, 82, 20), Qt::AlignRight | Qt::AlignVCenter,
           rulerWords(mm), style::kReadout);
}

void drawReadout(QPainter& painter, const SliceReadout& readout, QRect widget, QRect picture) {
  QFont font = painter.font();
  font.setPixelSize(kTextPixels);
  QFont bold = font;
  bold.setBold(true);
  painter.setFont(font);
  const int line = painter.fontMetrics().height();
  const QRect inner = picture.adjusted(5, 3, -5, -3);

  painter.setFont(bold);
  drawOver(painter, inner, Qt::AlignLeft | Qt::AlignTop, readout.name, readout.colour);
  painter.setFont(font);
  drawOver(painter, inner.adjusted(0, line, 0, 0), Qt::AlignLeft | Qt::AlignTop, readout.place,
           style::kReadout);
  drawOver(painter, inner.adjusted(0, 2 * line, 0, 0), Qt::AlignLeft | Qt::AlignTop, readout.slab,
           style::kReadout);
  drawOver(painter, inner, Qt::AlignLeft | Qt::AlignBottom, readout.grey, style::kReadout);
  drawOver(painter, inner, Qt::AlignRight | Qt::AlignBottom, readout.value, style::kReadout);
  drawOver(painter, inner.adjusted(0, 0, 0, -line), Qt::AlignRight | Qt::AlignBottom,
           readout.position, style::kReadout);

  if (!readout.sides_known) {
    painter.setPen(style::kViewAttention);
    painter.drawText(QRect(widget.left(), widget.top(), widget.width(), picture.top()),
                     Qt::AlignCenter, sliceWords("left/right unknown"));
    return;
  }
  painter.setPen(style::kLetter);
  const int right = picture.right() + 1, bottom = picture.bottom() + 1;
  const std::array<QRect, 4> margins{
      QRect(0, picture.top(), picture.left(), picture.height()),
      QRect(right, picture.top(), widget.width() - right, picture.height()),
      QRect(picture.left(), 0, picture.width(), picture.top()),
      QRect(picture.left(), bottom, picture.width(), widget.height() - bottom)};
  for (std::size_t i = 0; i < margins.size(); ++i) {
    // three letters are no wider than the margin
    bold.setPixelSize(readout.letters[i].size() > 1 ? kLettersPixels : kLetterPixels);
    painter.setFont(bold);
    painter.drawText(margins[i], Qt::AlignCenter, readout.letters[i]);
  }
}

}  // namespace ui
