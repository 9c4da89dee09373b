// SPDX-License-Identifier: BSD-3-Clause
#include "ui/grey_presets.h"

#include <QCoreApplication>
#include <algorithm>

namespace ui {

std::vector<GreyPreset> hounsfieldPresets() {
  const auto words = [](const char* name) {
    return QCoreApplication::translate("ui::GreyPreset", name);
  };
  return {{words("Bone"), {.level = 500.0, .width = 2000.0}},
          {words("Temporal bone"), {.level = 700.0, .width = 4000.0}},
          {words("Soft tissue"), {.level = 40.0, .width = 400.0}},
          {words("Lung"), {.level = -600.0, .width = 1500.0}},
          {words("Brain"), {.level = 40.0, .width = 80.0}}};
}

GreyWindow fullRange(const haptics::Volume& volume) {
  return {.level = 0.5 * (volume.least + volume.greatest),
          .width = std::max(volume.greatest - volume.least, 1e-6)};
}

GreyWindow firstGrey(const haptics::Volume& volume) {
  return volume.unit == "HU" ? GreyWindow{.level = 200.0, .width = 1600.0} : fullRange(volume);
}

}  // namespace ui
