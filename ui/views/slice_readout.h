// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QLineF>
#include <QLocale>
#include <QPainter>
#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"

namespace ui {

/// What is written about a slice, on the margin around its picture.
struct SliceReadout {
  QString name = {};        ///< of the plane, in its colour
  QString short_name = {};  ///< where that leaves no room for numbers
  QColor colour = {};
  QString place = {};                   ///< slice number, position
  QString slab = {};                    ///< empty: one plane
  QString grey = {};                    ///< level and width
  QString value = {};                   ///< under the pointer
  QString structures = {};              ///< under the pointer: names
  QString position = {};                ///< under the pointer
  std::array<QString, 4> letters = {};  ///< left, right, upper and lower edge; empty: unknown
  bool sides_known = true;              ///< false: a line says that left and right are unknown
  QString note = {};                    ///< in pictures that are saved alone
};

/// One text of it, and where it stands in the widget.
struct ReadoutText {
  QRect box;
  QString text;
  QColor colour;
  int pixels = 0;
  bool bold = false;
};

/// Where everything stands. No two boxes meet, and none meets the picture.
struct ReadoutLayout {
  std::vector<ReadoutText> texts = {};
  std::optional<QLineF> ruler = {};
};

/// The picture of a slice in its widget: what the margin leaves.
QRect pictureIn(QRect widget, bool oblique);

/// Lays out what is said. `buttons`: px at the right of the upper edge that buttons cover. What
/// does not fit is left out, the position under the pointer first, the letters never; names of
/// structures are cut.
ReadoutLayout layOut(const SliceReadout& readout, const QFont& font, QRect widget, QRect picture,
                     int buttons, double mm_per_pixel);

void drawReadout(QPainter& painter, const ReadoutLayout& layout);

/// The length of a ruler in the unit that the user chose: "20 mm", "0.5 cm".
QString rulerWords(double mm);

/// The user's locale, without separators between thousands.
QLocale readoutLocale();

/// Rounded as the voxels' type allows, with the unit: "312 HU".
QString intensityWords(double value, const haptics::Volume& volume);

/// The length of a ruler: 1, 2 or 5 times a power of ten, at most `longest_mm`.
double rulerLength_mm(double longest_mm);

/// A place in the file's coordinates, in the unit that the user chose: "LPS 12.3, -4.0, 34.5 mm",
/// or "scan 12.3, -4.0, 34.5 mm" where the sides are not known. The origin is the file's, so a sign
/// does not tell the patient's side.
QString positionWords(const Eigen::Vector3d& p_W_mm, bool sides_known);
/// One coordinate of it, without the unit: "z 34.5".
QString positionWords(const Eigen::Vector3d& p_W_mm, int axis);

}  // namespace ui
