// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <vector>

#include "haptics/core/volume.h"
#include "ui/props/slice.h"

namespace ui {

/// A grey window that has a name.
struct GreyPreset {
  QString name;
  GreyWindow grey;
};

/// The usual windows for CT, in HU: soft tissue, bone, lung, brain, mediastinum, temporal bone.
std::vector<GreyPreset> hounsfieldPresets();

/// From the least voxel to the greatest.
GreyWindow fullRange(const haptics::Volume& volume);

/// The window with which a volume is first shown, and to which a reset goes back: the first of
/// those that its file states; without one, bone and soft tissue in one picture where the unit is
/// HU, else the full range.
GreyWindow firstGrey(const haptics::Volume& volume, const std::vector<GreyPreset>& stated = {});

/// What the menu says of a window that a file states, by the name that the file gives it.
QString wordsOfStated(const GreyPreset& stated);

}  // namespace ui
