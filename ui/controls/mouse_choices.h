// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/controls/bindings.h"

namespace ui {

/// How the user wants the mouse.
struct MouseChoices {
  /// What it does in the 3-D view when it becomes the hand.
  MouseMode at_first = MouseMode::Look;
  bool slices_reversed = false;  ///< the wheel away from the user: the slice before
  bool zoom_reversed = false;    ///< the wheel away from the user: farther
  bool operator==(const MouseChoices&) const = default;
};

}  // namespace ui
