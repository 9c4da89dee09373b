// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/film/camera.h"

namespace ui {
class VolumeView;
}

namespace app {

/// The present camera of the 3-D view.
FilmCamera cameraOf(ui::VolumeView& view);

}  // namespace app
