// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QString>
#include <array>
#include <limits>

namespace ui {

/// Usual ranges in HU, of which partial volumes and contrast agents know nothing.
struct TissueBand {
  const char* name;
  double from, to;  // HU
};
inline constexpr std::array<TissueBand, 4> kTissueBands{{
    {QT_TRANSLATE_NOOP("ui::TissueBand", "air"), -std::numeric_limits<double>::infinity(), -500.0},
    {QT_TRANSLATE_NOOP("ui::TissueBand", "fat"), -150.0, -30.0},
    {QT_TRANSLATE_NOOP("ui::TissueBand", "soft tissue"), 0.0, 100.0},
    {QT_TRANSLATE_NOOP("ui::TissueBand", "bone"), 300.0, std::numeric_limits<double>::infinity()},
}};

inline QString nameOf(const TissueBand& band) {
  return QCoreApplication::translate("ui::TissueBand", band.name);
}

/// The tissue that usually has this value; empty between the bands.
inline QString tissueAt(double hu) {
  for (const TissueBand& band : kTissueBands)
    if (hu >= band.from && hu <= band.to) return nameOf(band);
  return {};
}

}  // namespace ui
