// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

class QWidget;

namespace ui {

/// What Tab stops at in a part of a window, as it is laid out: from left to right and down. Hidden
/// and disabled widgets are among them. GUI thread.
std::vector<QWidget*> tabStopsOf(QWidget& part);

/// The stop after that which has the focus, or before it; from the last on to the first. Null:
/// there is none that can have it.
QWidget* nextTabStop(const std::vector<QWidget*>& stops, bool forwards);

}  // namespace ui
