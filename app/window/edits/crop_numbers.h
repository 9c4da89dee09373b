// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "haptics/core/volume.h"
#include "ui/panels/edit_panel.h"

namespace ui {
class Views;
}

namespace app {

/// Whether the numbers of a crop count along the patient's axes: the grid lies along them, and the
/// file tells how the patient lies. Else they count along the grid's own axes from its first voxel.
bool cropsAlongPatient(const haptics::Volume& volume);

/// A box of voxels in the panel's numbers, for each axis of the grid.
std::array<ui::CropRange, 3> cropRangesOf(const haptics::Volume& volume,
                                          const haptics::VoxelBox& box);

/// The same box with one face where the number says: the face of the higher or the lower number on
/// that axis of the grid. At least one voxel stays.
haptics::VoxelBox withFace(const haptics::Volume& volume, haptics::VoxelBox box, int axis,
                           bool high, double mm);

/// The box that all slices on view show; none: no slice is on view.
std::optional<haptics::VoxelBox> boxInSlices(ui::Views& views, const haptics::Grid& grid);

}  // namespace app
