// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/touched_words.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace ui {

QString touchedWords(double value, const QString& unit) {
  const double size = std::abs(value);
  const double step = unit == QLatin1String("HU") ? 10.0
                      : size > 0.0 ? std::pow(10.0, std::floor(std::log10(size)) - 2.0)
                                   : 1.0;
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step))));
  const QString number = QLocale().toString(std::round(value / step) * step, 'f', decimals);
  return unit.isEmpty() ? number : number + ' ' + unit;
}

}  // namespace ui
