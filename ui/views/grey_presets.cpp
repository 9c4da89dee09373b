// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/grey_presets.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/views/slice_readout.h"

namespace ui {

std::vector<GreyPreset> hounsfieldPresets() {
  const auto words = [](const char* name) {
    return QCoreApplication::translate("ui::GreyPreset", name);
  };
  return {{words("Soft tissue"), {.level = 40.0, .width = 400.0}},
          {words("Bone"), {.level = 500.0, .width = 2000.0}},
          {words("Lung"), {.level = -600.0, .width = 1500.0}},
          {words("Brain"), {.level = 40.0, .width = 80.0}},
          {words("Mediastinum"), {.level = 50.0, .width = 350.0}},
          {words("Temporal bone"), {.level = 700.0, .width = 4000.0}}};
}

GreyWindow fullRange(const haptics::Volume& volume) {
  return {.level = 0.5 * (volume.least + volume.greatest),
          .width = std::max(volume.greatest - volume.least, 1e-6)};
}

GreyWindow firstGrey(const haptics::Volume& volume, const std::vector<GreyPreset>& stated) {
  if (!stated.empty()) return stated.front().grey;
  return volume.unit == "HU" ? GreyWindow{.level = 200.0, .width = 1600.0} : fullRange(volume);
}

QString wordsOfStated(const GreyPreset& stated) {
  constexpr int kMostLetters = 40;
  const auto number = [](double value) { return readoutLocale().toString(value, 'g', 6); };
  const QString width = number(stated.grey.width), level = number(stated.grey.level);
  const QString name = stated.name.simplified().left(kMostLetters).replace('&', "&&");
  return name.isEmpty()
             ? QCoreApplication::translate("ui::GreyPreset", "As in the file (W %1, L %2)")
                   .arg(width, level)
             : QCoreApplication::translate("ui::GreyPreset", "As in the file: %1 (W %2, L %3)")
                   .arg(name, width, level);
}

}  // namespace ui
