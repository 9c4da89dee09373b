// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "haptics/scene/scene.h"
#include "ui/views/touched_surface.h"

namespace app {

/// The surface that a scene's servo touches, for the views. It keeps the scene alive.
ui::TouchedSurface touchedSurfaceOf(std::shared_ptr<const haptics::Scene> scene);

}  // namespace app
