// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

namespace ui {

/// Words that wrap, plain; a long word does not widen the panel.
QLabel* hintLabel(const QString& words = {});

}  // namespace ui
