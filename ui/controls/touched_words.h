// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace ui {

/// The intensity of what is touched or pointed at, with its unit. No steadier than the hand is: to
/// 10 HU, or to three digits.
QString touchedWords(double value, const QString& unit);

}  // namespace ui
