// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "haptics/scene/scene.h"
#include "ui/views/touched_surface.h"

namespace app {

/// The field's value half a voxel behind its surface at a place of W [m]: of what is touched there.
/// At the grid's edge that of the outermost voxels, behind which there is background.
double valueBehind(const haptics::ScalarField& field, haptics::Vec3 p_W);

/// The surface that a scene's servo touches, for the views. It keeps the scene alive.
ui::TouchedSurface touchedSurfaceOf(std::shared_ptr<const haptics::Scene> scene);

}  // namespace app
