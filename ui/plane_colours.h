// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>

#include "ui/props/slice.h"

namespace ui {

/// The colour of a plane: of its frame, its name, and the lines in which it meets other planes. Red
/// is for frame and line only; the stop button's red is its own.
inline QColor colourOf(Plane plane) {
  switch (plane) {
    case Plane::Axial:
      return {0xe0, 0x55, 0x5f};
    case Plane::Coronal:
      return {0x56, 0xb8, 0x70};
    case Plane::Sagittal:
      return {0xe0, 0xc1, 0x4a};
    case Plane::Oblique:
      break;
  }
  return {0xb0, 0x8c, 0xf0};
}

}  // namespace ui
