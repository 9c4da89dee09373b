// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QWidget;

namespace ui {

/// Lets Tab go through two parts of a window as they are laid out: the first, then the last, in
/// each from left to right and down. Qt's own order is that in which widgets were made. GUI thread.
void orderTabs(QWidget& first_part, QWidget& last_part);

}  // namespace ui
