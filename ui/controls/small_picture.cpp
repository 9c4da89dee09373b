// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/small_picture.h"

#include <QCoreApplication>
#include <QPainter>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

/// The sign of what is not known, in the lower right corner of a square of `side` pixels.
void drawQuestion(QPainter& painter, int side) {
  const double size = 0.28 * side, inset = 0.04 * side;
  const QRectF disc(side - size - inset, side - size - inset, size, size);
  QFont font = style::font(style::Type::Body);
  font.setBold(true);
  font.setPixelSize(qRound(0.8 * size));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(style::colours().attention);
  painter.drawEllipse(disc);
  painter.setFont(font);
  painter.setPen(style::colours().panel);
  painter.drawText(disc, Qt::AlignCenter, QStringLiteral("?"));
}

}  // namespace

QPixmap squareOf(const SmallPicture& picture, int side, qreal scale, const QColor& ground) {
  const int pixels = qRound(side * scale);
  QPixmap square(pixels, pixels);
  square.fill(ground);
  if (!picture.image.isNull()) {
    const QImage fitting =
        picture.image.scaled(pixels, pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPainter painter(&square);
    painter.drawImage((pixels - fitting.width()) / 2, (pixels - fitting.height()) / 2, fitting);
    if (!picture.sides_known) drawQuestion(painter, pixels);
  }
  square.setDevicePixelRatio(scale);
  return square;
}

QString wordsOf(const SmallPicture& picture) {
  if (picture.image.isNull() || picture.sides_known) return {};
  return QCoreApplication::translate(
      "ui::SmallPicture",
      "The file does not state its orientation: the slice is shown as "
      "it is stored, and left and right are unknown.");
}

}  // namespace ui
