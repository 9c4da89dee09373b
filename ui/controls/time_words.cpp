// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/time_words.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace ui {

QString clockTime(double seconds, int decimals) {
  constexpr double kLongest = 1e9;  // s: 30 years
  if (!std::isfinite(seconds)) return QStringLiteral("–");
  qint64 parts = 1;
  for (int i = 0; i < decimals; ++i) parts *= 10;
  // rounded as a whole, so that no 0:60.0 comes out
  const qint64 all = std::llround(std::clamp(seconds, 0.0, kLongest) * static_cast<double>(parts));
  const qint64 whole = all / parts;
  const QString text =
      QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
  if (decimals == 0) return text;
  return text + QLocale().decimalPoint() +
         QStringLiteral("%1").arg(all % parts, decimals, 10, QLatin1Char('0'));
}

}  // namespace ui
