// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>

#include "ui/props/slice.h"
#include "ui/style/scene_colours.h"

namespace ui {

/// The colour of a plane: of its frame, its name, and the lines in which it meets other planes.
inline QColor colourOf(Plane plane) {
  switch (plane) {
    case Plane::Axial:
      return style::kAxial;
    case Plane::Coronal:
      return style::kCoronal;
    case Plane::Sagittal:
      return style::kSagittal;
    case Plane::Oblique:
      break;
  }
  return style::kOblique;
}

}  // namespace ui
