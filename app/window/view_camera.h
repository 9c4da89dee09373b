// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/film/camera.h"

namespace ui {
class VolumeView;
}

namespace app {

/// Where the user looks from now.
FilmCamera cameraOf(ui::VolumeView& view);

}  // namespace app
