// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QLocale>
#include <QPainter>
#include <QString>
#include <array>

#include "haptics/core/geometry.h"

namespace ui {

/// What is written about a slice: in the picture's corners, and on the margin around it.
struct SliceReadout {
  QString name = {};  ///< of the plane, in its colour
  QColor colour = {};
  QString place = {};                   ///< below the name: slice number, position
  QString slab = {};                    ///< below the place; empty: one plane
  QString grey = {};                    ///< lower left
  QString value = {};                   ///< lower right
  QString position = {};                ///< above the value
  std::array<QString, 4> letters = {};  ///< left, right, upper and lower edge; empty: unknown
  bool sides_known = true;              ///< false: a line says that left and right are unknown
};

/// Draws it around and over the picture. Letters stand on the margin, never on the picture.
void drawReadout(QPainter& painter, const SliceReadout& readout, QRect widget, QRect picture);

/// Draws the ruler with its length at the right side of the picture.
void drawRuler(QPainter& painter, double mm_per_pixel, QRect picture);

/// Its length in the unit that the user chose: "20 mm", "0.5 cm".
QString rulerWords(double mm);

/// The user's locale, without separators between thousands.
QLocale readoutLocale();

/// The length of a ruler: 1, 2 or 5 times a power of ten, at most `longest_mm`.
double rulerLength_mm(double longest_mm);

/// A place in patient coordinates, in the unit that the user chose: "L 12.3 P 4.0 S 34.5 mm", or
/// "x 12.3 y 4.0 z 34.5 mm" where the sides are not known.
QString positionWords(const Eigen::Vector3d& p_W_mm, bool sides_known);
/// One coordinate of it, without the unit.
QString positionWords(const Eigen::Vector3d& p_W_mm, int axis, bool sides_known);

}  // namespace ui
