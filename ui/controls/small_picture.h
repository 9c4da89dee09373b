// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QImage>
#include <QPixmap>
#include <QString>

namespace ui {

/// A small picture of a scan: one of its slices, by the convention of the views of slices.
struct SmallPicture {
  QImage image = {};  ///< null: none can be drawn
  bool sides_known =
      true;  ///< false: the file does not say how it lies, and the image is as stored
};

/// The picture in the middle of a square, so that all are of one size; of a null image the ground
/// alone. Where the sides are not known, a "?" stands in a corner.
/// @param side px of a widget
/// @param scale of the widget's screen
QPixmap squareOf(const SmallPicture& picture, int side, qreal scale, const QColor& ground);

/// What the "?" means, as a sentence; empty where there is none.
QString wordsOf(const SmallPicture& picture);

}  // namespace ui
